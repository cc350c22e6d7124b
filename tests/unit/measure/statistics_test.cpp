#include "measure/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace shadowlab::measure {
namespace {

TEST(Statistics, quartiles_of_one_to_five_are_two_three_and_four) {
  const Quartiles q = quartiles({5, 1, 4, 2, 3});
  EXPECT_EQ(q.low, 2);
  EXPECT_EQ(q.median, 3);
  EXPECT_EQ(q.high, 4);
  EXPECT_EQ(q.count, 5u);
}

TEST(Statistics, a_quantile_between_two_values_is_interpolated) {
  EXPECT_EQ(quantile({10, 20}, 0.5), 15);
  EXPECT_EQ(quantile({10, 20}, 0.25), 12.5);
  EXPECT_EQ(quantile({7}, 0.99), 7);
  EXPECT_EQ(quantile({3, 1, 2}, 1), 3);
}

TEST(Statistics, quartiles_of_nothing_are_zero) { EXPECT_EQ(quartiles({}).count, 0u); }

TEST(Statistics, a_power_law_is_found_again) {
  std::vector<Point> points;
  for (const double x : {1.0, 3.0, 10.0, 70.0}) points.push_back({x, 0.3 * std::pow(x, 1.7)});
  const auto law = power_law(points);
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->exponent, 1.7, 1e-12);  // rounding of logarithms
  EXPECT_NEAR(law->explained, 1, 1e-12);
}

TEST(Statistics, what_is_constant_has_the_exponent_zero) {
  const auto law = power_law(std::vector<Point>{{1, 2}, {2, 2}, {4, 2}});
  ASSERT_TRUE(law);
  EXPECT_EQ(law->exponent, 0);
}

TEST(Statistics, two_places_are_no_power_law) {
  EXPECT_FALSE(power_law(std::vector<Point>{{1, 1}, {2, 4}}));
  EXPECT_FALSE(power_law(std::vector<Point>{{1, 1}, {2, 4}, {2, 5}, {0, 1}, {3, -1}}));
}

TEST(Statistics, the_front_is_what_nothing_beats) {
  // The third is slower and no better than the second; the last two are one.
  const std::vector<Point> points{{1, 9}, {2, 5}, {3, 5}, {4, 6}, {5, 1}, {5, 1}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{0, 1, 4}));
}

TEST(Statistics, of_points_of_one_time_the_front_has_the_best) {
  EXPECT_EQ(pareto_front(std::vector<Point>{{1, 9}, {1, 3}}), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(pareto_front({}).empty());
}

}  // namespace
}  // namespace shadowlab::measure
