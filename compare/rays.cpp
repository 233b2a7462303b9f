// An item buffer by ray casting: a ray through the middle of each pixel.
#include "compare/memory.hpp"
#include "compare/method.hpp"
#include "sample/places.hpp"
#include "sample/ray_caster.hpp"

#include <algorithm>
#include <array>

namespace sightline::comparison {
namespace {

class Rays : public TimedMethod, public TellsMemory {
 public:
  Rays(const Scene& scene, unsigned size) : scene_(scene), caster_(scene) {
    pixels_.size = size;
    pixels_.items.resize(std::size_t{size} * size);
  }
  MethodMemory memory() const override { return {caster_.bytes() + pixels_.items.size() * sizeof(PolygonId), 0}; }

 private:
  /// Blocks of 4 by 4 pixels, smaller at the window's end.
  void look(const Camera& camera) override {
    const unsigned size = pixels_.size;
    const glm::vec3 eye = place_of_eye(scene_, camera.eye);
    const double step = 1.0 / size;
    const glm::vec3 across = step * camera.right, upwards = step * camera.up;
    const glm::vec3 first = camera.forward + (0.5 * step - 0.5) * (camera.right + camera.up);
    std::array<Ray, 16> rays;
    std::array<RayHit, 16> hits;
    for (unsigned y = 0; y < size; y += 4) {
      const unsigned rows = std::min(4U, size - y);
      for (unsigned x = 0; x < size; x += 4) {
        const unsigned columns = std::min(4U, size - x), count = rows * columns;
        for (unsigned k = 0; k < count; ++k) {
          const auto px = static_cast<float>(x + k % columns), py = static_cast<float>(y + k / columns);
          rays[k] = {eye, first + px * across + py * upwards};
        }
        caster_.cast({rays.data(), count}, {hits.data(), count}, true);
        for (unsigned k = 0; k < count; ++k) {
          pixels_.items[std::size_t{y + k / columns} * size + x + k % columns] = hits[k].polygon;
        }
      }
    }
  }

  void tell(Answer& answer) override {
    answer.reported = pixels_.items;
    tidy(answer.reported);
    answer.shown = pixels_;
  }

  const Scene& scene_;
  RayCaster caster_;
  Pixels pixels_;
};

}  // namespace

std::unique_ptr<Method> make_rays(const Scene& scene, unsigned size) { return std::make_unique<Rays>(scene, size); }

}  // namespace sightline::comparison
