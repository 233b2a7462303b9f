// The exact engines of this library.
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"
#include "clip/hybrid.hpp"
#include "compare/method.hpp"

#include <optional>

namespace sightline::comparison {
namespace {

/// T: a Tracer or a HybridTracer.
template <class T>
class Engine : public TimedMethod {
 protected:
  std::optional<T> tracer_;

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

class FrontToBack : public Engine<Tracer> {
 public:
  explicit FrontToBack(const Scene& scene) : tree_(scene) { tracer_.emplace(tree_); }

 private:
  BspTree tree_;
};

class Cells : public Engine<Tracer> {
 public:
  explicit Cells(const Scene& scene) : complex_(build(scene)) { tracer_.emplace(scene, complex_); }

 private:
  Complex complex_;
};

class Hybrid : public Engine<HybridTracer> {
 public:
  explicit Hybrid(const Scene& scene) { tracer_.emplace(scene); }
};

}  // namespace

std::unique_ptr<Method> make_front_to_back(const Scene& scene) { return std::make_unique<FrontToBack>(scene); }
std::unique_ptr<Method> make_cells(const Scene& scene) { return std::make_unique<Cells>(scene); }
std::unique_ptr<Method> make_hybrid(const Scene& scene) { return std::make_unique<Hybrid>(scene); }

}  // namespace sightline::comparison
