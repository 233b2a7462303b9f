#include "bench/clip/weiler_atherton.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "bench/cpu_seconds.hpp"

namespace sightline::bench {
namespace {

using Figure = std::vector<glm::dvec3>;

/// n.x > d inside; n of length 1.
struct HalfSpace {
  glm::dvec3 n;
  double d;
};

HalfSpace half_space(const glm::dvec3& normal, const glm::dvec3& point) {
  const glm::dvec3 n = glm::normalize(normal);
  return {n, glm::dot(n, point)};
}

double area(const Figure& f) {
  glm::dvec3 sum{0};
  for (std::size_t k = 2; k < f.size(); ++k) sum += glm::cross(f[k - 1] - f[0], f[k] - f[0]);
  return glm::length(sum) / 2;
}
glm::dvec3 normal(const Figure& f) {
  glm::dvec3 sum{0};
  for (std::size_t k = 2; k < f.size(); ++k) sum += glm::cross(f[k - 1] - f[0], f[k] - f[0]);
  return sum;
}

/// A piece in a view: its box in the window, if it has one, and its nearest depth.
struct Item {
  WaPiece piece;
  glm::dvec2 low{-1e300}, high{1e300};
  double depth = 0;
  std::size_t origin = 0;  // the item that it was before this view
  bool hidden = false;
};

class View {
 public:
  View(const Scene& scene, const Camera& camera, double tolerance, double threshold)
      : scene_(scene),
        camera_(camera),
        inverse_(glm::inverse(glm::dmat3(camera.forward, camera.right, camera.up))),
        tolerance_(tolerance),
        threshold_(threshold) {
    for (int k = 0; k < 4; ++k) {
      const double sign = k % 2 == 0 ? -0.5 : 0.5;
      const glm::dvec3 along = k < 2 ? camera.up : camera.right, across = k < 2 ? camera.right : camera.up;
      glm::dvec3 n = glm::cross(camera.forward + sign * across, along);
      if (glm::dot(n, camera.forward) < 0) n = -n;
      window_.push_back(half_space(n, camera.eye));
    }
  }

  /// False: the time, by cpu_seconds(), was over before the view was done.
  bool run(std::vector<WaPiece>& pieces, std::uint32_t index, double end) {
    std::vector<WaPiece> done;
    items_.clear();
    for (WaPiece& piece : pieces) enter(std::move(piece), done);
    std::vector<std::size_t> order(items_.size());
    alive_.assign(items_.size(), 1);
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = items_[k].origin = k;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return items_[a].depth < items_[b].depth; });
    // A piece clips as it was before this view cut it, if any of it is left: Weiler and Atherton's advice.
    const std::vector<Item> whole = items_;
    bool in_time = true;
    for (const std::size_t k : order) {
      in_time = in_time && cpu_seconds() < end;
      if (in_time && alive_[k] > 0) clip_all(whole[k]);
    }
    for (Item& item : items_) {
      if (!item.hidden) item.piece.cameras.push_back(index);
      done.push_back(std::move(item.piece));
    }
    pieces = std::move(done);
    return in_time;
  }

 private:
  void enter(WaPiece&& piece, std::vector<WaPiece>& done) {
    const double away = glm::dot(normal(piece.corner), piece.corner[0] - camera_.eye);
    if (scene_.options().one_sided ? away > -tolerance_ * tolerance_ : std::abs(away) <= tolerance_ * tolerance_) {
      done.push_back(std::move(piece));
      return;
    }
    std::vector<Figure> outside;
    Figure inside;
    if (!cut(piece.corner, window_, inside, outside)) {
      done.push_back(std::move(piece));
      return;
    }
    if (!outside.empty() && area(piece.corner) >= threshold_) {
      for (Figure& f : outside) done.push_back({piece.polygon, std::move(f), piece.cameras});
      piece.corner = std::move(inside);
    }
    add(std::move(piece));
  }
  void add(WaPiece&& piece) {
    Item item{std::move(piece)};
    bool first = true;
    for (const glm::dvec3& x : item.piece.corner) {
      const glm::dvec3 v = inverse_ * (x - camera_.eye);
      const double distance = glm::distance(x, camera_.eye);
      item.depth = first ? distance : std::min(item.depth, distance);
      if (v.x <= tolerance_) {
        item.low = glm::dvec2(-1e300);
        item.high = glm::dvec2(1e300);
        break;
      }
      const glm::dvec2 st(v.y / v.x, v.z / v.x);
      item.low = first ? st : glm::min(item.low, st);
      item.high = first ? st : glm::max(item.high, st);
      first = false;
    }
    items_.push_back(std::move(item));
  }

