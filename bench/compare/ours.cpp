// The engines of this library.
#include "beam/trace.hpp"
#include "bench/compare/method.hpp"
#include "bsp/build.hpp"
#include "bsp/tree.hpp"

#include <algorithm>
#include <optional>

namespace sightline::peers {
namespace {

/// What a finished map says to the comparison.
Outcome outcome_of(const VisibilityMap& map, double seconds, Want want) {
  Outcome out;
  out.seconds = seconds;
  out.faces = static_cast<std::uint32_t>(map.faces.size());
  out.edges = static_cast<std::uint32_t>(map.edges.size());
  out.vertices = static_cast<std::uint32_t>(map.vertices.size());
  if (want != Want::visible) return out;
  out.gives_visible = true;
  for (const MapFace& f : map.faces) {
    if (f.polygon == none) continue;
    out.visible.push_back(f.polygon);
    for (const PolygonId p : map.coincident_of(f)) out.coincident.emplace_back(f.polygon, p);
  }
  std::ranges::sort(out.visible);
  out.visible.erase(std::ranges::unique(out.visible).begin(), out.visible.end());
  return out;
}

/// A tracer, whatever engine it has.
class Ours : public Method {
 public:
  explicit Ours(std::string name) : Method(std::move(name), Kind::map) {}

  Outcome map(const Camera& camera, Want want) override {
    const double start = cpu_seconds();
    tracer_->trace(camera, map_);
    return outcome_of(map_, cpu_seconds() - start, want);
  }

 protected:
  std::optional<Tracer> tracer_;

 private:
  VisibilityMap map_;
};

/// Engine `front-to-back`: the polygons in the order of a tree.
class FrontToBack : public Ours {
 public:
  FrontToBack() : Ours("front-to-back") {}

  Cost prepare(const Scene& scene) override {
    const double start = cpu_seconds();
    tree_.emplace(scene);
    tracer_.emplace(*tree_);
    return {cpu_seconds() - start, tree_->size().bytes};
  }

  void release() override {
    tracer_.reset();
    tree_.reset();
  }

 private:
  std::optional<BspTree> tree_;
};

/// The same without what not every caller needs: no map is put together, or narrow beams are not followed.
class Less : public Method {
 public:
  enum What { visible, areas, wide };
  explicit Less(What what)
      : Method(what == visible ? "visible-only"
               : what == areas ? "areas-only"
                               : "min-angle-1e-9",
               Kind::peer),
        what_(what) {}

  Cost prepare(const Scene& scene) override {
    const double start = cpu_seconds();
    tree_.emplace(scene);
    tracer_.emplace(*tree_, TraceOptions{.min_angle = what_ == wide ? 1e-9 : 0});
    return {cpu_seconds() - start, tree_->size().bytes};
  }

  Outcome map(const Camera& camera, Want want) override {
    const double start = cpu_seconds();
    if (what_ == wide) {
      tracer_->trace(camera, map_);
      return outcome_of(map_, cpu_seconds() - start, want);
    }
    if (what_ == visible) {
      tracer_->visible(camera, seen_);
    } else {
      tracer_->areas(camera, areas_);
    }
    Outcome out;
    out.seconds = cpu_seconds() - start;
    out.gives_visible = want == Want::visible;
    if (!out.gives_visible) return out;
    if (what_ == visible) out.visible = seen_;
    for (const PolygonArea& a : areas_) {
      if (what_ == areas && a.polygon != none) out.visible.push_back(a.polygon);
    }
    return out;
  }

  void release() override {
    tracer_.reset();
    tree_.reset();
  }

 private:
  What what_;
  std::optional<BspTree> tree_;
  std::optional<Tracer> tracer_;
  VisibilityMap map_;
  std::vector<PolygonId> seen_;
  std::vector<PolygonArea> areas_;
};

/// Engine `cells`: beams through a winged-pair complex.
class Cells : public Ours {
 public:
  Cells() : Ours("cells") {}

  Cost prepare(const Scene& scene) override {
    const double start = cpu_seconds();
    complex_ = build(scene);
    tracer_.emplace(scene, complex_);
    return {cpu_seconds() - start, complex_bytes(complex_)};
  }

  void release() override {
    tracer_.reset();
    complex_ = {};
  }

 private:
  Complex complex_;
};

}  // namespace

Methods make_ours() {
  Methods all;
  all.push_back(std::make_unique<FrontToBack>());
  all.push_back(std::make_unique<Cells>());
  for (const Less::What what : {Less::visible, Less::areas, Less::wide}) all.push_back(std::make_unique<Less>(what));
  return all;
}

}  // namespace sightline::peers
