// CGAL's Envelope_3 over Epeck: exact, like ours. The view is mapped projectively, exactly, so that the nearest surface
// along a ray becomes the lowest surface above a point.
#include <CGAL/Env_surface_data_traits_3.h>
#include <CGAL/Env_triangle_traits_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/envelope_3.h>

#include <algorithm>
#include <array>

#include "bench/compare/piecewise.hpp"

namespace sightline::peers {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT::ET;  // exact rationals
using Traits = CGAL::Env_surface_data_traits_3<CGAL::Env_triangle_traits_3<Kernel>, PolygonId>;
using Diagram = CGAL::Envelope_diagram_2<Traits>;

template <class T>
using Triple = std::array<T, 3>;
template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Triple<T> minus(const Triple<T>& a, const Triple<T>& b) {
  return {T(a[0] - b[0]), T(a[1] - b[1]), T(a[2] - b[2])};
}
template <class T>
Triple<T> triple(const glm::dvec3& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

/// Coordinates along forward, right and up from the eye, times one positive number.
template <class T>
class CameraAxes {
 public:
  CameraAxes(const Camera& camera, bool mirrored) : eye_(triple<T>(camera.eye)) {
    const Triple<T> f = triple<T>(camera.forward), r = triple<T>(camera.right), u = triple<T>(camera.up);
    rows_ = {cross(r, u), cross(u, f), cross(f, r)};
    if (mirrored) {
      for (auto& row : rows_) row = {T(-row[0]), T(-row[1]), T(-row[2])};
    }
  }
  Triple<T> place(const glm::dvec3& p) const {
    const Triple<T> from = minus(triple<T>(p), eye_);
    return {dot(rows_[0], from), dot(rows_[1], from), dot(rows_[2], from)};
  }

 private:
  Triple<T> eye_;
  std::array<Triple<T>, 3> rows_;
};

/// Twice the amount by which a place is inside of a side of the view.
template <class T>
T inside(const Triple<T>& p, int side) {
  switch (side) {
    case 0:
      return p[0] + 2 * p[1];
    case 1:
      return p[0] - 2 * p[1];
    case 2:
      return p[0] + 2 * p[2];
    default:
      return p[0] - 2 * p[2];
  }
}

void clip(std::vector<Triple<Number>>& loop, int side) {
  std::vector<Triple<Number>> kept;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Triple<Number>&p = loop[k], &q = loop[(k + 1) % loop.size()];
    const Number a = inside(p, side), b = inside(q, side);
    if (a >= 0) kept.push_back(p);
    if ((a > 0 && b < 0) || (a < 0 && b > 0)) {
      const Number at = a / (a - b);
      kept.push_back(
          {Number(p[0] + at * (q[0] - p[0])), Number(p[1] + at * (q[1] - p[1])), Number(p[2] + at * (q[2] - p[2]))});
    }
  }
  loop.swap(kept);
}

class Envelope : public PiecewisePeer {
 public:
  Envelope() : PiecewisePeer("cgal") {}

  Outcome map(const Camera& camera, Want) override {
    const double start = cpu_seconds();
    const std::vector<Traits::Surface_3> surfaces = surfaces_of(camera);
    Diagram diagram;
    CGAL::lower_envelope_3(surfaces.begin(), surfaces.end(), diagram);
    Outcome out;
    out.seconds = cpu_seconds() - start;
    out.faces = static_cast<std::uint32_t>(diagram.number_of_faces());
    out.edges = static_cast<std::uint32_t>(diagram.number_of_edges());
    out.vertices = static_cast<std::uint32_t>(diagram.number_of_vertices());
    out.gives_visible = true;
    for (auto face = diagram.faces_begin(); face != diagram.faces_end(); ++face) {
      if (face->number_of_surfaces() == 0) continue;
      PolygonId lowest = none;
      for (auto s = face->surfaces_begin(); s != face->surfaces_end(); ++s) lowest = std::min(lowest, s->data());
      out.visible.push_back(lowest);
    }
    std::ranges::sort(out.visible);
    out.visible.erase(std::ranges::unique(out.visible).begin(), out.visible.end());
    return out;
  }

 private:
  /// Pieces that may meet the view, by interval arithmetic: exact numbers would be dear for a large scene.
  std::vector<std::uint32_t> candidates(const Camera& camera, bool mirrored) const {
    using Interval = CGAL::Interval_nt<false>;
    const Interval::Protector rounding;
    const CameraAxes<Interval> axes(camera, mirrored);
    std::vector<std::uint32_t> out;
    for (std::uint32_t k = 0; k < pieces_.size(); ++k) {
      unsigned outside = 15;
      for (const PointId v : pieces_.of(k)) {
        const auto place = axes.place(scene_->soup().vertices[v]);
        for (int side = 0; side < 4; ++side) {
          if (!(inside(place, side).sup() <= 0)) outside &= ~(1U << side);
        }
        if (outside == 0) break;
      }
      if (outside == 0) out.push_back(k);
    }
    return out;
  }

  std::vector<Traits::Surface_3> surfaces_of(const Camera& camera) const {
    const auto f = triple<Number>(camera.forward);
    const bool mirrored = dot(f, cross(triple<Number>(camera.right), triple<Number>(camera.up))) < 0;
    const CameraAxes<Number> axes(camera, mirrored);
    std::vector<Traits::Surface_3> out;
    for (const std::uint32_t k : candidates(camera, mirrored)) {
      std::vector<Triple<Number>> loop;
      for (const PointId v : pieces_.of(k)) loop.push_back(axes.place(scene_->soup().vertices[v]));
      if (edge_on(loop)) continue;
      for (int side = 0; side < 4 && !loop.empty(); ++side) clip(loop, side);
      std::vector<Kernel::Point_3> points;
      for (const auto& p : loop) {  // depth is positive: only the eye itself has none within the view
        points.emplace_back(Kernel::FT(Number(p[1] / p[0])), Kernel::FT(Number(p[2] / p[0])),
                            Kernel::FT(Number(-1 / p[0])));
      }
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const Kernel::Triangle_3 triangle(points[0], points[i], points[i + 1]);
        if (triangle.is_degenerate()) continue;
        out.emplace_back(Traits::Base_traits_3::Surface_3(triangle), pieces_.polygon[k]);
      }
    }
    return out;
  }

  /// Does the piece's plane hold the eye?
  static bool edge_on(const std::vector<Triple<Number>>& loop) {
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      if (dot(cross(loop[0], loop[i]), loop[i + 1]) != 0) return false;
    }
    return true;
  }
};

}  // namespace

Methods make_cgal() {
  Methods all;
  all.push_back(std::make_unique<Envelope>());
  return all;
}

}  // namespace sightline::peers
