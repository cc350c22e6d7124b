#include "truth/candidates.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace shadowlab::truth {
namespace {

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};

float rounded_down(double value) {
  return std::nextafter(static_cast<float>(value), -std::numeric_limits<float>::infinity());
}
float rounded_up(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

// What the callbacks find through the geometry's user pointer.
struct Boxed {
  const Triangle* triangles = nullptr;
  double growth = 0;
};

// Embree hands the context that a query began with to the callbacks: the query rides on it.
struct Query : RTCIntersectContext {
  const void* self = nullptr;
  bool (*accepts)(const void*, const Triangle&) = nullptr;
  double (*nearer)(const void*, const Triangle&) = nullptr;
  double entry = 0;   // t at which the float ray starts
  double length = 1;  // of the direction: float distance = (t - entry) length
  double growth = 0;
};

}  // namespace

struct Candidates::Tree {
  std::vector<Triangle> triangles;
  double radius = 0;  // of the ball around the origin that holds every triangle
  double growth = 0;
  Boxed boxed;
  std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceRelease> device;
  std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneRelease> scene;

  // Cuts the segment to the ball and writes it as a float ray. False where it misses the ball.
  bool start(const Segment& segment, Query& query, RTCRay& ray) const;
};

bool Candidates::Tree::start(const Segment& segment, Query& query, RTCRay& ray) const {
  const double length = glm::length(segment.direction);
  if (!(length > 0)) return false;
  const glm::dvec3 along = segment.direction / length;
  // Distances along the line from the foot of the ball's centre.
  const double foot = -glm::dot(segment.origin, along);
  const glm::dvec3 offset = segment.origin + foot * along;
  const double reach = radius + 4 * growth;
  const double half_squared = reach * reach - glm::dot(offset, offset);
  if (!(half_squared >= 0)) return false;
  const double half = std::sqrt(half_squared) + growth;
  const double low = std::max(segment.low * length, foot - half);
  const double high = std::min(segment.high * length, foot + half);
  if (!(low <= high)) return false;
  const glm::dvec3 origin = segment.origin + low * along;
  query.entry = low / length;
  query.length = length;
  query.growth = growth;
  ray = {};
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(along.x);
  ray.dir_y = static_cast<float>(along.y);
  ray.dir_z = static_cast<float>(along.z);
  ray.tnear = 0;
  ray.tfar = rounded_up(high - low + growth);
  ray.mask = 0xFFFFFFFFu;
  return true;
}

namespace {

void grown_bounds(const RTCBoundsFunctionArguments* call) {
  const Boxed& boxed = *static_cast<const Boxed*>(call->geometryUserPtr);
  const Triangle& triangle = boxed.triangles[call->primID];
  const glm::dvec3 low = glm::min(triangle.a, glm::min(triangle.b, triangle.c)) - boxed.growth;
  const glm::dvec3 high = glm::max(triangle.a, glm::max(triangle.b, triangle.c)) + boxed.growth;
  *call->bounds_o = {rounded_down(low.x), rounded_down(low.y), rounded_down(low.z), 0,
                     rounded_up(high.x),  rounded_up(high.y),  rounded_up(high.z),  0};
}

const Triangle& proposed(void* user, unsigned primitive) {
  return static_cast<const Boxed*>(user)->triangles[primitive];
}

// Embree stops at a ray whose far end is -infinity.
void try_to_accept(const RTCOccludedFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto& query = *static_cast<Query*>(call->context);
  if (query.accepts(query.self, proposed(call->geometryUserPtr, call->primID))) {
    reinterpret_cast<RTCRay*>(call->ray)->tfar = -std::numeric_limits<float>::infinity();
  }
}

void try_nearer(const RTCIntersectFunctionNArguments* call) {
  if (call->valid[0] == 0) return;
  auto& query = *static_cast<Query*>(call->context);
  const double t = query.nearer(query.self, proposed(call->geometryUserPtr, call->primID));
  RTCRay& ray = reinterpret_cast<RTCRayHit*>(call->rayhit)->ray;
  const float far = rounded_up((t - query.entry) * query.length + query.growth);
  if (far < ray.tfar) ray.tfar = far;
}

}  // namespace

Candidates::Candidates(std::vector<Triangle> triangles) : tree_(std::make_unique<Tree>()) {
  Tree& tree = *tree_;
  tree.triangles = std::move(triangles);
  for (const Triangle& triangle : tree.triangles) {
    for (const glm::dvec3& vertex : {triangle.a, triangle.b, triangle.c}) {
      tree.radius = std::max(tree.radius, glm::length(vertex));
    }
  }
  tree.growth = std::max(tree.radius * 0x1p-20, 1e-30);
  if (tree.triangles.empty()) return;

  tree.device.reset(rtcNewDevice(nullptr));
  if (!tree.device) {
    throw MachineError("Embree does not start on this machine; the truth cannot be traced.");
  }
  tree.scene.reset(rtcNewScene(tree.device.get()));
  rtcSetSceneFlags(tree.scene.get(), RTC_SCENE_FLAG_ROBUST);
  tree.boxed = {tree.triangles.data(), tree.growth};
  RTCGeometry geometry = rtcNewGeometry(tree.device.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(tree.triangles.size()));
  rtcSetGeometryUserData(geometry, &tree.boxed);
  rtcSetGeometryBoundsFunction(geometry, grown_bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry, try_to_accept);
  rtcSetGeometryIntersectFunction(geometry, try_nearer);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(tree.scene.get(), geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree.scene.get());
  if (rtcGetDeviceError(tree.device.get()) != RTC_ERROR_NONE) {
    throw MachineError("Embree could not build its tree; the scene may be too large for memory.");
  }
}

Candidates::~Candidates() = default;
Candidates::Candidates(Candidates&&) noexcept = default;
Candidates& Candidates::operator=(Candidates&&) noexcept = default;

const std::vector<Triangle>& Candidates::triangles() const { return tree_->triangles; }

bool Candidates::any(const Segment& segment, const void* self, AcceptsCall call) const {
  Query query;
  RTCRay ray;
  if (!tree_->scene || !tree_->start(segment, query, ray)) return false;
  rtcInitIntersectContext(&query);
  query.self = self;
  query.accepts = call;
  rtcOccluded1(tree_->scene.get(), &query, &ray);
  return ray.tfar < 0;
}

void Candidates::visit(const Segment& segment, const void* self, NearerCall call) const {
  Query query;
  RTCRayHit hit{};
  if (!tree_->scene || !tree_->start(segment, query, hit.ray)) return;
  rtcInitIntersectContext(&query);
  query.self = self;
  query.nearer = call;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(tree_->scene.get(), &query, &hit);
}

}  // namespace shadowlab::truth