  /// Cuts away what lies inside of all half spaces; false if nothing does.
  bool cut(const Figure& figure, std::span<const HalfSpace> spaces, Figure& inside,
           std::vector<Figure>& outside) const {
    inside = figure;
    outside.clear();
    std::vector<double> at;
    for (const HalfSpace& space : spaces) {
      at.clear();
      bool in = false, out = false;
      for (const glm::dvec3& x : inside) {
        at.push_back(glm::dot(space.n, x) - space.d);
        in = in || at.back() > tolerance_;
        out = out || at.back() < -tolerance_;
      }
      if (!in) return false;
      if (!out) continue;
      Figure parts[2];
      for (std::size_t k = 0; k < inside.size(); ++k) {
        const std::size_t next = k + 1 == inside.size() ? 0 : k + 1;
        if (at[k] >= -tolerance_) parts[1].push_back(inside[k]);
        if (at[k] <= tolerance_) parts[0].push_back(inside[k]);
        if ((at[k] > tolerance_ && at[next] < -tolerance_) || (at[k] < -tolerance_ && at[next] > tolerance_)) {
          const glm::dvec3 x = inside[k] + (inside[next] - inside[k]) * (at[k] / (at[k] - at[next]));
          parts[0].push_back(x);
          parts[1].push_back(x);
        }
      }
      outside.push_back(std::move(parts[0]));
      inside = std::move(parts[1]);
    }
    return true;
  }

  void clip_all(const Item& clipper) {
    const Figure& figure = clipper.piece.corner;
    const glm::dvec2 low = clipper.low, high = clipper.high;
    const glm::dvec3 away = normal(figure);
    const double side = glm::dot(away, figure[0] - camera_.eye);  // > 0: the normal points away from the eye
    std::vector<HalfSpace> shadow{half_space(side > 0 ? away : -away, figure[0])};
    for (std::size_t k = 0; k < figure.size(); ++k) {
      const glm::dvec3 p = figure[k] - camera_.eye, q = figure[(k + 1) % figure.size()] - camera_.eye;
      const glm::dvec3 n = glm::cross(p, q);
      if (glm::length(n) <= tolerance_ * tolerance_) continue;
      shadow.push_back(half_space(side > 0 ? n : -n, camera_.eye));
    }
    Figure inside;
    std::vector<Figure> outside;
    const std::size_t count = items_.size();
    for (std::size_t k = 0; k < count; ++k) {
      if (items_[k].origin == clipper.origin || items_[k].hidden || items_[k].low.x >= high.x ||
          items_[k].high.x <= low.x || items_[k].low.y >= high.y || items_[k].high.y <= low.y)
        continue;
      if (!cut(items_[k].piece.corner, shadow, inside, outside)) continue;
      if (!outside.empty() && area(items_[k].piece.corner) < threshold_) continue;
      items_[k].hidden = true;
      const std::size_t origin = items_[k].origin;
      alive_[origin] += outside.size();
      --alive_[origin];
      for (Figure& f : outside) {
        add({items_[k].piece.polygon, std::move(f), items_[k].piece.cameras});
        items_.back().origin = origin;
      }
      items_[k].piece.corner = inside;
    }
  }

  const Scene& scene_;
  Camera camera_;
  glm::dmat3 inverse_;
  double tolerance_, threshold_;
  std::vector<HalfSpace> window_;
  std::vector<Item> items_;
  std::vector<std::size_t> alive_;  // by origin: how many parts of it are not hidden
};

}  // namespace

WaResult weiler_atherton(const Scene& scene, std::span<const Camera> cameras, double threshold, double limit) {
  const double end = cpu_seconds() + limit;
  WaResult result;
  std::vector<WaPiece>& pieces = result.pieces;
  glm::dvec3 low{1e300}, high{-1e300};
  for (const glm::dvec3& v : scene.soup().vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  for (const Surface& s : scene.surfaces()) {
    WaPiece piece{s.polygon, {}, {}};
    for (const SurfaceEdge& e : scene.edges(s))
      if (e.corner != none) piece.corner.push_back(scene.soup().vertices[e.corner]);
    if (s.flipped) std::reverse(piece.corner.begin(), piece.corner.end());  // as the polygon runs
    if (piece.corner.size() >= 3) pieces.push_back(std::move(piece));
  }
  const double tolerance = 1e-9 * glm::distance(low, high);
  while (result.views < cameras.size() &&
         View(scene, cameras[result.views], tolerance, threshold).run(pieces, result.views, end)) {
    ++result.views;
  }
  return result;
}

}  // namespace sightline::bench
