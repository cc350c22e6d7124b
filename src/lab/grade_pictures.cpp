#include "lab/grade_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "image/buffer_pictures.h"
#include "image/heat_map.h"

namespace shadowlab::lab {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, image::Image picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  image::write_png(file, picture);
}

bool has_stencil(const Buffers& buffers) {
  return std::any_of(buffers.stencil.begin(), buffers.stencil.end(),
                     [](std::uint8_t value) { return value != 0; });
}

image::Image stencil_of(const Buffers& buffers) {
  image::Image picture(buffers.color.width, buffers.color.height);
  if (buffers.stencil.size() * 4 != picture.rgba.size()) return picture;
  for (std::size_t i = 0; i < buffers.stencil.size(); ++i) {
    const auto color = image::stencil_color(buffers.stencil[i]);
    std::copy(color.begin(), color.end(),
              picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * i));
  }
  return picture;
}

std::string yours_name(std::size_t index, const std::string& what) {
  return fmt::format("case-{}-{}.png", index + 1, what);
}

}  // namespace

std::string expected_name(std::size_t index) { return yours_name(index, "expected"); }

std::string expected_pass_name(std::size_t index, std::size_t pass, const char* buffer) {
  return yours_name(index, fmt::format("pass-{}-{}", pass + 1, buffer));
}

void write_expected(const Lab& lab, const Reference& reference, const fs::path& folder,
                    Hidden hidden) {
  fs::create_directories(folder);
  for (std::size_t i = 0; i < lab.cases.size(); ++i) {
    if (lab.cases[i].hidden && hidden == Hidden::left_out) continue;
    const Drawing& drawing = reference.cases[i].drawing();
    write(folder / expected_name(i), drawing.frame.color);
    for (std::size_t p = 0; p < drawing.passes.size(); ++p) {
      write(folder / expected_pass_name(i, p, "color"), drawing.passes[p].color);
      if (has_stencil(drawing.passes[p]))
        write(folder / expected_pass_name(i, p, "stencil"), stencil_of(drawing.passes[p]));
    }
  }
}

void write_case_pictures(CaseResult& one, std::size_t index, const ReferenceCase& reference,
                         const Drawing& drawing, const fs::path& folder, Passes passes) {
  const auto put = [&](const std::string& what, const image::Image& picture) {
    if (picture.width == 0) return;
    one.pictures[what] = yours_name(index, what);
    write(folder / one.pictures[what], picture);
  };
  put("yours", drawing.frame.color);
  const image::Image& expected = reference.drawing().frame.color;
  if (drawing.frame.color.width == expected.width && drawing.frame.color.height == expected.height)
    put("difference", image::heat_map(expected, drawing.frame.color, color_tolerance));
  if (passes == Passes::left_out) return;
  for (std::size_t p = 0; p < std::min<std::size_t>(drawing.passes.size(), 16); ++p) {
    put(fmt::format("pass-{}-color", p + 1), drawing.passes[p].color);
    if (has_stencil(drawing.passes[p]))
      put(fmt::format("pass-{}-stencil", p + 1), stencil_of(drawing.passes[p]));
  }
}

}  // namespace shadowlab::lab
