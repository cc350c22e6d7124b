// The control points of the Utah teapot (M. Newell, University of Utah, 1975), z up as in his
// table, the knob's top at 3.15.
//
// His 32 patches are symmetric, so a few points say them all. Body and lid are surfaces of
// revolution: a row of four control points in a quarter is (r, 0), (r, b), (b, r), (0, r), and four
// turned quarters make the ring. Handle and spout are halves mirrored in y. Expanded, these are the
// 290 distinct points of the table, to the digit.
#pragma once

#include <array>

#include <glm/glm.hpp>

namespace shadowlab::scene::newell {

/// A row of a patch of revolution: radius r, height, and the inner control points' offset b.
struct Ring {
  double radius;
  double height;
  double bulge;
};

/// Four rings: a strip of four patches around the axis.
using Strip = std::array<Ring, 4>;

/// A patch's 4 × 4 control points: rows along the spout or handle, columns around it.
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;

/// From the knob's top outward and down, then from the rim's inner edge to the middle of the
/// bottom: the outside lies to the left of the way (radius to the right, height up). The lid ends
/// at radius 1.3, the rim begins at 1.4: the gap between them is Newell's.
inline constexpr std::array<Strip, 6> strips{{
    {{{0.0, 3.15, 0.0}, {0.8, 3.15, 0.45}, {0.0, 2.85, 0.0}, {0.2, 2.7, 0.112}}},      // knob
    {{{0.2, 2.7, 0.112}, {0.4, 2.55, 0.224}, {1.3, 2.55, 0.728}, {1.3, 2.4, 0.728}}},  // lid
    {{{1.4, 2.4, 0.784},
      {1.3375, 2.53125, 0.749},
      {1.4375, 2.53125, 0.805},
      {1.5, 2.4, 0.84}}},                                                             // rim
    {{{1.5, 2.4, 0.84}, {1.75, 1.875, 0.98}, {2.0, 1.35, 1.12}, {2.0, 0.9, 1.12}}},   // belly
    {{{2.0, 0.9, 1.12}, {2.0, 0.45, 1.12}, {1.5, 0.225, 0.84}, {1.5, 0.15, 0.84}}},   // foot
    {{{1.5, 0.15, 0.84}, {1.5, 0.075, 0.84}, {1.425, 0.0, 0.798}, {0.0, 0.0, 0.0}}},  // bottom
}};

/// The halves with y ≤ 0 of the handle, from the rim down, and of the spout, from the body out.
inline constexpr std::array<Patch, 4> halves{{
    {{{{{-1.6, 0, 2.025}, {-1.6, -0.3, 2.025}, {-1.5, -0.3, 2.25}, {-1.5, 0, 2.25}}},
      {{{-2.3, 0, 2.025}, {-2.3, -0.3, 2.025}, {-2.5, -0.3, 2.25}, {-2.5, 0, 2.25}}},
      {{{-2.7, 0, 2.025}, {-2.7, -0.3, 2.025}, {-3.0, -0.3, 2.25}, {-3.0, 0, 2.25}}},
      {{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0, 1.8}}}}},
    {{{{{-2.7, 0, 1.8}, {-2.7, -0.3, 1.8}, {-3.0, -0.3, 1.8}, {-3.0, 0, 1.8}}},
      {{{-2.7, 0, 1.575}, {-2.7, -0.3, 1.575}, {-3.0, -0.3, 1.35}, {-3.0, 0, 1.35}}},
      {{{-2.5, 0, 1.125}, {-2.5, -0.3, 1.125}, {-2.65, -0.3, 0.9375}, {-2.65, 0, 0.9375}}},
      {{{-2.0, 0, 0.9}, {-2.0, -0.3, 0.9}, {-1.9, -0.3, 0.6}, {-1.9, 0, 0.6}}}}},
    {{{{{1.7, 0, 1.425}, {1.7, -0.66, 1.425}, {1.7, -0.66, 0.6}, {1.7, 0, 0.6}}},
      {{{2.6, 0, 1.425}, {2.6, -0.66, 1.425}, {3.1, -0.66, 0.825}, {3.1, 0, 0.825}}},
      {{{2.3, 0, 2.1}, {2.3, -0.25, 2.1}, {2.4, -0.25, 2.025}, {2.4, 0, 2.025}}},
      {{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}}}},
    {{{{{2.7, 0, 2.4}, {2.7, -0.25, 2.4}, {3.3, -0.25, 2.4}, {3.3, 0, 2.4}}},
      {{{2.8, 0, 2.475}, {2.8, -0.25, 2.475}, {3.525, -0.25, 2.49375}, {3.525, 0, 2.49375}}},
      {{{2.9, 0, 2.475}, {2.9, -0.15, 2.475}, {3.45, -0.15, 2.5125}, {3.45, 0, 2.5125}}},
      {{{2.8, 0, 2.4}, {2.8, -0.15, 2.4}, {3.2, -0.15, 2.4}, {3.2, 0, 2.4}}}}},
}};

/// The 32 patches, rows and columns such that row direction × column direction points outward.
std::array<Patch, 32> patches();

}  // namespace shadowlab::scene::newell
