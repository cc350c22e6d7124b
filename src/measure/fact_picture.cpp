#include "measure/fact_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/difference.h"

namespace shadowlab::measure {
namespace {

// The bottom left corner of rows that begin at the top.
template <class T>
std::vector<T> corner(const std::vector<T>& all, int all_width, int all_height, int width,
                      int height, std::size_t each) {
  std::vector<T> part;
  const auto row_length = static_cast<std::size_t>(all_width) * each;
  const auto kept = static_cast<std::size_t>(width) * each;
  for (int row = all_height - height; row < all_height; ++row) {
    const auto begin =
        all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(row) * row_length);
    part.insert(part.end(), begin, begin + static_cast<std::ptrdiff_t>(kept));
  }
  return part;
}

Picture& self(lua_State* L) { return lua::read_box<Picture>(L, 1, "a picture's method: self"); }

// The place of pixel (x, y), arguments 2 and 3, in rows from the top.
std::size_t pixel(lua_State* L, const Snapshot& snapshot) {
  const double x = lua::read<double>(L, 2, "x"), y = lua::read<double>(L, 3, "y");
  const int width = snapshot.color.width, height = snapshot.color.height;
  if (x != std::floor(x) || y != std::floor(y) || x < 0 || y < 0 || x >= width || y >= height) {
    throw InputError(
        fmt::format("there is no pixel ({}, {}) in a picture of {} × {}", x, y, width, height));
  }
  return static_cast<std::size_t>(height - 1 - static_cast<int>(y)) *
             static_cast<std::size_t>(width) +
         static_cast<std::size_t>(x);
}

int color(lua_State* L) {
  const Snapshot& snapshot = self(L).snapshot();
  const std::size_t at = 4 * pixel(L, snapshot);
  for (std::size_t i = 0; i < 4; ++i) lua_pushinteger(L, snapshot.color.rgba[at + i]);
  return 4;
}

int depth(lua_State* L) {
  const Snapshot& snapshot = self(L).snapshot();
  lua_pushnumber(L, snapshot.depth.values[pixel(L, snapshot)]);
  return 1;
}

int stencil(lua_State* L) {
  const Snapshot& snapshot = self(L).snapshot();
  lua_pushinteger(L, snapshot.stencil[pixel(L, snapshot)]);
  return 1;
}

int pass(lua_State* L) {
  const Picture& picture = self(L);
  const Frame& frame = *picture.frame;
  const std::size_t count = frame.size() - 1;
  std::size_t found = count;
  std::string wanted;
  if (lua_type(L, 2) == LUA_TNUMBER) {
    const double number = lua_tonumber(L, 2);
    wanted = fmt::format("number {}", number);
    if (number >= 1 && number <= static_cast<double>(count) && number == std::floor(number))
      found = static_cast<std::size_t>(number) - 1;
  } else {
    wanted = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : lua::describe(L, 2);
    for (std::size_t i = 0; i < count && found == count; ++i) {
      if (frame[i].pass == wanted) found = i;
    }
  }
  if (found == count) {
    std::string names;
    for (std::size_t i = 0; i < count; ++i)
      names += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", frame[i].pass);
    throw InputError(fmt::format("there is no pass {}; the passes are {}", wanted, names));
  }
  lua::push_box<Picture>(L, {picture.frame, found});
  return 1;
}

int difference(lua_State* L) {
  const Picture& picture = self(L);
  const Picture& other = lua::read_box<Picture>(L, 2, "what a picture is compared with");
  const int tolerance =
      lua_isnoneornil(L, 3) ? 0 : static_cast<int>(lua::read<double>(L, 3, "the tolerance"));
  const auto found = image::compare(picture.snapshot().color, other.snapshot().color, tolerance);
  const auto &mine = picture.snapshot().stencil, &theirs = other.snapshot().stencil;
  lua_Integer stencils = 0;
  for (std::size_t i = 0; i < mine.size(); ++i) stencils += mine[i] != theirs[i];
  lua_newtable(L);
  lua_pushinteger(L, static_cast<lua_Integer>(found.differing));
  lua_setfield(L, -2, "differing");
  lua_pushinteger(L, found.worst);
  lua_setfield(L, -2, "worst");
  lua_pushnumber(L, found.rmse);
  lua_setfield(L, -2, "rmse");
  lua_pushinteger(L, stencils);
  lua_setfield(L, -2, "stencil");
  return 1;
}

constexpr lua::Entry methods[] = {
    {"color", "p:color(x, y) -> r, g, b, a", "A pixel's colour, each from 0 to 255.",
     lua::guarded<color>},
    {"depth", "p:depth(x, y) -> z", "A pixel's window depth, 0 to 1.", lua::guarded<depth>},
    {"stencil", "p:stencil(x, y) -> s", "A pixel's stencil value.", lua::guarded<stencil>},
    {"pass", "p:pass(name or number) -> picture", "What there was after that pass.",
     lua::guarded<pass>},
    {"difference", "p:difference(other, tolerance) -> {differing, worst, rmse, stencil}",
     "How many pixels differ by more than tolerance steps of 8 bits, the worst step, the root mean "
     "square, and how many stencil values differ.",
     lua::guarded<difference>},
};
constexpr std::string_view field_names[] = {"width", "height", "passes"};

}  // namespace

Snapshot look_at(const gl::MainFrame& frame, int width, int height, std::string pass) {
  const image::Image color = frame.read_color();
  const image::FloatImage depth = frame.read_depth();
  const int w = frame.width(), h = frame.height();
  Snapshot snapshot{std::move(pass), image::Image(width, height), {width, height, {}}, {}};
  snapshot.color.rgba = corner(color.rgba, w, h, width, height, 4);
  snapshot.depth.values = corner(depth.values, w, h, width, height, 1);
  snapshot.stencil = corner(frame.read_stencil(), w, h, width, height, 1);
  return snapshot;
}

void push_picture(lua_State* L, Frame frame) {
  const std::size_t last = frame.size() - 1;
  lua::push_box<Picture>(L, {std::make_shared<const Frame>(std::move(frame)), last});
}

void open_picture(lua_State* L) { lua::open_box<Picture>(L, methods); }

}  // namespace shadowlab::measure

namespace shadowlab::lua {

bool BoxTraits<measure::Picture>::push_field(lua_State* L, measure::Picture& picture,
                                             std::string_view key) {
  if (key == "width" || key == "height") {
    const image::Image& color = picture.snapshot().color;
    lua_pushinteger(L, key == "width" ? color.width : color.height);
  } else if (key == "passes") {
    lua_newtable(L);
    for (std::size_t i = 0; i + 1 < picture.frame->size(); ++i) {
      lua_pushstring(L, (*picture.frame)[i].pass.c_str());
      lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
    }
  } else {
    return false;
  }
  return true;
}

std::span<const std::string_view> BoxTraits<measure::Picture>::fields() {
  return measure::field_names;
}

}  // namespace shadowlab::lua
