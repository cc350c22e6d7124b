// A recipe's table sweep, and what of it is refused.
#include <gtest/gtest.h>

#include "recipe_fixture.h"

namespace shadowlab::recipe {
namespace {

std::string sweeping(const std::string& sweep) {
  return drawing(
      "", "params = { size = param.integer(3, 1, 9), on = param.toggle(true) }, sweep = " + sweep);
}

class SweepTest : public RecipeTest {};

TEST_F(SweepTest, is_read_in_alphabetical_order_as_set_takes_it) {
  const RecipeFile file(sweeping("{ size = { 1, 2, 9 }, on = { true, false } }"));
  const Recipe recipe(graphics(), file.path());
  const auto& sweep = recipe.description().sweep;
  ASSERT_EQ(sweep.size(), 2u);
  EXPECT_EQ(sweep[0].name, "on");
  EXPECT_EQ(sweep[0].values, (std::vector<std::string>{"true", "false"}));
  EXPECT_EQ(sweep[1].values, (std::vector<std::string>{"1", "2", "9"}));
}

TEST_F(SweepTest, of_what_is_no_parameter_or_no_value_of_it_is_refused) {
  EXPECT_EQ(error(sweeping("{ sise = { 1 } }")),
            "F: sweep.sise is no parameter; did you mean size?");
  EXPECT_EQ(error(sweeping("{ size = { 1, 20 } }")),
            "F: sweep.size: parameter size takes an integer from 1 to 9; \"20\" given");
  EXPECT_EQ(error(sweeping("{ size = {} }")).find("F: sweep.size must be a list of values"), 0u);
  EXPECT_EQ(error(sweeping("3")).find("F: sweep must be a table"), 0u);
}

TEST_F(SweepTest, of_every_recipe_that_comes_with_shadowlab_can_be_read) {
  for (const auto& entry : std::filesystem::directory_iterator(home() / "scripts")) {
    if (entry.path().extension() == ".lua") {
      EXPECT_NO_THROW(Recipe(graphics(), entry.path()));
    }
  }
}

}  // namespace
}  // namespace shadowlab::recipe
