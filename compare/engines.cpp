// The exact engines of this library.
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"
#include "compare/method.hpp"

#include <optional>

namespace sightline::comparison {
namespace {

class Engine : public TimedMethod {
 protected:
  std::optional<Tracer> tracer_;

 private:
  void look(const Camera& camera) override { tracer_->trace(camera, map_); }

  void tell(Answer& answer) override {
    answer.reported.clear();
    for (const MapFace& f : map_.faces) answer.reported.push_back(f.polygon);
    tidy(answer.reported);
    draw(map_, answer.shown.emplace<Drawing>());
  }

  VisibilityMap map_;
};

class FrontToBack : public Engine {
 public:
  explicit FrontToBack(const Scene& scene) : tree_(scene) { tracer_.emplace(tree_); }

 private:
  BspTree tree_;
};

class Cells : public Engine {
 public:
  explicit Cells(const Scene& scene) : complex_(build(scene)) { tracer_.emplace(scene, complex_); }

 private:
  Complex complex_;
};

}  // namespace

std::unique_ptr<Method> make_front_to_back(const Scene& scene, unsigned) {
  return std::make_unique<FrontToBack>(scene);
}
std::unique_ptr<Method> make_cells(const Scene& scene, unsigned) { return std::make_unique<Cells>(scene); }

}  // namespace sightline::comparison
