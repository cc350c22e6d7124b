// What keys do to parameters.
#include <gtest/gtest.h>

#include "core/error.h"
#include "recipe/recipe.h"

namespace shadowlab::recipe {
namespace {

using lua::Parameter;
using Kind = Parameter::Kind;

const std::vector<NamedParameter> parameters{
    {"clip", {Kind::toggle, {1}, 0, 1, {}}},
    {"darkness", {Kind::number, {0.35}, 0, 1, {}}},
    {"light", {Kind::point, {1, 2, 3}, 0, 0, {}}},
    {"pattern", {Kind::choice, {1}, 0, 0, {"random", "grid"}}},
    {"samples", {Kind::integer, {1}, 1, 64, {}}},
    {"sun", {Kind::direction, {0, 0.5, 0}, 0, 0, {}}},
};

std::string after(const std::string& words) {
  const KeyAction action = key_action("k", words, parameters);
  for (const auto& known : parameters) {
    if (known.name == action.parameter) return pressed(action, known.parameter);
  }
  return "";
}

std::string refusal(const std::string& words) {
  try {
    key_action("k", words, parameters);
  } catch (const InputError& problem) {
    return problem.what();
  }
  return "";
}

TEST(Keys, do_what_their_words_say) {
  EXPECT_EQ(after("toggle clip"), "false");
  EXPECT_EQ(after("toggle darkness 0 0.35"), "0");
  EXPECT_EQ(after("toggle darkness 0.35 0"), "0");
  EXPECT_EQ(after("toggle darkness 0.1 0.2"), "0.1");
  EXPECT_EQ(after("next pattern"), "random");
  EXPECT_EQ(after("add light -0.5 0 1"), "0.5,2,4");
  EXPECT_EQ(after("add darkness 0.5"), "0.85");
  EXPECT_EQ(after("multiply light 2"), "2,4,6");
}

TEST(Keys, stay_within_the_range) {
  EXPECT_EQ(after("add darkness 5"), "1");
  EXPECT_EQ(after("add darkness -5"), "0");
  EXPECT_EQ(after("multiply samples 0.5"), "1");
  EXPECT_EQ(after("add sun 0 -0.5 0"), "0,0.5,0") << "no direction at all is none";
}

TEST(Keys, multiply_an_integer_by_at_least_one) {
  EXPECT_EQ(after("multiply samples 1.25"), "2");
  EXPECT_EQ(after("multiply samples 2"), "2");
}

TEST(Keys, refuse_what_they_cannot_do_by_name) {
  EXPECT_NE(refusal("togle clip").find("did you mean toggle?"), std::string::npos);
  EXPECT_NE(refusal("toggle clp").find("did you mean clip?"), std::string::npos);
  EXPECT_NE(refusal("toggle light").find("a toggle or a number"), std::string::npos);
  EXPECT_NE(refusal("next clip").find("a choice"), std::string::npos);
  EXPECT_NE(refusal("add light 1").find("3 numbers"), std::string::npos);
  EXPECT_NE(refusal("add darkness one").find("no number"), std::string::npos);
  EXPECT_NE(refusal("toggle").find("a verb and a parameter"), std::string::npos);
}

}  // namespace
}  // namespace shadowlab::recipe
