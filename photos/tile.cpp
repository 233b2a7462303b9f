#include "photos/tile.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace sightline {

namespace {

glm::dvec3 corner_at(const ClipResult& clipped, const ClipPiece& piece, std::size_t k) {
  const auto& at = clipped.corners[piece.first_corner + k % piece.corner_count].at;
  return {at[0], at[1], at[2]};
}

/// How many texels the frame's two sides need for so many pixels' detail. Along each, the side of the piece counts that
/// the photograph shows largest in that direction; no line through the piece is seen longer than the diagonal of what
/// is seen of it, which bounds what a corner close to the eye asks for.
std::pair<int, int> texels(const PieceFrame& frame, const PhotoFrame& photo, const PhotoOptions& options) {
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low, scale(0);
  const std::size_t n = frame.corner.size();
  for (std::size_t k = 0; k < n; ++k) {
    const glm::dvec2 &a = frame.corner[k], &b = frame.corner[(k + 1) % n];
    const auto from = photo.place(frame.point(a)), to = photo.place(frame.point(b));
    if (!from || !to) continue;
    low = glm::min(low, *from);
    high = glm::max(high, *from);
    const double length = glm::distance(a, b);
    if (length > 0) scale = glm::max(scale, glm::distance(*from, *to) / (length * length) * glm::abs(b - a));
  }
  const double diagonal = low.x <= high.x ? glm::distance(low, high) : 0;
  const auto count = [&](double wanted) {
    const double most = options.page - 2 * texture_padding;
    return static_cast<int>(std::ceil(std::clamp(options.density * std::min(wanted, diagonal), 1.0, most)));
  };
  return {count(scale.x * frame.size.x), count(scale.y * frame.size.y)};
}

}  // namespace

PieceFrame::PieceFrame(const Scene& scene, const ClipResult& clipped, const ClipPiece& piece) {
  const ApproxPlane& plane = scene.planes().approx(scene.surfaces()[piece.surface].plane);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(plane.n[0], plane.n[1], plane.n[2]));
  glm::dvec3 longest(0);
  for (std::size_t k = 0; k < piece.corner_count; ++k) {
    const glm::dvec3 side = corner_at(clipped, piece, k + 1) - corner_at(clipped, piece, k);
    if (glm::length(side) > glm::length(longest)) longest = side;
  }
  // Corners of a piece below the doubles' spacing may all be rounded to one point: any direction will do.
  if (!(glm::length(longest) > 0)) longest = glm::cross(normal, glm::dvec3(normal.y, normal.z, normal.x));
  across = glm::length(longest) > 0 ? glm::normalize(longest) : glm::dvec3(1, 0, 0);
  down = glm::cross(normal, across);
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high = -low;
  const glm::dvec3 first = corner_at(clipped, piece, 0);
  for (std::size_t k = 0; k < piece.corner_count; ++k) {
    const glm::dvec3 d = corner_at(clipped, piece, k) - first;
    corner.emplace_back(glm::dot(d, across), glm::dot(d, down));
    low = glm::min(low, corner.back());
    high = glm::max(high, corner.back());
  }
  for (glm::dvec2& c : corner) c -= low;
  size = high - low;
  origin = first + low.x * across + low.y * down;
}

glm::dvec2 PieceFrame::centre() const {
  glm::dvec2 sum(0);
  for (const glm::dvec2& c : corner) sum += c;
  return sum / static_cast<double>(corner.size());
}

bool PieceFrame::holds(const glm::dvec2& at) const {
  bool left = true, right = true;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const glm::dvec2 &a = corner[k], &b = corner[(k + 1) % corner.size()];
    const double side = (b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x);
    left = left && side >= 0;
    right = right && side <= 0;
  }
  return left || right;
}

double pixels(const ClipResult& clipped, const ClipPiece& piece, const PhotoFrame& photo) {
  const auto first = photo.place(corner_at(clipped, piece, 0));
  double area = 0;
  for (std::size_t k = 0; k < piece.corner_count; ++k) {
    const auto a = photo.place(corner_at(clipped, piece, k)), b = photo.place(corner_at(clipped, piece, k + 1));
    if (!first || !a || !b) return 0;
    const glm::dvec2 p = *a - *first, q = *b - *first;
    area += p.x * q.y - p.y * q.x;
  }
  return std::abs(area) / 2;
}

Tile make_tile(const PieceFrame& frame, const ClipPiece& piece, const Photograph& photo, const PhotoOptions& options) {
  Tile tile;
  std::tie(tile.width, tile.height) = texels(frame, photo.frame(), options);
  const auto look = [&](const glm::dvec2& at) {
    const auto place = photo.frame().place(frame.point(at));
    return place ? photo.sample(piece.polygon, *place, options.reach) : PhotoSample{};
  };
  const auto count = [&](const PhotoSample& sample) {
    ++(sample.kind == PhotoSample::direct     ? tile.direct
       : sample.kind == PhotoSample::borrowed ? tile.borrowed
                                              : tile.bare);
    tile.sum += sample.colour;  // black where there is none
  };
  const auto size = static_cast<std::size_t>(tile.full_width()) * static_cast<std::size_t>(tile.full_height());
  tile.colour.reserve(size);
  tile.kind.reserve(size);
  for (int j = -texture_padding; j < tile.height + texture_padding; ++j) {
    for (int i = -texture_padding; i < tile.width + texture_padding; ++i) {
      const glm::dvec2 at(frame.size.x * (i + 0.5) / tile.width, frame.size.y * (j + 0.5) / tile.height);
      const PhotoSample sample = look(at);
      tile.colour.push_back(sample.colour);
      tile.kind.push_back(sample.kind);
      if (i >= 0 && j >= 0 && i < tile.width && j < tile.height && frame.holds(at)) count(sample);
    }
  }
  count(look(frame.centre()));  // so that the thinnest piece has one place to be judged by
  return tile;
}

void continue_colours(Tile& tile) {
  const int width = tile.full_width(), height = tile.full_height();
  const auto index = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i);
  };
  std::vector<char> known(tile.kind.size());
  for (std::size_t k = 0; k < known.size(); ++k) known[k] = tile.kind[k] != PhotoSample::nothing;
  if (std::ranges::find(known, 1) == known.end()) {  // all that is known was found at the centre
    tile.colour.assign(known.size(), tile.sum / static_cast<double>(tile.direct + tile.borrowed));
    return;
  }
  const auto around = [&](int i, int j, auto visit) {
    for (int b = std::max(j - 1, 0); b <= std::min(j + 1, height - 1); ++b) {
      for (int a = std::max(i - 1, 0); a <= std::min(i + 1, width - 1); ++a) visit(a, b);
    }
  };
  std::vector<std::pair<int, int>> ring, next;
  std::vector<char> listed = known;
  const auto list_unknown = [&](int a, int b) {
    if (listed[index(a, b)]) return;
    listed[index(a, b)] = 1;
    next.emplace_back(a, b);
  };
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      if (known[index(i, j)]) around(i, j, list_unknown);
    }
  }
  while (!next.empty()) {
    ring.swap(next);
    next.clear();
    for (const auto& [i, j] : ring) {
      glm::dvec3 sum(0);
      int count = 0;
      around(i, j, [&](int a, int b) {
        if (!known[index(a, b)]) return;
        sum += tile.colour[index(a, b)];
        ++count;
      });
      tile.colour[index(i, j)] = sum / static_cast<double>(count);
    }
    for (const auto& [i, j] : ring) known[index(i, j)] = 1;
    for (const auto& [i, j] : ring) around(i, j, list_unknown);
  }
}

}  // namespace sightline
