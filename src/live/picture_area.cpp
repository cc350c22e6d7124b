// The picture in the middle: the pointer's hold on it, what is drawn over it.
#include <algorithm>
#include <array>
#include <cmath>

#include "live/panels.h"

namespace shadowlab::live {
namespace {

constexpr double drawn_edges = 20'000;  // an overlay's most shapes: more would be a blot

ImVec2 vec(glm::dvec2 place) { return {static_cast<float>(place.x), static_cast<float>(place.y)}; }

bool takes_pointer(const View& view) {
  const ImGuiIO& io = ImGui::GetIO();
  return !io.WantCaptureMouse && view.picture.area().holds(io.MousePos.x, io.MousePos.y);
}

// The slider of the truth, where there is one: pixels of the screen from the left.
std::optional<double> slider_of(const Studio& studio, const View& view) {
  if (studio.truth_mode() != TruthMode::slider || !studio.truth().shows()) return {};
  return view.picture.placed().x + view.slider * view.picture.placed().width;
}

struct Mark {
  ImVec2 at;
  bool inside = true;  ///< where it shows what it stands for, and not at the border nearest to that
};

// Of the light, to be seen and taken hold of: at the border where the light is out of sight.
std::optional<Mark> light_mark(const Studio& studio, const View& view) {
  const auto camera = studio.camera();
  const auto light = studio.light();
  if (!camera || !light) return {};
  const Seen place = seen(*camera, studio.aspect(), light_handle(*light, *camera));
  if (place.distance <= 0) return {};
  const glm::dvec2 at = view.picture.to_screen({place.x, place.y});
  const Rectangle& area = view.picture.area();
  const double margin = 0.6 * static_cast<double>(ImGui::GetFontSize());
  if (area.width < 2 * margin || area.height < 2 * margin) return {};
  const glm::dvec2 low(area.x + margin, area.y + margin);
  const glm::dvec2 high(area.x + area.width - margin, area.y + area.height - margin);
  const glm::dvec2 there = glm::clamp(at, low, high);
  return Mark{vec(there), there == at};
}

bool marks_light(const Studio& studio, const View& view) {
  return view.panels && studio.truth_mode() != TruthMode::error &&
         studio.looked_at().buffer != LookedAt::Buffer::attachment;
}

class Pointer {
 public:
  Pointer(Studio& studio, View& view, double zoomed)
      : studio_(studio), view_(view), zoomed_(zoomed) {}

  void run() {
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 place = view_.picture.from_screen(io.MousePos.x, io.MousePos.y);
    if (takes_pointer(view_)) {
      hover(io);
      press(io, place);
      wheel(io);
    }
    if (ImGui::IsMouseDragging(0, 0) || ImGui::IsMouseDragging(1, 0)) drag(io, place);
    if (ImGui::IsMouseDragging(2, 0)) view_.picture.pan(io.MouseDelta.x, io.MouseDelta.y);
    if (!ImGui::IsAnyMouseDown()) studio_.let_go();
  }

 private:
  void hover(const ImGuiIO& io) {
    if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0) return;  // the keys may have moved it on
    if (!view_.panels || view_.details != View::Details::pixel) return studio_.set_pixel({});
    studio_.set_pixel(view_.picture.pixel_at(io.MousePos.x, io.MousePos.y));
  }

  void press(const ImGuiIO& io, glm::dvec2 place) {
    for (const int button : {0, 1}) {
      if (!ImGui::IsMouseClicked(button)) continue;
      const auto slider = slider_of(studio_, view_);
      if (button == 0 && slider && std::abs(*slider - io.MousePos.x) < ImGui::GetFontSize()) {
        slides() = true;
        return;
      }
      slides() = false;
      const double reach = 1.5 * ImGui::GetFontSize() / view_.picture.placed().height;
      const bool light = on_light(io);
      const auto grip = light ? Studio::Grip::light : studio_.grip_at(place, reach);
      studio_.grab(place, button == 1 ? Studio::Grip::camera : grip);
    }
  }

  bool on_light(const ImGuiIO& io) const {
    const auto mark = light_mark(studio_, view_);
    if (!mark || !marks_light(studio_, view_)) return false;
    return std::hypot(mark->at.x - io.MousePos.x, mark->at.y - io.MousePos.y) <
           0.75f * ImGui::GetFontSize();
  }

  void drag(const ImGuiIO& io, glm::dvec2 place) {
    if (slides()) {
      const Rectangle& at = view_.picture.placed();
      view_.slider = std::clamp((io.MousePos.x - at.x) / at.width, 0.0, 1.0);
    } else if (io.KeyShift) {
      if (const auto camera = studio_.camera()) {
        const double height = view_.picture.placed().height;
        studio_.set_camera(shifted(*camera, -io.MouseDelta.x / height, io.MouseDelta.y / height));
      }
    } else if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) {
      studio_.drag(place);
    }
  }

  void wheel(const ImGuiIO& io) {
    if (zoomed_ != 0) view_.picture.zoom_at(std::pow(1.25, zoomed_), io.MousePos.x, io.MousePos.y);
    if (io.MouseWheel == 0) return;
    if (const auto camera = studio_.camera())
      studio_.set_camera(approached(*camera, std::pow(0.9, io.MouseWheel)));
  }

  bool& slides() { return view_.slides; }

  Studio& studio_;
  View& view_;
  double zoomed_;
};

