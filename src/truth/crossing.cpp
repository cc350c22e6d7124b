#include "truth/crossing.h"

#include <array>
#include <cmath>
#include <span>

namespace shadowlab::truth {
namespace {

constexpr double kHalfUlp = 0x1p-53;  // the relative error of one rounded operation

// A sum of doubles that do not overlap, smallest first: exact (Shewchuk 1997, grow-expansion).
class ExactSum {
 public:
  void add(double term) {
    if (term == 0) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const double sum = term + parts_[i];
      const double part = sum - term;
      const double error = (term - (sum - part)) + (parts_[i] - part);
      term = sum;
      if (error != 0) parts_[kept++] = error;
    }
    if (term != 0) parts_[kept++] = term;
    size_ = kept;
  }

  // Right sign, zero only if the sum is zero: the parts do not overlap, so the last one outweighs
  // the others together.
  double value() const {
    double total = 0;
    for (std::size_t i = 0; i < size_; ++i) total += parts_[i];
    return total;
  }

 private:
  std::array<double, 200> parts_{};  // 6 products of 3 differences: 6 × 2³ × 4 = 192 terms at most
  std::size_t size_ = 0;
};

// p - q = head + tail, exactly.
std::array<double, 2> exact_difference(double p, double q) {
  const double head = p - q;
  const double part = p - head;
  return {head, (p - (head + part)) + (part - q)};
}

using ExactVector = std::array<std::array<double, 2>, 3>;

void add_product(ExactSum& sum, double p, double q, double r) {
  if (p == 0 || q == 0 || r == 0) return;
  const double pq = p * q;
  const double pq_tail = std::fma(p, q, -pq);
  const double head = pq * r;
  const double tail = pq_tail * r;
  sum.add(std::fma(pq_tail, r, -tail));
  sum.add(tail);
  sum.add(std::fma(pq, r, -head));
  sum.add(head);
}

double exact_determinant(const ExactVector& u, const ExactVector& v, const ExactVector& w) {
  constexpr int kEven[3][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}};
  ExactSum sum;
  for (const auto& [i, j, k] : kEven) {
    for (const double p : u[static_cast<std::size_t>(i)]) {
      for (int half = 0; half < 4; ++half) {
        const auto q = static_cast<std::size_t>(half & 1), r = static_cast<std::size_t>(half >> 1);
        const auto jj = static_cast<std::size_t>(j), kk = static_cast<std::size_t>(k);
        add_product(sum, p, v[jj][q], w[kk][r]);
        add_product(sum, -p, v[kk][q], w[jj][r]);
      }
    }
  }
  return sum.value();
}

ExactVector exact_difference(glm::dvec3 p, glm::dvec3 q) {
  return {exact_difference(p.x, q.x), exact_difference(p.y, q.y), exact_difference(p.z, q.z)};
}

// The sign of p q - r s. Rounding is monotonic, so the difference of the rounded products is never
// of the wrong sign, only zero; then the two errors, which fma gives exactly, decide.
double difference_of_products(double p, double q, double r, double s) {
  const double pq = p * q;
  const double rs = r * s;
  if (pq != rs) return pq - rs;
  return std::fma(p, q, -pq) - std::fma(r, s, -rs);
}

}  // namespace

double side(const Triangle& triangle, glm::dvec4 p) {
  const glm::dvec3 point(p);
  const glm::dvec3 u = triangle.b - triangle.a;
  const glm::dvec3 v = triangle.c - triangle.a;
  const glm::dvec3 w = p.w == 0 ? point : point - triangle.a;
  const glm::dvec3 plus(v.y * w.z, v.z * w.x, v.x * w.y);
  const glm::dvec3 minus(v.z * w.y, v.x * w.z, v.y * w.x);
  const double determinant = glm::dot(u, plus - minus);
  // Each of the six products carries at most 8 rounded operations, the differences included.
  const double bound = 16 * kHalfUlp * glm::dot(glm::abs(u), glm::abs(plus) + glm::abs(minus));
  if (std::abs(determinant) > bound || bound == 0) return determinant;
  const ExactVector exact_w = p.w == 0 ? ExactVector{{{point.x, 0}, {point.y, 0}, {point.z, 0}}}
                                       : exact_difference(point, triangle.a);
  return exact_determinant(exact_difference(triangle.b, triangle.a),
                           exact_difference(triangle.c, triangle.a), exact_w);
}

bool on_plane(const Triangle& triangle, const PlanePoint& p, double height) {
  const glm::dvec3 normal = glm::cross(triangle.b - triangle.a, triangle.c - triangle.a);
  return std::abs(height) <= glm::dot(glm::abs(normal), p.rounding);
}

Line::Line(glm::dvec3 origin, glm::dvec3 direction) : origin_(origin) {
  const glm::dvec3 length = glm::abs(direction);
  z_ = length.x > length.y ? (length.x > length.z ? 0 : 2) : (length.y > length.z ? 1 : 2);
  x_ = (z_ + 1) % 3;
  y_ = (z_ + 2) % 3;
  shear_x_ = direction[x_] / direction[z_];
  shear_y_ = direction[y_] / direction[z_];
  scale_z_ = 1 / direction[z_];
}

glm::dvec2 Line::projected(glm::dvec3 vertex) const {
  const glm::dvec3 from = vertex - origin_;
  return {from[x_] - shear_x_ * from[z_], from[y_] - shear_y_ * from[z_]};
}

std::optional<Line::Crossing> Line::crossing(const Triangle& triangle) const {
  const glm::dvec2 a = projected(triangle.a);
  const glm::dvec2 b = projected(triangle.b);
  const glm::dvec2 c = projected(triangle.c);
  const Crossing areas{difference_of_products(c.x, b.y, c.y, b.x),
                       difference_of_products(a.x, c.y, a.y, c.x),
                       difference_of_products(b.x, a.y, b.y, a.x)};
  const bool outside_left = areas.u < 0 || areas.v < 0 || areas.w < 0;
  const bool outside_right = areas.u > 0 || areas.v > 0 || areas.w > 0;
  if (outside_left == outside_right) return std::nullopt;  // both: outside; neither: seen edge-on
  return areas;
}

double Line::parameter(const Triangle& triangle, const Crossing& crossing) const {
  const double sum = crossing.u + crossing.v + crossing.w;
  return (crossing.u * (triangle.a[z_] - origin_[z_]) +
          crossing.v * (triangle.b[z_] - origin_[z_]) +
          crossing.w * (triangle.c[z_] - origin_[z_])) *
         scale_z_ / sum;
}

PlanePoint point_at(const Triangle& triangle, const Line::Crossing& crossing) {
  const double sum = crossing.u + crossing.v + crossing.w;
  const glm::dvec3 ab = triangle.b - triangle.a;
  const glm::dvec3 ac = triangle.c - triangle.a;
  const glm::dvec3 point = triangle.a + (crossing.v / sum * ab + crossing.w / sum * ac);
  // The shares are ≤ 1 and, whatever they are, name a point of the plane; what is rounded after
  // them is 3 operations on each product and the last addition. Where the triangle is flat in a
  // coordinate nothing is rounded.
  const glm::dvec3 spread = glm::abs(ab) + glm::abs(ac);
  glm::dvec3 rounding(0);
  for (int axis = 0; axis < 3; ++axis) {
    if (spread[axis] != 0)
      rounding[axis] = kHalfUlp * (2 * std::abs(point[axis]) + 4 * spread[axis]);
  }
  return {point, rounding};
}

}  // namespace shadowlab::truth
