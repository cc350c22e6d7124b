#include "measure/errors.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

#include "measure/bar_check.h"
#include "measure/record.h"

namespace shadowlab::measure {
namespace {

image::FloatImage row(std::vector<float> values) {
  const int width = static_cast<int>(values.size());
  return {width, 1, std::move(values)};
}

Truth truth_of(std::vector<float> values, double bar = 0) {
  Truth truth;
  truth.edges = row(std::vector<float>(values.size(), 0.0f));
  truth.visibility = row(std::move(values));
  truth.bar = bar;
  return truth;
}

TEST(Errors, are_told_apart_in_the_umbra_the_penumbra_and_the_light) {
  const Truth truth = truth_of({0, 0, 0.5f, 1});
  const Errors errors = errors_of(row({0.5f, 0, 0.25f, 1}), truth, {1, 1, 1, 1});
  EXPECT_EQ(errors.pixels, 4u);
  EXPECT_EQ(errors.umbra, std::sqrt(0.125));
  EXPECT_EQ(errors.penumbra, 0.25);
  EXPECT_EQ(errors.lit, 0);
  EXPECT_EQ(errors.rmse, std::sqrt((0.25 + 0.0625) / 4));
  EXPECT_EQ(errors.worst, 0.5);
  EXPECT_EQ(errors.worst_x, 0);
}

TEST(Errors, where_there_is_no_penumbra_it_has_none) {
  const Errors errors = errors_of(row({0, 1}), truth_of({0, 1}), {1, 1});
  EXPECT_FALSE(errors.penumbra);
  EXPECT_EQ(errors.rmse, 0);
}

TEST(Errors, what_nobody_claims_is_not_compared) {
  const Errors errors = errors_of(row({1, 1}), truth_of({0, 1}), {0, 1});
  EXPECT_EQ(errors.pixels, 1u);
  EXPECT_EQ(errors.wrong, 0u);
  EXPECT_EQ(errors_of(row({1}), truth_of({0}), {0}).pixels, 0u);
}

TEST(Errors, beyond_an_edge_are_counted_apart) {
  Truth truth = truth_of({0, 0, 0});
  truth.edges.values[0] = 1;
  const Errors errors = errors_of(row({1, 1, 0.5f}), truth, {1, 1, 1});
  EXPECT_EQ(errors.wrong, 2u) << "one half is not more than one half";
  EXPECT_EQ(errors.wrong_beyond_edge, 1u);
}

TEST(Errors, what_is_not_a_number_is_off_by_one) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(errors_of(row({nan}), truth_of({1}), {1}).rmse, 1);
}

TEST(Errors, the_99th_percentile_leaves_out_the_worst_pixel_of_a_hundred_and_one) {
  std::vector<float> values(101, 0.0f);
  values[7] = 1;
  const Errors errors = errors_of(row(values), truth_of(std::vector<float>(101, 0.0f)),
                                  std::vector<std::uint8_t>(101, std::uint8_t{1}));
  EXPECT_EQ(errors.p99, 0);
  EXPECT_EQ(errors.worst_x, 7);
}

// A point as it is reported, of a job that was not timed.
Json reported(const Errors& errors) {
  Look look;
  look.errors = errors;
  return point_of({"a.lua", "s", {}}, look, {}, {}).at("error");
}

TEST(Errors, below_the_bar_are_reported_at_the_bar) {
  const Errors errors = errors_of(row({0, 0.51f, 1}), truth_of({0, 0.5f, 1}, 0.125), {1, 1, 1});
  const Json record = reported(errors);
  EXPECT_EQ(record.at("below_bar"), true);
  for (const char* name : {"rmse", "p99", "umbra_rmse", "penumbra_rmse", "lit_rmse"})
    EXPECT_EQ(record.at(name), 0.125) << name;
}

TEST(Errors, above_the_bar_are_reported_as_they_are) {
  const Errors errors = errors_of(row({0, 1}), truth_of({0, 0.5f}, 0.125), {1, 1});
  const Json record = reported(errors);
  EXPECT_EQ(record.at("below_bar"), false);
  EXPECT_EQ(record.at("rmse"), std::sqrt(0.125));
  EXPECT_EQ(record.at("umbra_rmse"), 0.125);
  EXPECT_TRUE(record.at("lit_rmse").is_null());
}

TEST(BarCheck, the_truth_keeps_the_bar_that_it_states_against_closed_forms) {
  for (const double bar : {0.02, 0.005}) {
    for (const BarCheck& check : check_bar(bar, 48)) {
      EXPECT_GT(check.pixels, 100u) << check.shadow;
      EXPECT_TRUE(check.holds()) << check.shadow << ": " << check.rmse << " for " << bar;
    }
  }
}

}  // namespace
}  // namespace shadowlab::measure
