#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"
#include "core/version.h"
#include "live/workshop.h"

namespace shadowlab::live {
namespace {

constexpr int side = 32;

std::vector<std::string> recipes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts")) {
    if (entry.path().extension() == ".lua") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Another value than the parameter's own, within its range; nothing where there is none.
std::optional<std::string> other_value(const lua::Parameter& parameter) {
  using Kind = lua::Parameter::Kind;
  lua::Parameter other = parameter;
  switch (parameter.kind) {
    case Kind::integer:
    case Kind::number: {
      const double value = parameter.value[0];
      const double half = parameter.kind == Kind::integer ? std::floor(value / 2) : value / 2;
      other.value = {
          half >= parameter.least && half != value ? half : std::min(value + 1, parameter.most)};
      break;
    }
    case Kind::toggle:
      return lua::text_of(parameter) == "true" ? "false" : "true";
    case Kind::choice: {
      const auto& all = parameter.choices;
      const auto own = std::ranges::find(all, lua::text_of(parameter));
      return own != all.end() && own + 1 != all.end() ? *(own + 1) : all.front();
    }
    default:
      return {};
  }
  return lua::text_of(other);
}

class Parameters : public testing::TestWithParam<std::string> {};

// Maps and meshes that setup made for a value are of no use with another.
TEST_P(Parameters, that_are_changed_in_the_window_draw_what_they_draw_from_the_start) {
  gl::Graphics graphics(context::create(), side, side);
  const auto file = home() / "scripts" / (GetParam() + ".lua");
  const recipe::Recipe own(graphics, file);
  for (const auto& [name, parameter] : own.parameters()) {
    const auto value = other_value(parameter);
    if (!value || *value == lua::text_of(parameter)) continue;
    Workshop workshop(graphics, file, {});
    workshop.look();
    workshop.reload();
    ASSERT_EQ(workshop.draw({}), Workshop::Drawn::picture);
    workshop.set(name, *value);
    const auto drawn = workshop.draw({});
    const auto picture = graphics.frame.read_color().rgba;
    recipe::Recipe fresh(graphics, file);
    fresh.set(name, *value);
    try {
      fresh.draw();
    } catch (const InputError&) {
      EXPECT_EQ(drawn, Workshop::Drawn::nothing) << name << " = " << *value;
      continue;
    }
    EXPECT_EQ(picture, graphics.frame.read_color().rgba) << name << " = " << *value;
  }
}

INSTANTIATE_TEST_SUITE_P(Recipes, Parameters, testing::ValuesIn(recipes()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace shadowlab::live
