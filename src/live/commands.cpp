#include "live/commands.h"

#include <algorithm>
#include <cmath>

namespace shadowlab::live {
namespace {

using context::Key;
using context::Modifiers;

constexpr Modifiers plain{}, shift{true, false, false}, control{false, true, false},
    alt{false, false, true}, control_shift{true, true, false};
constexpr double turn = 5;           // degrees
constexpr double approach = 1.1;     // times the distance
constexpr double light_step = 0.03;  // of the camera's distance

template <int Across, int Over>
void orbit(Studio& studio, View&) {
  if (const auto camera = studio.camera())
    studio.set_camera(orbited(*camera, turn * Across, turn * Over));
}

template <bool Nearer>
void go(Studio& studio, View&) {
  if (const auto camera = studio.camera())
    studio.set_camera(approached(*camera, Nearer ? 1 / approach : approach));
}

// To the camera's right, up, and toward it.
template <int Right, int Up, int Near>
void move_light(Studio& studio, View&) {
  const auto camera = studio.camera();
  const auto light = studio.light();
  if (!camera || !light) return;
  const glm::dvec3 arm = camera->eye - camera->target;
  const glm::dvec3 back = glm::normalize(arm), right = glm::normalize(glm::cross(camera->up, back));
  const glm::dvec3 step =
      right * double(Right) + glm::cross(back, right) * double(Up) + back * double(Near);
  const glm::dvec3 handle = light_handle(*light, *camera) + step * (light_step * glm::length(arm));
  studio.set_light(light_of_handle(handle, *light, *camera));
}

template <int X, int Y>
void move_pixel(Studio& studio, View& view) {
  const int width = studio.graphics().width(), height = studio.graphics().height();
  glm::ivec2 pixel = studio.pixel().value_or(glm::ivec2(width / 2 - X, height / 2 - Y));
  pixel = {std::clamp(pixel.x + X, 0, width - 1), std::clamp(pixel.y + Y, 0, height - 1)};
  studio.set_pixel(pixel);
  view.details = View::Details::pixel;
  view.picture.pan_to(pixel);
}

// Along the floor, as the camera sees it: to its right, and away from it.
template <int Right, int Away>
void move_caster(Studio& studio, View& view) {
  const auto camera = studio.camera();
  if (!camera) return;
  const glm::dvec3 arm = camera->target - camera->eye, up = glm::normalize(camera->up);
  const glm::dvec3 right = glm::normalize(glm::cross(arm, up)), away = glm::cross(up, right);
  studio.shift_caster(
      view.caster, (right * double(Right) + away * double(Away)) * (light_step * glm::length(arm)));
}

template <int By>
void slide(Studio&, View& view) {
  view.slider = std::clamp(view.slider + By * 0.05, 0.0, 1.0);
}

template <bool Larger>
void zoom(Studio& studio, View& view) {
  const Rectangle& area = view.picture.area();
  glm::dvec2 at(area.x + area.width / 2, area.y + area.height / 2);
  // About the pixel that is looked at, which keys lead to.
  if (const auto& pixel = studio.pixel())
    at = view.picture.corner_of(pixel->x + 0.5, pixel->y + 0.5);
  view.picture.zoom_at(Larger ? 2 : 0.5, at.x, at.y);
}

template <int By>
void step_parameter(Studio& studio, View& view) {
  const recipe::Recipe* recipe = studio.bench().workshop.recipe();
  if (!recipe || view.parameter >= recipe->parameters().size()) return;
  const auto& [name, parameter] = recipe->parameters()[view.parameter];
  studio.set(std::string(name), stepped(parameter, By));
}

template <int By>
void select_parameter(Studio& studio, View& view) {
  const recipe::Recipe* recipe = studio.bench().workshop.recipe();
  if (!recipe || recipe->parameters().empty()) return;
  const std::size_t count = recipe->parameters().size();
  view.parameter = (view.parameter + (By > 0 ? 1 : count - 1)) % count;
}

template <class T>
T next_of(T value) {
  return static_cast<T>((static_cast<int>(value) + 1) % static_cast<int>(T::count));
}

constexpr Command all[] = {
    {Key::f1, 0, plain, "F1 or ?", "these keys", [](Studio&, View& v) { v.help = !v.help; }},
    {Key::character, 'q', control, "Esc, Ctrl+Q", "quit", [](Studio&, View& v) { v.open = false; }},
    {Key::escape, 0, plain, nullptr, "",
     [](Studio&, View& v) { v.help ? v.help = false : v.open = false; }},
    {Key::f5, 0, plain, "F5", "reload", [](Studio& s, View&) { s.reload_all(); }},
    {Key::f5, 0, control, "Ctrl+F5", "a new window, should the driver have lost this one's context",
     [](Studio&, View& v) { v.renewed = true; }},
    {Key::character, 'r', control, "Ctrl+R", "parameters, camera and casters as the recipe has them",
     [](Studio& s, View&) { s.reset(); }},

    {Key::down, 0, plain, "Up, Down", "step through the passes; Home: the whole frame",
     [](Studio& s, View&) { s.step_pass(1); }},
    {Key::up, 0, plain, nullptr, "", [](Studio& s, View&) { s.step_pass(-1); }},
    {Key::home, 0, plain, nullptr, "", [](Studio& s, View&) { s.choose_pass({}); }},
    {Key::f3, 0, plain, "F3", "colour, depth, stencil, attachments",
     [](Studio& s, View&) { s.look_at_next(); }},
    {Key::f12, 0, plain, "F12", "the pass's state, its calls, the pixel's history",
     [](Studio&, View& v) { v.details = next_of(v.details); }},
    {Key::page_down, 0, shift, "Shift+PageUp, PageDown", "through the state, calls, history",
     [](Studio&, View& v) { v.scrolls += 8; }},
    {Key::page_up, 0, shift, nullptr, "", [](Studio&, View& v) { v.scrolls -= 8; }},
    {Key::left, 0, alt, "Alt+arrows", "the pixel that is looked at", move_pixel<-1, 0>},
    {Key::right, 0, alt, nullptr, "", move_pixel<1, 0>},
    {Key::up, 0, alt, nullptr, "", move_pixel<0, -1>},
    {Key::down, 0, alt, nullptr, "", move_pixel<0, 1>},
    {Key::f4, 0, plain, "F4", "the truth under a slider, beside, the error, neither",
     [](Studio& s, View&) { s.set_truth_mode(next_of(s.truth_mode())); }},
    {Key::home, 0, control, "Ctrl+Home, Ctrl+End", "the slider", slide<-1>},
    {Key::end, 0, control, nullptr, "", slide<1>},
    {Key::f6, 0, plain, "F6", "silhouettes, volumes, the light's frustum, cascades",
     [](Studio&, View& v) { v.overlay = next_of(v.overlay); }},

    {Key::tab, 0, plain, "Tab", "the next parameter; Left, Right change it",
     select_parameter<1>},
    {Key::tab, 0, shift, nullptr, "", select_parameter<-1>},
    {Key::left, 0, plain, nullptr, "", step_parameter<-1>},
    {Key::right, 0, plain, nullptr, "", step_parameter<1>},
    {Key::left, 0, control, "Ctrl+arrows", "the light; with PageUp, PageDown nearer and farther",
     move_light<-1, 0, 0>},
    {Key::right, 0, control, nullptr, "", move_light<1, 0, 0>},
    {Key::up, 0, control, nullptr, "", move_light<0, 1, 0>},
    {Key::down, 0, control, nullptr, "", move_light<0, -1, 0>},
    {Key::page_up, 0, control, nullptr, "", move_light<0, 0, 1>},
    {Key::page_down, 0, control, nullptr, "", move_light<0, 0, -1>},
    {Key::left, 0, control_shift, "Ctrl+Shift+arrows", "a caster along the floor; with Tab another",
     move_caster<-1, 0>},
    {Key::right, 0, control_shift, nullptr, "", move_caster<1, 0>},
    {Key::up, 0, control_shift, nullptr, "", move_caster<0, 1>},
    {Key::down, 0, control_shift, nullptr, "", move_caster<0, -1>},
    {Key::tab, 0, control_shift, nullptr, "",
     [](Studio& s, View& v) {
       ++v.caster;
       s.shift_caster(v.caster, {});
     }},
    {Key::left, 0, shift, "Shift+arrows", "the camera; PageUp, PageDown nearer and farther",
     orbit<-1, 0>},
    {Key::right, 0, shift, nullptr, "", orbit<1, 0>},
    {Key::up, 0, shift, nullptr, "", orbit<0, 1>},
    {Key::down, 0, shift, nullptr, "", orbit<0, -1>},
    {Key::page_up, 0, plain, nullptr, "", go<true>},
    {Key::page_down, 0, plain, nullptr, "", go<false>},

    {Key::character, ' ', plain, "Space", "pause; Ctrl+Space: one frame on",
     [](Studio& s, View&) { s.clock().toggle_pause(); }},
    {Key::character, ' ', control, nullptr, "",
     [](Studio& s, View&) {
       if (!s.clock().paused()) s.clock().toggle_pause();
       s.clock().step(1);
       s.touch();
     }},
    {Key::f7, 0, plain, "F7", "slow motion", [](Studio& s, View&) { s.clock().toggle_slow_motion(); }},
    {Key::character, 's', control, "Ctrl+S", "the picture as PNG; with Shift the window",
     [](Studio& s, View&) { s.ask_for_screenshot(); }},
    {Key::character, 's', control_shift, nullptr, "",
     [](Studio&, View& v) { v.window_shot = true; }},
    {Key::f9, 0, plain, "F9", "begin and end a film (mp4); with Shift a GIF",
     [](Studio& s, View&) { s.toggle_film(".mp4"); }},
    {Key::f9, 0, shift, nullptr, "", [](Studio& s, View&) { s.toggle_film(".gif"); }},

    {Key::character, '1', control, "Ctrl+1", "a pixel for a pixel; Ctrl+0: as it fits",
     [](Studio&, View& v) { v.picture.set_zoom(1); }},
    {Key::character, '0', control, nullptr, "", [](Studio&, View& v) { v.picture.fit(); }},
    {Key::character, '+', control, "Ctrl++, Ctrl+-", "larger, smaller; also by Ctrl and the wheel", zoom<true>},
    {Key::character, '=', control, nullptr, "", zoom<true>},
    {Key::character, '=', control_shift, nullptr, "", zoom<true>},
    {Key::character, '-', control, nullptr, "", zoom<false>},
    {Key::f2, 0, plain, "F2", "panels", [](Studio&, View& v) { v.panels = !v.panels; }},
    {Key::f8, 0, plain, "F8", "large type for a projector",
     [](Studio&, View& v) { v.style = v.style == Style::desk ? Style::projector : Style::desk; }},
    {Key::f10, 0, plain, "F10", "slow recipes coarse while something moves, or always sharp",
     [](Studio& s, View&) {
       const bool sharp = s.detail() == Studio::Detail::full;
       s.set_detail(sharp ? Studio::Detail::as_it_moves : Studio::Detail::full);
       s.say(sharp ? "slow recipes are coarse while something moves" : "always sharp");
     }},
    {Key::f11, 0, plain, "F11", "full screen",
     [](Studio&, View& v) {
       v.extent = v.extent == context::Extent::windowed ? context::Extent::full_screen
                                                        : context::Extent::windowed;
     }},
    {Key::tab, 0, control, "Ctrl+Tab", "the next recipe",
     [](Studio& s, View&) { s.set_focus(s.focus() + 1); }},
};

bool same(const Modifiers& a, const Modifiers& b) {
  return a.shift == b.shift && a.control == b.control && a.alt == b.alt;
}

}  // namespace

std::span<const Command> commands() { return all; }

bool run_command(const context::KeyEvent& event, Studio& studio, View& view) {
  if (event.press == context::Press::up) return false;
  for (const Command& command : all) {
    if (command.key != event.key || command.character != event.character) continue;
    if (!same(command.modifiers, event.modifiers)) continue;
    command.run(studio, view);
    return true;
  }
  return false;
}

std::string stepped(const lua::Parameter& parameter, int by) {
  using Kind = lua::Parameter::Kind;
  lua::Parameter after = parameter;
  double& value = after.value[0];
  const double range = parameter.most - parameter.least;
  switch (parameter.kind) {
    case Kind::toggle:
      value = value == 0 ? 1 : 0;
      break;
    case Kind::choice: {
      const auto count = static_cast<double>(parameter.choices.size());
      value = std::fmod(value + by + count, count);
      break;
    }
    case Kind::integer:
      value = std::clamp(value + by * std::max(1.0, std::round(range / 100)), parameter.least,
                         parameter.most);
      break;
    case Kind::number:
    case Kind::color: {
      const double step = (parameter.kind == Kind::color ? 1 : range) / 40;
      for (double& each : after.value)
        each = std::clamp(std::round((each + by * step) / step) * step,
                          parameter.kind == Kind::color ? 0 : parameter.least,
                          parameter.kind == Kind::color ? 1 : parameter.most);
      break;
    }
    case Kind::point:
    case Kind::direction:
      // Ctrl and arrows move lights; other points are told by their first number.
      value += 0.1 * by;
      if (parameter.kind == Kind::direction && after.value == std::vector<double>{0, 0, 0})
        after.value = parameter.value;
      break;
  }
  return lua::text_of(after);
}

}  // namespace shadowlab::live
