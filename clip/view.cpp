#include "clip/view.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "exact/rounding.hpp"

namespace sightline {
namespace {

using Vector = std::array<Integer, 3>;

/// The direction in which (s, t) is seen, times some power of two.
Vector ray(const Camera& camera, const glm::dvec2& st) {
  const auto rational = [](double x) { return mpq_class(x); };
  const mpq_class s = rational(st.x) - mpq_class(1, 2), t = rational(st.y) - mpq_class(1, 2);
  std::array<mpq_class, 3> r;
  Integer denominator = 1;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    r[i] = rational(camera.forward[k]) + s * rational(camera.right[k]) + t * rational(camera.up[k]);
    denominator = lcm(denominator, r[i].get_den());
  }
  Vector v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = r[k].get_num() * (denominator / r[k].get_den());
  return v;
}

/// +1: the turn from a-b to b-c is counter-clockwise in s, t.
Sign turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  const mpq_class x = (mpq_class(b.x) - mpq_class(a.x)) * (mpq_class(c.y) - mpq_class(b.y)) -
                      (mpq_class(b.y) - mpq_class(a.y)) * (mpq_class(c.x) - mpq_class(b.x));
  return sgn(x);
}

/// The direction in which a strictly convex polygon runs. Throws if it is none.
Sign direction(std::span<const glm::dvec2> p) {
  const std::size_t n = p.size();
  const auto fail = [] { throw std::invalid_argument("a texture region is not a strictly convex polygon"); };
  if (n < 3) fail();
  for (const glm::dvec2& x : p)
    if (!std::isfinite(x.x) || !std::isfinite(x.y)) fail();
  const Sign first = turn(p[0], p[1], p[2]);
  // Every other corner lies on one and the same side of every side: no turn, and no second time round.
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t other = 0; other < n; ++other)
      if (other != k && other != (k + 1) % n && (first == 0 || turn(p[k], p[(k + 1) % n], p[other]) != first)) fail();
  return first;
}

}  // namespace

void check_region(const TextureRegion& region) { direction(region.points); }

ClipView::ClipView(const Scene& scene, const Camera& camera, std::uint32_t index,
                   std::span<const TextureRegion> regions)
    : scene_(scene),
      camera_(camera),
      index_(index),
      window_(camera.forward, camera.right, camera.up),
      table_(scene.planes()) {
  table_.reset(scene.planes(), scene.grid().point(camera.eye));
  for (const auto side : {Window::left, Window::right, Window::bottom, Window::top}) {
    frame_.push_back({window_.side(table_, side), {ClipSide::window, index, static_cast<std::uint32_t>(side), none}});
  }
  for (std::size_t k = 0; k < regions.size(); ++k) {
    std::vector<NamedLine> sides = sides_of(regions[k], static_cast<std::uint32_t>(k));
    if (regions[k].interior) {
      frame_.insert(frame_.end(), sides.begin(), sides.end());
    } else {
      holes_.push_back(std::move(sides));
    }
  }
}

SightlineRef ClipView::named(const ClipSide& side) const {
  const auto in = [&](std::span<const NamedLine> lines) {
    const auto found = std::find_if(lines.begin(), lines.end(), [&](const NamedLine& l) { return l.name == side; });
    return found == lines.end() ? SightlineRef{} : found->line;
  };
  SightlineRef line = in(frame_);
  for (std::size_t k = 0; k < holes_.size() && line.id == none; ++k) line = in(holes_[k]);
  return line;
}

std::vector<NamedLine> ClipView::sides_of(const TextureRegion& region, std::uint32_t index) {
  const Sign turning = direction(region.points);
  std::vector<NamedLine> sides;
  const std::size_t n = region.points.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Vector a = ray(camera_, region.points[k]), b = ray(camera_, region.points[(k + 1) % n]);
    const Vector normal{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    // In a camera of handedness +1, right x up points backwards: of counter-clockwise points a x b does too, towards
    // the inside. In front of the eye, that is: det(a, b, c) for c to the left is a positive multiple of det(forward,
    // right, up) times the turn, and that has the sign of -handedness.
    const SightlineRef line = table_.of_normal(normal);
    sides.push_back({turning * window_.handedness() < 0 ? line : -line,
                     {ClipSide::region, index_, index, static_cast<std::uint32_t>(k)}});
  }
  return sides;
}

}  // namespace sightline