void draw_image(ImDrawList& list, const gl::ShownPicture& picture, const Rectangle& at,
                double from = 0) {
  if (!picture.texture()) return;
  const auto left = static_cast<float>(at.x + from * at.width);
  list.AddImage(texture_id(picture), {left, static_cast<float>(at.y)},
                {static_cast<float>(at.x + at.width), static_cast<float>(at.y + at.height)},
                {static_cast<float>(from), 1}, {1, 0});
}

void draw_overlay(ImDrawList& list, const Studio& studio, View& view) {
  const recipe::Recipe* recipe = studio.bench().workshop.recipe();
  const auto camera = studio.camera();
  const auto light = studio.light();
  if (!recipe || !recipe->scene() || !camera || !light) return;
  static constexpr std::array<ImU32, 4> lines{
      IM_COL32(255, 220, 60, 255), IM_COL32(90, 200, 255, 255), IM_COL32(120, 255, 130, 255),
      IM_COL32(255, 120, 220, 255)};
  std::size_t drawn = 0;
  // Lines are smooth; faces that share an edge would show it as a line, were their borders too.
  const ImDrawListFlags before = list.Flags;
  list.Flags |= ImDrawListFlags_AntiAliasedLines;
  for (const Shape& shape :
       view.shapes.of(view.overlay, *recipe->scene(), *camera, studio.aspect(), *light)) {
    if (static_cast<double>(++drawn) > drawn_edges) break;
    std::vector<ImVec2> points;
    for (const glm::dvec2 place : projected(shape, *camera, studio.aspect()))
      points.push_back(vec(view.picture.to_screen(place)));
    if (points.empty()) continue;
    const auto group = static_cast<std::size_t>(shape.group) % lines.size();
    const auto count = static_cast<int>(points.size());
    if (shape.kind == Shape::Kind::face) {
      list.AddConvexPolyFilled(points.data(), count, IM_COL32(255, 220, 60, 12));
    } else {
      list.AddPolyline(points.data(), count, lines[group], 0, 1.5f * ImGui::GetFontSize() / 16);
    }
  }
  list.Flags = before;
}

void draw_truth(ImDrawList& list, const Studio& studio, const View& view) {
  if (!studio.truth().shows()) return;
  const Rectangle& at = view.picture.placed();
  if (studio.truth_mode() == TruthMode::error) draw_image(list, studio.truth().error(), at);
  if (const auto slider = slider_of(studio, view)) {
    draw_image(list, studio.truth().truth(), at, view.slider);
    const auto x = static_cast<float>(*slider);
    list.AddLine({x, static_cast<float>(at.y)}, {x, static_cast<float>(at.y + at.height)},
                 IM_COL32(255, 200, 60, 255), stroke(2));
  }
}

}  // namespace

void draw_picture(Studio& studio, View& view, const Interface& interface, const Rectangle& area) {
  const gl::ShownPicture& picture = studio.shown(studio.bench());
  // A coarse picture takes the place of the sharp one.
  const bool attachment = studio.looked_at().buffer == LookedAt::Buffer::attachment;
  const int width = attachment ? std::max(1, picture.width()) : studio.graphics().width();
  const int height = attachment ? std::max(1, picture.height()) : studio.graphics().height();
  view.picture.place(area, width, height);
  Pointer(studio, view, interface.zoomed()).run();
  view.picture.place(area, width, height);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(
      {static_cast<float>(area.x), static_cast<float>(area.y)},
      {static_cast<float>(area.x + area.width), static_cast<float>(area.y + area.height)});
  draw_image(list, picture, view.picture.placed());
  // At the frame's end and in colour the picture is the recipe's, and things can be laid over it.
  if (!attachment) {
    draw_truth(list, studio, view);
    if (view.overlay != Overlay::none) draw_overlay(list, studio, view);
  }
  ImGui::PushFont(interface.code());
  const bool numbers = shows_numbers(view.picture);
  studio.set_numbers(numbers ? Studio::Numbers::shown : Studio::Numbers::hidden);
  if (numbers) draw_numbers(studio, view, width, height);
  ImGui::PopFont();
  if (studio.pixel() && view.panels && view.details == View::Details::pixel && !attachment) {
    const glm::ivec2 pixel = *studio.pixel();
    list.AddRect(vec(view.picture.corner_of(pixel.x, pixel.y) - 1.0),
                 vec(view.picture.corner_of(pixel.x + 1, pixel.y + 1) + 1.0),
                 IM_COL32(255, 200, 60, 255));
  }
  list.PopClipRect();
}

void draw_truth_beside(const Studio& studio, const View& view, const Rectangle& area) {
  if (!studio.truth().shows()) return;
  PictureView other = view.picture;
  other.place(area, studio.truth().truth().width(), studio.truth().truth().height());
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect(vec({area.x, area.y}), vec({area.x + area.width, area.y + area.height}));
  draw_image(list, studio.truth().truth(), other.placed());
  list.PopClipRect();
}

void draw_light(const Studio& studio, const View& view) {
  if (!marks_light(studio, view)) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto mark = light_mark(studio, view);
  if (!mark) return;
  const float radius = ImGui::GetFontSize() * 0.4f;
  const ImDrawListFlags before = list.Flags;
  list.Flags |= ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedFill;
  list.AddCircleFilled(mark->at, radius, IM_COL32(255, 235, 150, 255));
  list.AddCircle(mark->at, radius + 1.5f, IM_COL32(30, 30, 30, 255), 0, stroke(2));
  if (!mark->inside) list.AddCircleFilled(mark->at, radius * 0.55f, IM_COL32(30, 30, 30, 255));
  list.Flags = before;
}

}  // namespace shadowlab::live
