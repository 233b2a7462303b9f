#include "bench/parts/quilt.hpp"

#include "beam/region.hpp"

namespace sightline::bench {

Scene make_quilt(std::uint32_t side, bool bumpy) {
  PolygonSoup soup;
  soup.source = "quilt.obj";
  const std::uint32_t n = side + 1;
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      // Bumps are shallow enough for no triangle to hide another.
      const double bump = bumpy ? static_cast<double>((i * 7 + j * 5 + i * j) % 8) / 64 : 0;
      soup.vertices.emplace_back(static_cast<double>(i) - side / 2.0, side + bump, static_cast<double>(j) - side / 2.0);
    }
  }
  for (std::uint32_t j = 0; j < side; ++j) {
    for (std::uint32_t i = 0; i < side; ++i) {
      const std::uint32_t a = j * n + i;
      for (const std::uint32_t v : {a, a + 1, a + n + 1, a, a + n + 1, a + n}) soup.corners.push_back(v);
      for (int k = 0; k < 2; ++k) soup.first.push_back(soup.first.back() + 3);
    }
  }
  return make_scene(std::move(soup));
}

Camera quilt_camera() {
  // Its window is a little narrower than the quilt, so that the border cuts triangles.
  return {.eye = {0, 0, 0}, .forward = {0, 1, 0}, .right = {0.90625, 0, 0}, .up = {0, 0, 0.90625}};
}

void fragments_of(const Scene& quilt, const Camera& camera, SightlineTable& table, Fragments& out) {
  table.reset(quilt.planes(), quilt.grid().point(camera.eye));
  out.clear();
  const Window window(camera.forward, camera.right, camera.up);
  const SightlineRef border[] = {window.side(table, Window::bottom), window.side(table, Window::right),
                                 window.side(table, Window::top), window.side(table, Window::left)};
  Regions regions;
  const Regions::Region whole = regions.push(table, border);
  for (std::uint32_t s = 0; s < quilt.surfaces().size(); ++s) {
    const Surface& surface = quilt.surfaces()[s];
    const std::uint32_t mark = regions.mark();
    Regions::Region part = whole;
    for (const SurfaceEdge& edge : quilt.edges(surface)) {
      SightlineRef line = table.of_points(edge.a, edge.b);
      // Turned so that the triangle lies on the line's inner side: the corner that is not on the edge tells.
      for (const SurfaceEdge& other : quilt.edges(surface)) {
        const Sign at = table.side(line, other.corner);
        if (at != 0) line.sign *= at;
      }
      part = regions.clip(table, part, line);
      if (part.count == 0) break;
    }
    if (part.count != 0) {
      std::vector<SightlineRef> lines;
      for (const RegionSide& side : regions.sides(part)) lines.push_back(side.line);
      out.add_convex(lines, {{s}});
    }
    regions.release(mark);
  }
}

}  // namespace sightline::bench
