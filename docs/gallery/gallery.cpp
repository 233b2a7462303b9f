// Draws the views of figure 8 of Funkhouser 1999, on our own city.
//   sightline_gallery FOLDER [CAMERA]     CAMERA: index along the city's walk
#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "docs/gallery/beams.hpp"
#include "docs/gallery/canvas.hpp"
#include "models/model.hpp"
#include "visibility_map/query.hpp"
#include "winged_pair/traverse.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace sightline::gallery {
namespace {

constexpr int width = 880;
constexpr Colour white{255, 255, 255}, green{64, 220, 96}, yellow{255, 222, 30}, blue{64, 120, 230}, night{17, 17, 34};

glm::dvec3 world(const Scene& scene, const ImplicitVertex& v) {
  glm::dvec3 result;
  for (int k = 0; k < 3; ++k) {
    result[k] = scene.grid().world(Integer(std::round(std::ldexp(v.approx[k], scene.grid().unit_bits()))), k);
  }
  return result;
}

/// The opaque faces of a complex as polygons of their own, so that each gets its own colour.
PolygonSoup opaque_faces(const Scene& scene, const Complex& complex) {
  PolygonSoup soup;
  soup.source = "city, faces of the winged-pair";
  for (const Vertex& v : complex.vertices) soup.vertices.push_back(world(scene, v.place));
  for (FaceId f = 0; f < complex.faces.size(); ++f) {
    if (complex.faces[f].label == 0) continue;
    for_pairs_of_face(complex, f, [&](PairId p) { soup.corners.push_back(pair_tail(complex, p)); });
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return soup;
}

VisibilityMap trace(const Scene& scene, const Complex& complex, const Camera& camera) {
  VisibilityMap map;
  Tracer(scene, complex).trace(camera, map);
  return map;
}

/// From above one corner, the whole in view.
Camera birds_eye(const PolygonSoup& soup) {
  glm::dvec3 low = soup.vertices[0], high = low;
  for (const glm::dvec3& v : soup.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const glm::dvec3 middle = 0.5 * (low + high);
  const double size = std::max(high.x - low.x, high.y - low.y);
  const glm::dvec3 eye = middle + size * glm::dvec3(-0.5, -0.8, 1);
  return make_camera(eye, middle - eye - glm::dvec3(0, 0, 0.2 * size), {0, 0, 1}, 42, 4.0 / 3);
}

/// All edges of a complex: faint in free space, clear where they bound or cross polygons.
void draw_edges(Canvas& canvas, const Scene& scene, const Complex& complex) {
  for (const bool opaque : {false, true}) {
    canvas.pen(white, opaque ? 0.6 : 0.14, opaque ? 0.8 : 0.6);
    for (EdgeId e = 0; e < complex.edges.size(); ++e) {
      bool found = false;
      for_pairs_of_edge(complex, e,
                        [&](PairId p) { found = found || complex.faces[complex.pairs[p].face].label != 0; });
      const auto& ends = complex.edges[e].vertex;
      if (found == opaque) {
        canvas.line(world(scene, complex.vertices[ends[0]].place), world(scene, complex.vertices[ends[1]].place));
      }
    }
  }
}

/// The corners, in the world, of the outer boundary of what a face of a map shows.
std::vector<glm::dvec3> seen_part(const VisibilityMap& map, const Scene& scene, const MapFace& face) {
  const auto corners = scene.corners(face.polygon);
  const auto& vertices = scene.soup().vertices;
  const glm::dvec3 a = vertices[corners[0]];
  glm::dvec3 normal{0, 0, 0};
  for (std::size_t k = 2; k < corners.size(); ++k) {
    normal += glm::cross(vertices[corners[k - 1]] - a, vertices[corners[k]] - a);
  }
  std::vector<glm::dvec3> part;
  for (const std::int32_t e : map.loop(face.first_loop)) {
    const glm::dvec3 ray = map.vertices[start_vertex(map, e)].direction;
    part.push_back(map.camera.eye + glm::dot(normal, a - map.camera.eye) / glm::dot(normal, ray) * ray);
  }
  return part;
}

void draw(const std::filesystem::path& folder, std::size_t index) {
  const Model model = make_model("city");
  const CameraLine& chosen = model.cameras.at(index);
  const Camera inside = make_camera(chosen.eye, chosen.forward, chosen.up, chosen.vertical_fov_degrees, chosen.aspect);
  const Camera above = birds_eye(model.soup);
  const Scene city = make_scene(model.soup);
  const Complex complex = build(city);
  const Scene faces = make_scene(opaque_faces(city, complex));
  const Complex of_faces = build(faces);
  const VisibilityMap map = trace(city, complex, inside), map_of_faces = trace(faces, of_faces, inside);
  const DrawOptions plain{.silhouettes = false};

  Canvas a(above, width);
  a.map(trace(faces, of_faces, above), faces, {});
  a.write_png(folder / "a-faces-from-above.png");

  Canvas b(above, width);
  b.background(night);
  draw_edges(b, city, complex);
  b.pen(green);
  for (const Vertex& v : complex.vertices) b.dot(world(city, v.place), 1.3);
  b.reduce_colours();
  b.write_png(folder / "b-edges-and-vertices.png");

  Canvas c(inside, width);
  c.map(map_of_faces, faces, plain);
  c.write_png(folder / "c-faces.png");

  Canvas d(inside, width);
  d.map(map_of_faces, faces, plain);
  d.veil(night, 0.35);
  d.pen(white, 1, 4);
  for (const MapEdge& edge : map.edges) {
    if (edge.kind == EdgeKind::silhouette) {
      d.window_line(map.vertices[edge.vertex[0]].st, map.vertices[edge.vertex[1]].st);
    }
  }
  d.write_png(folder / "d-silhouettes.png");

  Canvas e(inside, width);
  e.map(map_of_faces, faces, plain);
  e.veil(night, 0.45);
  e.pen(yellow, 1, 1);
  for (const auto& outline : beam_outlines(city, complex, inside)) {
    for (std::size_t k = 0; k < outline.size(); ++k) e.window_line(outline[k], outline[(k + 1) % outline.size()]);
  }
  e.reduce_colours();
  e.write_png(folder / "e-beams.png");

  Canvas f(above, width);
  f.background(night);
  std::vector<std::pair<double, std::vector<glm::dvec3>>> parts;
  for (const MapFace& face : map.faces) {
    if (face.polygon == none) continue;
    std::vector<glm::dvec3> part = seen_part(map, city, face);
    glm::dvec3 sum{0, 0, 0};
    for (const glm::dvec3& p : part) sum += p;
    parts.emplace_back(glm::distance(above.eye, sum / static_cast<double>(part.size())), std::move(part));
  }
  std::sort(parts.begin(), parts.end(), [](const auto& p, const auto& q) { return p.first > q.first; });
  f.pen(blue, 1, 0.7);
  for (const auto& part : parts) f.polygon(part.second);
  draw_edges(f, city, complex);
  f.pen(yellow);
  f.dot(inside.eye, 5);
  f.reduce_colours();
  f.write_png(folder / "f-visible-surfaces.png");
}

}  // namespace
}  // namespace sightline::gallery

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: sightline_gallery FOLDER [CAMERA]\n";
    return 2;
  }
  try {
    sightline::gallery::draw(argv[1], argc == 3 ? std::stoul(argv[2]) : 82);
  } catch (const std::exception& e) {
    std::cerr << "sightline_gallery: " << e.what() << '\n';
    return 1;
  }
}
