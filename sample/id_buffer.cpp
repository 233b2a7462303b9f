// Clipping and filling of polygons in doubles.
#include "sample/id_buffer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace sightline {
namespace {

bool shows_front(std::span<const glm::dvec3> corners, const glm::dvec3& eye) {
  glm::dvec3 normal(0);
  for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
    normal += glm::cross(corners[k] - corners[0], corners[k + 1] - corners[0]);
  }
  return glm::dot(normal, eye - corners[0]) > 0;
}

/// How far inside of a side of the view: left, right, bottom, top, and in front of the eye by a billionth of the
/// scene.
double inside(const glm::dvec3& p, int side) {
  switch (side) {
    case 0:
      return p.x / 2 + p.y;
    case 1:
      return p.x / 2 - p.y;
    case 2:
      return p.x / 2 + p.z;
    case 3:
      return p.x / 2 - p.z;
    default:
      return p.x - 1e-9;
  }
}

}  // namespace

std::size_t IdBuffer::bytes() const {
  return items_.size() * sizeof(PolygonId) + nearest_.size() * sizeof(float) + places_.bytes();
}

IdBuffer::IdBuffer(const Scene& scene, std::uint32_t size)
    : scene_(scene),
      places_(places_of(scene)),
      size_(size),
      items_(std::size_t{size} * size),
      nearest_(items_.size()) {}

std::span<const PolygonId> IdBuffer::draw(const Camera& camera, std::span<const char> wanted) {
  std::fill(items_.begin(), items_.end(), none);
  std::fill(nearest_.begin(), nearest_.end(), 0.0F);
  // p - eye = depth forward + across right + upwards up, so that s = across / depth + 1/2, and t likewise.
  const glm::dmat3 frame = glm::inverse(glm::dmat3(camera.forward, camera.right, camera.up));
  const glm::dvec3 eye = place_of_eye(scene_, camera.eye);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (!wanted.empty() && wanted[places_.polygons[k]] == 0) continue;
    const auto corners = places_.of(k);
    if (scene_.options().one_sided && !shows_front(corners, eye)) continue;
    loop_.clear();
    for (const glm::dvec3& p : corners) loop_.push_back(frame * (p - eye));
    for (int side = 0; side < 5 && !loop_.empty(); ++side) clip(side);
    if (!loop_.empty()) fill(places_.polygons[k]);
  }
  return items_;
}

void IdBuffer::clip(int side) {
  spare_.clear();
  for (std::size_t k = 0; k < loop_.size(); ++k) {
    const glm::dvec3 &p = loop_[k], &q = loop_[(k + 1) % loop_.size()];
    const double a = inside(p, side), b = inside(q, side);
    if (a >= 0) spare_.push_back(p);
    if ((a < 0) != (b < 0)) spare_.push_back(p + a / (a - b) * (q - p));
  }
  std::swap(loop_, spare_);
}

/// The middles of pixels within the loop, row by row, where it is the nearest so far. Inverse depth is linear in the
/// window: what is given at the two ends of a row's stretch is given between them.
void IdBuffer::fill(PolygonId polygon) {
  const double size = size_;
  double lowest = size, highest = 0;
  for (glm::dvec3& p : loop_) {
    p = {(p.y / p.x + 0.5) * size, (p.z / p.x + 0.5) * size, 1 / p.x};
    lowest = std::min(lowest, p.y);
    highest = std::max(highest, p.y);
  }
  const auto row = [&](double t) {  // the first whose middle is at t or above it
    return static_cast<unsigned>(std::clamp(std::ceil(t - 0.5), 0.0, size));
  };
  for (unsigned y = row(lowest), end = row(highest); y < end; ++y) {
    const double t = y + 0.5;
    glm::dvec2 left(size, 0), right(0, 0);  // s and inverse depth
    for (std::size_t k = 0; k < loop_.size(); ++k) {
      const glm::dvec3 &p = loop_[k], &q = loop_[(k + 1) % loop_.size()];
      if ((p.y <= t) == (q.y <= t)) continue;
      const double part = (t - p.y) / (q.y - p.y);
      const glm::dvec2 at(p.x + part * (q.x - p.x), p.z + part * (q.z - p.z));
      if (at.x < left.x) left = at;
      if (at.x >= right.x) right = at;
    }
    if (left.x >= right.x) continue;
    const double slope = (right.y - left.y) / (right.x - left.x);
    const std::size_t start = std::size_t{y} * size_;
    for (unsigned x = row(left.x), stop = row(right.x); x < stop; ++x) {
      const auto depth = static_cast<float>(left.y + (x + 0.5 - left.x) * slope);
      if (depth <= nearest_[start + x]) continue;
      nearest_[start + x] = depth;
      items_[start + x] = polygon;
    }
  }
}

}  // namespace sightline
