// Embree's tree, and packets of 16 rays.
#include "sample/ray_caster.hpp"

#include "sample/places.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace sightline {
namespace {

/// Hits from behind are none, where polygons are opaque from one side only. Embree's normal is (b - a) x (c - a).
void refuse_backs(const RTCFilterFunctionNArguments* about) {
  for (unsigned k = 0; k < about->N; ++k) {
    if (about->valid[k] == 0) continue;
    const float along = RTCRayN_dir_x(about->ray, about->N, k) * RTCHitN_Ng_x(about->hit, about->N, k) +
                        RTCRayN_dir_y(about->ray, about->N, k) * RTCHitN_Ng_y(about->hit, about->N, k) +
                        RTCRayN_dir_z(about->ray, about->N, k) * RTCHitN_Ng_z(about->hit, about->N, k);
    if (along > 0) about->valid[k] = 0;
  }
}

/// Embree ends the process where a ray has a larger number, or none.
constexpr float largest_number = 1.8e18F;

bool can_be_cast(const Ray& ray) {
  const auto fine = [](float x) { return std::abs(x) <= largest_number; };
  return fine(ray.origin.x) && fine(ray.origin.y) && fine(ray.origin.z) && fine(ray.direction.x) &&
         fine(ray.direction.y) && fine(ray.direction.z);
}

void prepare(RTCRayHit16& packet, unsigned k, const Ray& ray) {
  packet.ray.org_x[k] = ray.origin.x;
  packet.ray.org_y[k] = ray.origin.y;
  packet.ray.org_z[k] = ray.origin.z;
  packet.ray.dir_x[k] = ray.direction.x;
  packet.ray.dir_y[k] = ray.direction.y;
  packet.ray.dir_z[k] = ray.direction.z;
  packet.ray.tnear[k] = 0;
  packet.ray.tfar[k] = ray.length;
  packet.ray.time[k] = 0;
  packet.ray.mask[k] = ~0U;
  packet.ray.id[k] = 0;
  packet.ray.flags[k] = 0;
  packet.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
}

}  // namespace

struct RayCaster::Tree {
  Tree() : device(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device == nullptr) throw std::runtime_error("Embree gives no device");
    const auto count = [](void* tree, ssize_t change, bool) {
      static_cast<Tree*>(tree)->bytes += change;
      return true;
    };
    rtcSetDeviceMemoryMonitorFunction(device, count, this);
  }
  ~Tree() {
    if (scene != nullptr) rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  RTCDevice device;
  RTCScene scene = nullptr;
  std::atomic<std::ptrdiff_t> bytes{0};
  std::vector<PolygonId> polygons;  // of each triangle
};

RayCaster::RayCaster(const Scene& scene) : tree_(std::make_unique<Tree>()) {
  const Places places = places_of(scene);
  const std::size_t triangles = places.corners.size() - 2 * places.size();
  RTCGeometry geometry = rtcNewGeometry(tree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                              3 * sizeof(float), places.corners.size() + 1));
  auto* triangle = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles));
  for (const glm::dvec3& p : places.corners) {
    for (int k = 0; k < 3; ++k) *corners++ = static_cast<float>(p[k]);
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    for (std::uint32_t c = places.first[k] + 1; c + 1 < places.first[k + 1]; ++c) {
      *triangle++ = places.first[k];
      *triangle++ = c;
      *triangle++ = c + 1;
      tree_->polygons.push_back(places.polygons[k]);
    }
  }
  rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
  if (scene.options().one_sided) rtcSetGeometryIntersectFilterFunction(geometry, refuse_backs);
  rtcCommitGeometry(geometry);
  tree_->scene = rtcNewScene(tree_->device);
  rtcSetSceneBuildQuality(tree_->scene, RTC_BUILD_QUALITY_HIGH);
  if (triangles > 0) rtcAttachGeometry(tree_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(tree_->scene);
}

RayCaster::~RayCaster() = default;

void RayCaster::cast(std::span<const Ray> rays, std::span<RayHit> hits, bool coherent) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  alignas(64) int valid[16];
  RTCRayHit16 packet;
  for (std::size_t first = 0; first < rays.size(); first += 16) {
    const auto count = static_cast<unsigned>(std::min<std::size_t>(16, rays.size() - first));
    for (unsigned k = 0; k < 16; ++k) {
      const Ray& ray = rays[first + std::min(k, count - 1)];
      valid[k] = k < count && can_be_cast(ray) ? -1 : 0;
      prepare(packet, k, ray);
    }
    rtcIntersect16(valid, tree_->scene, &context, &packet);
    for (unsigned k = 0; k < count; ++k) {
      const bool hit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
      hits[first + k] = hit ? RayHit{tree_->polygons[packet.hit.primID[k]], packet.ray.tfar[k]} : RayHit{};
    }
  }
}

std::size_t RayCaster::bytes() const { return static_cast<std::size_t>(tree_->bytes.load()); }

}  // namespace sightline
