#include "image/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/difference.h"

namespace shadowlab::image {
namespace {

// One channel of a picture; and three of a colour, whose space the names say.
struct Plane {
  int width, height;
  std::vector<double> values;

  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
};
using Color = std::array<double, 3>;
using Planes = std::array<Plane, 3>;

// ---- Colour spaces (paper, section 4.1) ----

// Linear sRGB to XYZ, IEC 61966-2-1 with the primaries' matrix at full precision.
constexpr double rgb_to_xyz[3][3] = {
    {10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
    {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
    {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};

// XYZ of white, (1, 1, 1): the sums of the rows.
constexpr Color white = {rgb_to_xyz[0][0] + rgb_to_xyz[0][1] + rgb_to_xyz[0][2],
                         rgb_to_xyz[1][0] + rgb_to_xyz[1][1] + rgb_to_xyz[1][2],
                         rgb_to_xyz[2][0] + rgb_to_xyz[2][1] + rgb_to_xyz[2][2]};

double linear_from_srgb(double s) {
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

// XYZ relative to white.
Color relative_xyz(const Color& rgb) {
  Color xyz;
  for (std::size_t i = 0; i < 3; ++i) {
    xyz[i] = (rgb_to_xyz[i][0] * rgb[0] + rgb_to_xyz[i][1] * rgb[1] + rgb_to_xyz[i][2] * rgb[2]) /
             white[i];
  }
  return xyz;
}

Color rgb_from_relative_xyz(const Color& relative) {
  const auto& m = rgb_to_xyz;
  const Color xyz = {relative[0] * white[0], relative[1] * white[1], relative[2] * white[2]};
  Color rgb;
  const auto cofactor = [&](std::size_t row, std::size_t column) {
    const std::size_t r0 = (row + 1) % 3, r1 = (row + 2) % 3;
    const std::size_t c0 = (column + 1) % 3, c1 = (column + 2) % 3;
    return m[r0][c0] * m[r1][c1] - m[r0][c1] * m[r1][c0];
  };
  const double determinant =
      m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    rgb[i] =
        (cofactor(0, i) * xyz[0] + cofactor(1, i) * xyz[1] + cofactor(2, i) * xyz[2]) / determinant;
  }
  return rgb;
}

// Linearised L*a*b*: luminance, red-green, yellow-blue.
Color ycxcz(const Color& xyz) {
  return {116 * xyz[1] - 16, 500 * (xyz[0] - xyz[1]), 200 * (xyz[1] - xyz[2])};
}

Color relative_xyz_from_ycxcz(const Color& c) {
  const double y = (c[0] + 16) / 116;
  return {y + c[1] / 500, y, y - c[2] / 200};
}

Color lab(const Color& xyz) {
  const auto f = [](double t) {
    constexpr double d = 6.0 / 29.0;
    return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29.0;
  };
  const double x = f(xyz[0]), y = f(xyz[1]), z = f(xyz[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// The Hunt effect: colours look more different the lighter they are.
Color hunt(const Color& lab_color) {
  const double s = 0.01 * lab_color[0];
  return {lab_color[0], s * lab_color[1], s * lab_color[2]};
}

// City block in lightness, Euclid in hue and chroma: for large differences (Abasi et al. 2020).
double hyab(const Color& a, const Color& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

// ---- Filters ----

// A filter f(x) g(y) as its two factors, both of 2 radius + 1 taps.
struct Separable {
  std::vector<double> along_x;
  std::vector<double> along_y;
};

std::vector<double> taps(int radius, auto&& f) {
  std::vector<double> values;
  for (int x = -radius; x <= radius; ++x) values.push_back(f(static_cast<double>(x)));
  return values;
}

// The border's pixels repeat beyond it.
void convolve_row(std::span<const double> row, std::span<const double> filter,
                  std::span<double> out, std::vector<double>& padded) {
  const std::size_t radius = filter.size() / 2;
  padded.assign(row.size() + 2 * radius, row.front());
  std::copy(row.begin(), row.end(), padded.begin() + static_cast<std::ptrdiff_t>(radius));
  std::fill(padded.end() - static_cast<std::ptrdiff_t>(radius), padded.end(), row.back());
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t k = 0; k < filter.size(); ++k) {
    const double weight = filter[k];
    for (std::size_t x = 0; x < out.size(); ++x) out[x] += weight * padded[x + k];
  }
}

Plane convolve(const Plane& in, const Separable& filter) {
  const auto width = static_cast<std::size_t>(in.width);
  Plane rows(in.width, in.height), out(in.width, in.height);
  std::vector<double> padded;
  for (std::size_t at = 0; at < in.values.size(); at += width) {
    convolve_row(std::span(in.values).subspan(at, width), filter.along_x,
                 std::span(rows.values).subspan(at, width), padded);
  }
  const int radius = static_cast<int>(filter.along_y.size() / 2);
  for (int y = 0; y < in.height; ++y) {
    double* to = out.values.data() + static_cast<std::size_t>(y) * width;
    for (int k = -radius; k <= radius; ++k) {
      const double weight = filter.along_y[static_cast<std::size_t>(k + radius)];
      const int from_y = std::clamp(y + k, 0, in.height - 1);
      const double* from = rows.values.data() + static_cast<std::size_t>(from_y) * width;
      for (std::size_t x = 0; x < width; ++x) to[x] += weight * from[x];
    }
  }
  return out;
}

// ---- What the eye does not resolve (section 4.1.2) ----

// Contrast sensitivity of a channel: Σ a √(π/b) exp(-π² r² / b), r in degrees (table 1).
struct Gaussian {
  double a, b;
};
constexpr double widest = 0.04;  // the largest b: all channels are filtered to the same radius

Plane blur(const Plane& channel, std::span<const Gaussian> sensitivity, double pixels_per_degree) {
  constexpr double pi = std::numbers::pi;
  const int radius =
      static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
  std::vector<std::vector<double>> profiles;
  std::vector<double> weights;
  double total = 0;
  for (const Gaussian& g : sensitivity) {
    profiles.push_back(taps(radius, [&](double x) {
      const double degrees = x / pixels_per_degree;
      return std::exp(-pi * pi * degrees * degrees / g.b);
    }));
    double sum = 0;
    for (const double tap : profiles.back()) sum += tap;
    weights.push_back(g.a * std::sqrt(pi / g.b));
    total += weights.back() * sum * sum;
  }
  Plane blurred(channel.width, channel.height);
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    std::vector<double> scaled = profiles[i];
    for (double& tap : scaled) tap *= weights[i] / total;
    const Plane part = convolve(channel, {scaled, profiles[i]});
    for (std::size_t p = 0; p < part.values.size(); ++p) blurred.values[p] += part.values[p];
  }
  return blurred;
}

// ---- Colour (section 4.1) ----

constexpr double color_exponent = 0.7;  // q_c

// What remains of a picture in the eye, in Hunt-adjusted L*a*b*.
std::vector<Color> perceived(const Planes& picture, double pixels_per_degree) {
  constexpr Gaussian achromatic[] = {{1, 0.0047}};
  constexpr Gaussian red_green[] = {{1, 0.0053}};
  constexpr Gaussian blue_yellow[] = {{34.1, 0.04}, {13.5, 0.025}};
  const Planes blurred = {blur(picture[0], achromatic, pixels_per_degree),
                          blur(picture[1], red_green, pixels_per_degree),
                          blur(picture[2], blue_yellow, pixels_per_degree)};
  std::vector<Color> colors(picture[0].values.size());
  for (std::size_t p = 0; p < colors.size(); ++p) {
    Color rgb = rgb_from_relative_xyz(relative_xyz_from_ycxcz(
        {blurred[0].values[p], blurred[1].values[p], blurred[2].values[p]}));
    for (double& channel : rgb) channel = std::clamp(channel, 0.0, 1.0);
    colors[p] = hunt(lab(relative_xyz(rgb)));
  }
  return colors;
}

// Maps a colour distance to [0, 1]: up to p_c of the largest one linearly to [0, p_t], the rest,
// where differences no longer look larger, to [p_t, 1].
double compressed(double distance) {
  constexpr double p_c = 0.4, p_t = 0.95;
  static const double largest = std::pow(
      hyab(hunt(lab(relative_xyz({0, 1, 0}))), hunt(lab(relative_xyz({0, 0, 1})))), color_exponent);
  const double e = std::pow(distance, color_exponent), knee = p_c * largest;
  return e < knee ? p_t * e / knee : p_t + (e - knee) / (largest - knee) * (1 - p_t);
}

// ---- Features: edges and points (section 4.2) ----

// Scales the positive taps to a sum of 1 and the negative ones to -1.
void balance(std::vector<double>& filter) {
  double positive = 0, negative = 0;
  for (const double tap : filter) (tap > 0 ? positive : negative) += tap;
  for (double& tap : filter) tap /= tap > 0 ? positive : -negative;
}

struct Features {
  std::vector<double> edges, points;  // magnitude in each pixel
};

std::vector<double> magnitude(const Plane& in, const Separable& filter) {
  const Plane x = convolve(in, filter), y = convolve(in, {filter.along_y, filter.along_x});
  std::vector<double> values(in.values.size());
  for (std::size_t p = 0; p < values.size(); ++p) values[p] = std::hypot(x.values[p], y.values[p]);
  return values;
}

// First and second derivatives of a Gaussian as wide as the eye's edge detectors, 0.082 degrees.
Features features(const Plane& luminance, double pixels_per_degree) {
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](double x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  std::vector<double> smooth = taps(radius, gaussian);
  balance(smooth);
  std::vector<double> edge = taps(radius, [&](double x) { return -x * gaussian(x); });
  balance(edge);
  std::vector<double> point =
      taps(radius, [&](double x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); });
  balance(point);
  return {magnitude(luminance, {edge, smooth}), magnitude(luminance, {point, smooth})};
}

Planes ycxcz_planes(const Image& image) {
  std::array<double, 256> linear;
  for (std::size_t i = 0; i < 256; ++i) linear[i] = linear_from_srgb(static_cast<double>(i) / 255);
  const Plane empty(image.width, image.height);
  Planes planes = {empty, empty, empty};
  for (std::size_t p = 0; p < empty.values.size(); ++p) {
    const std::uint8_t* rgb = image.rgba.data() + 4 * p;
    const Color c = ycxcz(relative_xyz({linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]}));
    for (std::size_t i = 0; i < 3; ++i) planes[i].values[p] = c[i];
  }
  return planes;
}

// The achromatic channel in [0, 1], which features are found in.
Plane luminance_of(const Planes& ycxcz_picture) {
  Plane luminance = ycxcz_picture[0];
  for (double& value : luminance.values) value = (value + 16) / 116;
  return luminance;
}

}  // namespace

Flip flip(const Image& reference, const Image& test, double pixels_per_degree) {
  expect_one_size(reference, test);
  const Planes a = ycxcz_planes(reference), b = ycxcz_planes(test);
  const auto colors_a = perceived(a, pixels_per_degree), colors_b = perceived(b, pixels_per_degree);
  const Features features_a = features(luminance_of(a), pixels_per_degree);
  const Features features_b = features(luminance_of(b), pixels_per_degree);
  Flip result;
  result.error = {reference.width, reference.height, std::vector<float>(colors_a.size())};
  double sum = 0;
  for (std::size_t p = 0; p < colors_a.size(); ++p) {
    const double color = compressed(hyab(colors_a[p], colors_b[p]));
    const double feature = std::max(std::abs(features_a.edges[p] - features_b.edges[p]),
                                    std::abs(features_a.points[p] - features_b.points[p]));
    // A difference of features raises that of colour: the exponent falls from 1 to 0 (q_f = 1/2).
    const double error = std::pow(color, 1 - std::sqrt(feature / std::numbers::sqrt2));
    result.error.values[p] = static_cast<float>(error);
    result.worst = std::max(result.worst, error);
    sum += error;
  }
  if (!colors_a.empty()) result.mean = sum / static_cast<double>(colors_a.size());
  return result;
}

}  // namespace shadowlab::image
