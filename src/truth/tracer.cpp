#include "truth/tracer.h"

#include <atomic>
#include <cmath>

#include <fmt/format.h>

#include "core/error.h"
#include "truth/parallel_rows.h"
#include "truth/traced_scene.h"
#include "truth/tracer_parts.h"

namespace shadowlab::truth {
namespace {

constexpr int kFirstSamples = 16;

image::FloatImage filled(int width, int height, float value) {
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, std::vector<float>(pixels, value)};
}

// A mean, and how far it may be off.
struct Estimate {
  double mean = 0;
  double error = 0;
};

// Of n nested points, n a power of two ≥ 4, from the standard error of its four quarters. Each
// quarter is itself a net, but of a sequence whose nets together are better than four independent
// ones, so this errs on the safe side. n points that agree leave room for an edge that cuts off
// about 1/n.
Estimate estimate(const std::vector<std::uint8_t>& lit, std::size_t n) {
  const std::size_t quarter = n / 4;
  double means[4], total = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    int count = 0;
    for (std::size_t i = q * quarter; i < (q + 1) * quarter; ++i) count += lit[i];
    means[q] = count / static_cast<double>(quarter);
    total += means[q];
  }
  const double mean = total / 4;
  double squares = 0;
  for (const double m : means) squares += (m - mean) * (m - mean);
  const double unseen = 0.5 / static_cast<double>(n);
  return {mean, std::sqrt(squares / 12 + unseen * unseen)};
}

std::uint64_t pixel_seed(std::uint64_t seed, int x, int y) {
  return seed * 0x9E3779B97F4A7C15u + (static_cast<std::uint64_t>(y) << 32) +
         static_cast<std::uint64_t>(x);
}

int power_of_two_below(int n) {
  int power = 1;
  while (power <= n / 2) power *= 2;
  return power;
}

bool is_hard(const scene::Light& light) {
  return light.shape == scene::Light::Shape::point || light.position.w == 0;
}

}  // namespace

Tracer::Tracer(const scene::Scene& scene) {
  for (const scene::Object& object : scene.objects) {
    if (object.mesh) scene::check(*object.mesh);
  }
  parts_ = std::make_unique<Parts>(scene);
}

Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

std::size_t Tracer::triangle_count() const { return parts_->triangle_count(); }

bool Tracer::blocked(glm::dvec3 from, glm::dvec4 light) const {
  return parts_->blocked(from - parts_->center(), parts_->relative(light));
}

SurfaceImage Tracer::surfaces(const scene::Camera& camera, int width, int height) const {
  const View view(camera, parts_->center(), width, height);
  SurfaceImage image{width, height, {}};
  image.surfaces.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  parallel_rows(height, 0, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const auto hit = parts_->first_hit(view, x + 0.5, y + 0.5);
      if (!hit) continue;
      const Triangle& triangle = *hit->triangle;
      Surface& surface =
          image.surfaces[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)];
      surface = {triangle.object, triangle.index, hit->at.point + parts_->center(), hit->depth,
                 glm::normalize(glm::cross(triangle.b - triangle.a, triangle.c - triangle.a))};
    }
  });
  return image;
}

image::FloatImage Tracer::visibility(const scene::Camera& camera, const scene::Light& light,
                                     int width, int height, const Sampling& sampling,
                                     int threads) const {
  return soft_visibility(camera, light, width, height, sampling, threads).visibility;
}

SoftTruth Tracer::soft_visibility(const scene::Camera& camera, const scene::Light& light, int width,
                                  int height, const Sampling& sampling, int threads) const {
  if (sampling.error && !(*sampling.error > 0 && sampling.samples >= kFirstSamples)) {
    throw InputError(fmt::format(
        "Adaptive sampling takes an error above 0 and at least {} samples, not {} and {}.",
        kFirstSamples, *sampling.error, sampling.samples));
  }
  const View view(camera, parts_->center(), width, height);
  const bool hard = is_hard(light);
  const bool adaptive = sampling.error && !hard;
  std::vector<glm::dvec4> points;
  if (hard) points.push_back(parts_->relative(light.position));
  if (!hard && !adaptive) {
    for (const glm::dvec3 point :
         shadow::samples(light, sampling.samples, sampling.pattern, sampling.seed)) {
      points.push_back(parts_->relative(glm::dvec4(point, 1)));
    }
  }

  std::atomic<std::uint64_t> rays{0};
  std::atomic<std::size_t> unconverged{0};
  SoftTruth truth{.visibility = filled(width, height, 1)};
  parallel_rows(height, threads, [&](int y) {
    const Triangle* last = nullptr;
    std::vector<std::uint8_t> lit;
    std::uint64_t spent = 0;
    float* const row = truth.visibility.values.data() +
                       static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
    for (int x = 0; x < width; ++x) {
      const auto hit = parts_->first_hit(view, x + 0.5, y + 0.5);
      if (!hit) continue;
      lit.clear();
      const auto try_point = [&](glm::dvec4 point) {
        lit.push_back(!parts_->shadowed(*hit, view.eye, point, last));
      };
      if (adaptive) {
        const std::uint64_t seed = pixel_seed(sampling.seed, x, y);
        const auto most = static_cast<std::size_t>(power_of_two_below(sampling.samples));
        Estimate now;
        for (std::size_t n = kFirstSamples; n <= most; n *= 2) {
          while (lit.size() < n) {
            const glm::dvec2 square =
                shadow::owen_point(static_cast<std::uint32_t>(lit.size()), seed);
            try_point(parts_->relative(glm::dvec4(shadow::point_on_light(light, square), 1)));
          }
          now = estimate(lit, n);
          if (now.error <= *sampling.error) break;
        }
        unconverged += now.error > *sampling.error;
        row[x] = static_cast<float>(now.mean);
      } else {
        for (const glm::dvec4 point : points) try_point(point);
        std::size_t count = 0;
        for (const std::uint8_t one : lit) count += one;
        row[x] = static_cast<float>(static_cast<double>(count) / static_cast<double>(lit.size()));
      }
      spent += lit.size();
    }
    rays += spent;
  });
  truth.rays = rays;
  truth.unconverged = unconverged;
  return truth;
}

}  // namespace shadowlab::truth
