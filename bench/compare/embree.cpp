// Embree: item buffers (which polygon is seen at each pixel's centre), and the time of one incoherent ray.
#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

#include "bench/compare/method.hpp"
#include "bench/compare/pieces.hpp"
#include "models/random_numbers.hpp"

namespace sightline::peers {
namespace {

constexpr float far_away = std::numeric_limits<float>::infinity();

/// Triangles in floats about the scene's centre, in one tree; shared by all that shoot into it.
class Tree {
 public:
  Tree() : device_(rtcNewDevice("threads=1,set_affinity=0")) {
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
    rtcSetDeviceMemoryMonitorFunction(device_, &Tree::count, this);
  }
  ~Tree() {
    clear();
    rtcReleaseDevice(device_);
  }
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;

  /// Once a scene, whoever comes first.
  Cost prepare(const Scene& scene) {
    if (source_ == &scene) return cost_;
    clear();
    const double start = cpu_seconds();
    const Pieces pieces = pieces_of(scene);
    const auto& vertices = scene.soup().vertices;
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const PointId v : pieces.corners) {
      low = glm::min(low, vertices[v]);
      high = glm::max(high, vertices[v]);
    }
    centre_ = pieces.corners.empty() ? glm::dvec3(0) : (low + high) / 2.0;
    const std::size_t triangles = pieces.corners.size() - 2 * pieces.size();
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* places =
        static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                    3 * sizeof(float), std::max<std::size_t>(vertices.size(), 1)));
    auto* corners =
        static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                       3 * sizeof(unsigned), std::max<std::size_t>(triangles, 1)));
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      for (int k = 0; k < 3; ++k)
        places[3 * v + static_cast<std::size_t>(k)] = static_cast<float>(vertices[v][k] - centre_[k]);
    }
    polygon_.clear();
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
      const auto loop = pieces.of(k);
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        unsigned* triangle = corners + 3 * polygon_.size();
        triangle[0] = loop[0];
        triangle[1] = loop[i];
        triangle[2] = loop[i + 1];
        polygon_.push_back(pieces.polygon[k]);
      }
    }
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    source_ = &scene;
    cost_ = {cpu_seconds() - start, static_cast<std::size_t>(std::max<std::int64_t>(bytes_, 0))};
    return cost_;
  }

  void clear() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
    scene_ = nullptr;
    source_ = nullptr;
  }

  RTCScene scene() const { return scene_; }
  PolygonId polygon(unsigned primitive) const { return polygon_[primitive]; }
  glm::vec3 place(const glm::dvec3& p) const { return p - centre_; }

 private:
  static bool count(void* self, ssize_t bytes, bool) {
    static_cast<Tree*>(self)->bytes_ += bytes;
    return true;
  }

  RTCDevice device_;
  RTCScene scene_ = nullptr;
  const Scene* source_ = nullptr;
  std::atomic<std::int64_t> bytes_{0};
  Cost cost_;
  glm::dvec3 centre_{0};
  std::vector<PolygonId> polygon_;  // of each triangle
};

class ItemBuffer : public Method {
 public:
  ItemBuffer(std::shared_ptr<Tree> tree, unsigned size)
      : Method("embree-" + std::to_string(size), Kind::peer),
        tree_(std::move(tree)),
        size_(size),
        items_(size * size) {}

  Cost prepare(const Scene& scene) override { return tree_->prepare(scene); }
  void release() override { tree_->clear(); }

  /// Packets of 4 by 4 pixels.
  Outcome map(const Camera& camera, Want want) override {
    const double start = cpu_seconds();
    const glm::vec3 eye = tree_->place(camera.eye);
    const double step = 1.0 / size_;
    const glm::vec3 across = camera.right * step, upwards = camera.up * step;
    const glm::vec3 first = camera.forward + (0.5 * step - 0.5) * (camera.right + camera.up);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) int valid[16];
    std::fill(std::begin(valid), std::end(valid), -1);
    RTCRayHit16 rays;
    for (unsigned y = 0; y < size_; y += 4) {
      for (unsigned x = 0; x < size_; x += 4) {
        for (unsigned k = 0; k < 16; ++k) {
          const glm::vec3 along =
              first + static_cast<float>(x + k % 4) * across + static_cast<float>(y + k / 4) * upwards;
          rays.ray.org_x[k] = eye.x;
          rays.ray.org_y[k] = eye.y;
          rays.ray.org_z[k] = eye.z;
          rays.ray.dir_x[k] = along.x;
          rays.ray.dir_y[k] = along.y;
          rays.ray.dir_z[k] = along.z;
          rays.ray.tnear[k] = 0;
          rays.ray.tfar[k] = far_away;
          rays.ray.time[k] = 0;
          rays.ray.mask[k] = ~0U;
          rays.ray.id[k] = 0;
          rays.ray.flags[k] = 0;
          rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
          rays.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, tree_->scene(), &context, &rays);
        for (unsigned k = 0; k < 16; ++k) {
          items_[(y + k / 4) * size_ + x + k % 4] =
              rays.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? none : tree_->polygon(rays.hit.primID[k]);
        }
      }
    }
    Outcome out;
    out.seconds = cpu_seconds() - start;
    if (want == Want::visible) {
      out.gives_visible = true;
      out.visible = items_;
      std::ranges::sort(out.visible);
      out.visible.erase(std::ranges::unique(out.visible).begin(), out.visible.end());
      if (!out.visible.empty() && out.visible.back() == none) out.visible.pop_back();
    }
    return out;
  }

 private:
  std::shared_ptr<Tree> tree_;
  unsigned size_;
  std::vector<PolygonId> items_;
};

/// The unit of the measure: one ray at a time from the eye through a random point of the window, the mean of many.
class Ray : public Method {
 public:
  explicit Ray(std::shared_ptr<Tree> tree) : Method("embree-ray", Kind::ray), tree_(std::move(tree)) {}

  Cost prepare(const Scene& scene) override { return tree_->prepare(scene); }
  void release() override { tree_->clear(); }

  Outcome map(const Camera& camera, Want) override {
    constexpr std::size_t count = 1 << 14;
    models::RandomNumbers random(1);
    directions_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      const double s = random.below(1 << 30) * 0x1p-30 - 0.5, t = random.below(1 << 30) * 0x1p-30 - 0.5;
      directions_.emplace_back(camera.forward + s * camera.right + t * camera.up);
    }
    const glm::vec3 eye = tree_->place(camera.eye);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    const double start = cpu_seconds();
    unsigned hits = 0;
    for (const glm::vec3& along : directions_) {
      RTCRayHit ray{};
      ray.ray.org_x = eye.x;
      ray.ray.org_y = eye.y;
      ray.ray.org_z = eye.z;
      ray.ray.dir_x = along.x;
      ray.ray.dir_y = along.y;
      ray.ray.dir_z = along.z;
      ray.ray.tfar = far_away;
      ray.ray.mask = ~0U;
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(tree_->scene(), &context, &ray);
      hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
    Outcome out;
    out.seconds = (cpu_seconds() - start) / static_cast<double>(count);
    out.faces = hits;
    return out;
  }

 private:
  std::shared_ptr<Tree> tree_;
  std::vector<glm::vec3> directions_;
};

}  // namespace

Methods make_embree() {
  const auto tree = std::make_shared<Tree>();
  Methods all;
  all.push_back(std::make_unique<Ray>(tree));
  for (const unsigned size : {256U, 512U, 1024U, 2048U}) all.push_back(std::make_unique<ItemBuffer>(tree, size));
  return all;
}

}  // namespace sightline::peers
