#include "core/near_names.h"

#include <gtest/gtest.h>

#include <array>

namespace shadowlab {
namespace {

constexpr std::array<std::string_view, 8> comparisons = {"NEVER",   "LESS",     "EQUAL",  "LEQUAL",
                                                         "GREATER", "NOTEQUAL", "GEQUAL", "ALWAYS"};

TEST(EditDistance, counts_insertions_deletions_substitutions_and_swaps) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("keep", "keep"), 0u);
  EXPECT_EQ(edit_distance("", "keep"), 4u);
  EXPECT_EQ(edit_distance("keep", ""), 4u);
  EXPECT_EQ(edit_distance("kep", "keep"), 1u);
  EXPECT_EQ(edit_distance("keeep", "keep"), 1u);
  EXPECT_EQ(edit_distance("kelp", "keep"), 1u);
  EXPECT_EQ(edit_distance("ekep", "keep"), 1u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
}

// Optimal string alignment: no letter is edited twice, so "ca" to "abc" takes 3 and not 2.
TEST(EditDistance, does_not_edit_what_it_has_swapped) { EXPECT_EQ(edit_distance("ca", "abc"), 3u); }

TEST(EditDistance, takes_capital_and_small_letters_for_the_same) {
  EXPECT_EQ(edit_distance("StencilFunc", "stencilfunc"), 0u);
}

TEST(EditDistance, is_the_same_both_ways) {
  for (const auto a : comparisons) {
    for (const auto b : comparisons) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
  }
}

TEST(NearestName, of_a_swap_is_the_name_meant) {
  EXPECT_EQ(nearest_name("ALWYAS", comparisons), "ALWAYS");
}

TEST(NearestName, of_a_slip_of_the_shift_key_is_the_name_meant) {
  EXPECT_EQ(nearest_name("always", comparisons), "ALWAYS");
}

TEST(NearestName, of_equally_near_ones_is_the_first) {
  EXPECT_EQ(nearest_name("XEQUAL", comparisons), "EQUAL");
}

TEST(NearestName, of_something_else_entirely_is_none) {
  EXPECT_EQ(nearest_name("TRIANGLES", comparisons), std::nullopt);
  EXPECT_EQ(nearest_name("", comparisons), std::nullopt);
  EXPECT_EQ(nearest_name("ALWAYS", {}), std::nullopt);
}

// A third of the letters: 2 of 6, and not 3 of 6.
TEST(NearestName, differs_in_a_third_of_the_letters_at_most) {
  EXPECT_EQ(nearest_name("ALWxxS", comparisons), "ALWAYS");
  EXPECT_EQ(nearest_name("ALxxxS", comparisons), std::nullopt);
}

TEST(DidYouMean, ends_an_error_sentence) {
  EXPECT_EQ("gl.ALWYAS does not exist" + did_you_mean("ALWYAS", comparisons),
            "gl.ALWYAS does not exist; did you mean ALWAYS?");
  EXPECT_EQ(did_you_mean("TRIANGLES", comparisons), "");
}

}  // namespace
}  // namespace shadowlab
