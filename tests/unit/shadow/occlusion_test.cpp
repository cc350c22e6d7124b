#include "shadow/occlusion.h"

#include <gtest/gtest.h>

namespace shadowlab::shadow {
namespace {

Extent extent(glm::dvec2 low, glm::dvec2 high, double nearest) {
  Extent made;
  made.add(low, nearest);
  made.add(high, nearest);
  return made;
}

// A square of pixels 20 to 80 each way, at depth 5: cells are one pixel of a picture this small.
Occlusion square() {
  Occlusion occlusion({100, 100});
  occlusion.add({{{20, 20}, {80, 20}, {80, 80}, {20, 80}, {30, 30}, {70, 30}, {70, 70}, {30, 70}}},
                5);
  return occlusion;
}

TEST(Occlusion, hides_what_is_behind_and_within) {
  EXPECT_TRUE(square().hides(extent({30, 30}, {70, 70}, 6)));
}

TEST(Occlusion, hides_nothing_before_it_or_beyond_its_outline) {
  EXPECT_FALSE(square().hides(extent({30, 30}, {70, 70}, 4)));
  EXPECT_FALSE(square().hides(extent({30, 30}, {81, 70}, 6)));
  EXPECT_FALSE(square().hides(extent({19, 30}, {70, 70}, 6)));
  EXPECT_FALSE(square().hides(extent({30, 30}, {70, 80}, 6)));
}

TEST(Occlusion, joins_occluders_that_overlap) {
  Occlusion occlusion = square();
  const Extent wide = extent({30, 30}, {95, 70}, 9);
  EXPECT_FALSE(occlusion.hides(wide));
  occlusion.add(
      {{{60, 20}, {100, 20}, {100, 80}, {60, 80}, {60, 20}, {100, 20}, {100, 80}, {60, 80}}}, 8);
  EXPECT_TRUE(occlusion.hides(wide));
}

}  // namespace
}  // namespace shadowlab::shadow
