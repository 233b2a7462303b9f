// An item buffer by ray casting: Embree, a ray through the middle of each pixel, in floats.
#include "compare/method.hpp"
#include "compare/places.hpp"

#include <embree3/rtcore.h>

#include <limits>
#include <stdexcept>

namespace sightline::comparison {
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

class Rays : public TimedMethod {
 public:
  Rays(const Scene& scene, unsigned size) : source_(scene), device_(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
    pixels_.size = size;
    pixels_.items.resize(std::size_t{size} * size);
    const Places places = places_of(scene);
    const std::size_t triangles = places.corners.size() - 2 * places.size();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
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
        polygon_.push_back(places.polygons[k]);
      }
    }
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    if (scene.options().one_sided) rtcSetGeometryIntersectFilterFunction(geometry, refuse_backs);
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    if (triangles > 0) rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~Rays() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

 private:
  /// Packets of 4 by 4 pixels; at the window's end some of their rays are idle.
  void look(const Camera& camera) override {
    const unsigned size = pixels_.size;
    const glm::vec3 eye = place_of_eye(source_, camera.eye);
    const double step = 1.0 / size;
    const glm::vec3 across = step * camera.right, upwards = step * camera.up;
    const glm::vec3 first = camera.forward + (0.5 * step - 0.5) * (camera.right + camera.up);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    RTCRayHit16 rays;
    for (unsigned y = 0; y < size; y += 4) {
      for (unsigned x = 0; x < size; x += 4) {
        for (unsigned k = 0; k < 16; ++k) {
          const unsigned px = x + k % 4, py = y + k / 4;
          valid[k] = px < size && py < size ? -1 : 0;
          const glm::vec3 along = first + static_cast<float>(px) * across + static_cast<float>(py) * upwards;
          rays.ray.org_x[k] = eye.x;
          rays.ray.org_y[k] = eye.y;
          rays.ray.org_z[k] = eye.z;
          rays.ray.dir_x[k] = along.x;
          rays.ray.dir_y[k] = along.y;
          rays.ray.dir_z[k] = along.z;
          rays.ray.tnear[k] = 0;
          rays.ray.tfar[k] = std::numeric_limits<float>::infinity();
          rays.ray.time[k] = 0;
          rays.ray.mask[k] = ~0U;
          rays.ray.id[k] = 0;
          rays.ray.flags[k] = 0;
          rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
          rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, scene_, &context, &rays);
        for (unsigned k = 0; k < 16; ++k) {
          if (valid[k] == 0) continue;
          pixels_.items[std::size_t{y + k / 4} * size + x + k % 4] =
              rays.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? none : polygon_[rays.hit.primID[k]];
        }
      }
    }
  }

  void tell(Answer& answer) override {
    answer.reported = pixels_.items;
    tidy(answer.reported);
    answer.shown = pixels_;
  }

  const Scene& source_;
  RTCDevice device_;
  RTCScene scene_ = nullptr;
  std::vector<PolygonId> polygon_;  // of each triangle
  Pixels pixels_;
};

}  // namespace

std::unique_ptr<Method> make_rays(const Scene& scene, unsigned size) { return std::make_unique<Rays>(scene, size); }

}  // namespace sightline::comparison
