// Every sentence that a student reads, in the lectures' languages, in one place.
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace shadowlab::lab {

enum class Language { english, catalan, spanish, french };

/// Of "en", "ca", "es", "fr". Throws InputError for another.
Language language_named(std::string_view code);
std::string_view code_of(Language language);

/// In the order of the table in sentences.cpp.
enum class Say {
  right,
  picture_differs,   // pixels, allowed
  stencil_differs,   // pixels, allowed, pass
  depth_differs,     // pixels, allowed, pass
  first_departure,   // pass, buffer, pixels, region, place
  after_the_passes,  // pixels, region, place
  pass_missing,      // pass
  state_differs,     // pass, state, yours, expected
  mended,
  not_mended,
  recipe_fails,  // sentence
  not_drawn,
  hidden_case,
  draw_it,  // command
  // buffers
  color,
  stencil,
  depth,
  // regions
  in_shadow,
  in_light,
  at_edges,
  beyond_surfaces,
  // places
  top_left,
  top,
  top_right,
  left,
  middle,
  right_side,
  bottom_left,
  bottom,
  bottom_right,
  everywhere,
  // states
  depth_test,
  stencil_test,
  blending,
  culling,
  offset_switch,
  depth_function,
  depth_writing,
  color_mask,
  stencil_function,
  stencil_operation,
  stencil_mask,
  culled_face,
  winding,
  blend_function,
  blend_equation,
  polygon_offset,
  viewport,
  scissor_box,
  the_uniform,
  the_call,  // function
  unset,
  switched_on,
  switched_off,
  // the report
  score,
  expected,
  yours,
  difference,
  passes,
  submissions,
  cases,
  points,
  hidden,
  failed,
  error,
  printed,
  most_failed_cases,
  most_frequent_mistakes,
  near_duplicates,
  none,
  count
};

std::string_view text(Language language, Say what);

template <class... Arguments>
std::string say(Language language, Say what, const Arguments&... arguments) {
  return fmt::format(fmt::runtime(text(language, what)), arguments...);
}

}  // namespace shadowlab::lab
