#include "photos/render.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "photos/photo_frame.hpp"
#include "visibility_map/query.hpp"

namespace sightline {

namespace {

using Loop = std::vector<glm::dvec2>;

/// The part of a loop with sign * coordinate >= sign * bound (Sutherland and Hodgman). Where that falls apart the parts
/// stay joined along the bound, which adds no area.
void cut(const Loop& loop, int axis, double bound, double sign, Loop& kept) {
  kept.clear();
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const glm::dvec2 &a = loop[k], &b = loop[k + 1 == loop.size() ? 0 : k + 1];
    const double from = sign * (a[axis] - bound), to = sign * (b[axis] - bound);
    if (from >= 0) kept.push_back(a);
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
      glm::dvec2 crossing = a + (b - a) * (from / (from - to));
      crossing[axis] = bound;
      kept.push_back(crossing);
    }
  }
}

/// Twice the area and six times the moment of a loop, about a point.
void add_area(const Loop& loop, const glm::dvec2& about, double& area, glm::dvec2& moment) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const glm::dvec2 a = loop[k] - about, b = loop[k + 1 == loop.size() ? 0 : k + 1] - about;
    const double cross = a.x * b.y - a.y * b.x;
    area += cross;
    moment += cross * (a + b);
  }
}

std::pair<int, int> range(const std::vector<Loop>& loops, int axis, int size) {
  double low = size, high = 0;
  for (const Loop& loop : loops) {
    for (const glm::dvec2& p : loop) {
      low = std::min(low, p[axis]);
      high = std::max(high, p[axis]);
    }
  }
  return {std::max(0, static_cast<int>(std::floor(low))), std::min(size - 1, static_cast<int>(std::floor(high)))};
}

/// Loops cut to the strip between two neighbouring whole numbers.
void strip(const std::vector<Loop>& loops, int axis, int at, std::vector<Loop>& kept) {
  kept.clear();
  Loop half, whole;
  for (const Loop& loop : loops) {
    cut(loop, axis, at, 1, half);
    cut(half, axis, at + 1, -1, whole);
    if (whole.size() > 2) kept.push_back(whole);
  }
}

}  // namespace

void visit_parts(const VisibilityMap& map, int width, int height, const std::function<void(const FacePart&)>& visit) {
  if (map.sphere || width < 1 || height < 1 || width > 32767 || height > 32767) {
    throw std::invalid_argument("a picture's sides must be from 1 to 32767 pixels, its map that of a window");
  }
  std::vector<Loop> loops, row, pixel;
  for (std::uint32_t f = 0; f < map.faces.size(); ++f) {
    const MapFace& face = map.faces[f];
    loops.clear();
    for (std::uint32_t l = 0; l < face.loop_count; ++l) {
      loops.emplace_back();
      for (const std::int32_t e : map.loop(face.first_loop + l)) {
        const glm::dvec2& st = map.vertices[start_vertex(map, e)].st;
        loops.back().emplace_back(st.x * width, (1 - st.y) * height);
      }
    }
    const auto [first_row, last_row] = range(loops, 1, height);
    for (int j = first_row; j <= last_row; ++j) {
      strip(loops, 1, j, row);
      const auto [first, last] = range(row, 0, width);
      for (int i = first; i <= last; ++i) {
        strip(row, 0, i, pixel);
        double area = 0;
        glm::dvec2 moment(0);
        const glm::dvec2 middle(i + 0.5, j + 0.5);
        for (const Loop& loop : pixel) add_area(loop, middle, area, moment);
        // Faces run counter-clockwise with t upwards, so clockwise here. What rounding leaves is nothing.
        if (-area < 1e-12) continue;
        const glm::dvec2 centre = middle + glm::clamp(moment / (3 * area), -0.5, 0.5);
        visit({f, i, j, std::min(1.0, -area / 2), centre});
      }
    }
  }
}

Image render(const VisibilityMap& map, const Scene& scene, int width, int height, const Shade& shade,
             std::array<std::uint8_t, 3> sky) {
  const PhotoFrame frame(scene, map.camera, width, height);
  const glm::dvec3 sky_colour(sky[0], sky[1], sky[2]);
  const auto colour_at = [&](PolygonId polygon, const glm::dvec2& place) {
    // Of a polygon that is not planar the nearest plane stands for the one that is seen there.
    std::optional<glm::dvec3> point;
    for (const Surface& s : scene.surfaces(polygon)) {
      const auto id = static_cast<SurfaceId>(&s - scene.surfaces().data());
      const auto hit = frame.on_plane(id, place);
      if (hit && (!point || glm::distance(*hit, frame.eye()) < glm::distance(*point, frame.eye()))) point = hit;
      if (scene.planar(polygon)) break;
    }
    // Where the eye is in the polygon's plane but for rounding, any point of it may be the one.
    return shade(polygon, point ? *point : scene.soup().vertices[scene.corners(polygon)[0]]);
  };
  std::vector<glm::dvec3> sum(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::dvec3(0));
  std::vector<double> area(sum.size(), 0);
  visit_parts(map, width, height, [&](const FacePart& part) {
    const PolygonId polygon = map.faces[part.face].polygon;
    glm::dvec3 colour(0);
    if (polygon == none) {
      colour = sky_colour;
    } else if (part.area > 1 - 1e-9) {
      constexpr int points = 3;
      for (int k = 0; k < points * points; ++k) {
        colour += colour_at(polygon, {part.i + (k % points + 0.5) / points, part.j + (k / points + 0.5) / points});
      }
      colour /= points * points;
    } else {
      colour = colour_at(polygon, part.centre);
    }
    const std::size_t k =
        static_cast<std::size_t>(part.j) * static_cast<std::size_t>(width) + static_cast<std::size_t>(part.i);
    sum[k] += part.area * colour;
    area[k] += part.area;
  });
  Image image(width, height);
  for (std::size_t k = 0; k < sum.size(); ++k) {
    image.pixels[k] = area[k] > 0 ? stored(sum[k] / area[k]) : sky;
  }
  return image;
}

}  // namespace sightline
