#include "clip/side_planes.hpp"

#include <stdexcept>

#include "scene/surface_list.hpp"

namespace sightline {
namespace {

using Vector = std::array<Integer, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Integer dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

SidePlanes::SidePlanes(const Scene& scene, std::span<const Camera> cameras,
                       std::span<const std::vector<TextureRegion>> regions)
    : scene_(scene) {
  for (std::uint32_t c = 0; c < cameras.size(); ++c) {
    views_.emplace_back(
        scene, cameras[c], c,
        c < regions.size() ? std::span<const TextureRegion>(regions[c]) : std::span<const TextureRegion>());
  }
}

ExactRow SidePlanes::plane(PlaneId p) const {
  const PlaneTable& planes = scene_.planes();
  return {{planes.integer(p, 0), planes.integer(p, 1), planes.integer(p, 2)}, planes.integer(p, 3)};
}

/// n.x = n.eye, where the eye has steps of 2^-shift.
ExactRow SidePlanes::through_eye(const ClipView& view, SightlineRef line) const {
  ExactRow row{view.table().normal(line.id), 0};
  const GridPoint& eye = view.table().eye();
  row.d = dot(row.n, eye.c);
  for (Integer& n : row.n) n <<= static_cast<mp_bitcnt_t>(eye.shift);
  return row;
}

ExactRow SidePlanes::side(const ClipSide& side, SurfaceId surface) {
  switch (side.kind) {
    case ClipSide::edge: {
      // Through both points, along the axis in which the surface's plane is steepest.
      const auto axis =
          static_cast<std::size_t>(steepest_axis(scene_.planes().approx(scene_.surfaces()[surface].plane)));
      const Vector a = scene_.points().point(side.a), b = scene_.points().point(side.b);
      Vector up{0, 0, 0};
      up[axis] = 1;
      ExactRow row{cross({b[0] - a[0], b[1] - a[1], b[2] - a[2]}, up), 0};
      row.d = dot(row.n, a);
      return row;
    }
    case ClipSide::wedge: {
      ClipView& view = views_[side.camera];
      return through_eye(view, view.table().of_points(side.a, side.b));
    }
    case ClipSide::window:
    case ClipSide::region: {
      const ClipView& view = views_[side.camera];
      return through_eye(view, view.named(side));
    }
    case ClipSide::intersection:
      return this->surface(side.a);
  }
  throw std::logic_error("clip: a side of no kind");
}

ExactRow SidePlanes::meet(const ExactRow& a, const ExactRow& b, const ExactRow& c) {
  const Vector bc = cross(b.n, c.n), ca = cross(c.n, a.n), ab = cross(a.n, b.n);
  ExactRow point;
  point.d = dot(a.n, bc);
  for (std::size_t k = 0; k < 3; ++k) point.n[k] = bc[k] * a.d + ca[k] * b.d + ab[k] * c.d;
  if (point.d > 0) return point;
  point.d = -point.d;
  for (Integer& n : point.n) n = -n;
  return point;
}

bool SidePlanes::holds(const ExactRow& plane, const ExactRow& point) {
  return dot(plane.n, point.n) == plane.d * point.d;
}

Sign SidePlanes::compare(const ExactRow& a, const ExactRow& b, std::size_t k) {
  return sgn(Integer(a.n[k] * b.d - b.n[k] * a.d));
}

}  // namespace sightline
