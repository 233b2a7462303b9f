// Draws the pictures of docs/photos.md: photographs mapped to a scene and seen from elsewhere, with and without a
// guard.
//   sightline_gallery_photographs FOLDER
// Also leaves, in FOLDER/tower, a model with its cameras and photographs, for `sightline clip --photos`.
#include "beam/trace.hpp"
#include "models/model.hpp"
#include "photos/render.hpp"
#include "photos/textured.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <iostream>

namespace sightline::gallery {
namespace {

VisibilityMap trace(const Scene& scene, const Camera& camera) {
  const BspTree tree(scene);
  VisibilityMap map;
  Tracer(tree).trace(camera, map);
  return map;
}

void save(const std::filesystem::path& file, const Image& image) { write_file(file, png(image)); }

glm::dvec3 normal_of(const Scene& scene, PolygonId polygon) {
  const ApproxPlane& plane = scene.planes().approx(scene.surfaces(polygon)[0].plane);
  return glm::normalize(glm::dvec3(plane.n[0], plane.n[1], plane.n[2]));
}

/// Photographs of a scene painted by `paint`, mapped to it with a guard and seen by another camera.
Image reconstructed(const Scene& scene, std::span<const Camera> cameras, int width, int height, const Shade& paint,
                    int guard, const Camera& elsewhere, int scale) {
  const ClipResult clipped = clip(scene, cameras);
  std::vector<Photograph> photographs;
  for (const Camera& camera : cameras) {
    const VisibilityMap map = trace(scene, camera);
    photographs.emplace_back(scene, camera, render(map, scene, width, height, paint),
                             pixel_owners(map, scene, width, height, guard));
  }
  PhotoOptions options;
  options.reach = guard + 1;
  const PhotoTextures textures = map_photos(scene, clipped, photographs, options);
  std::cout << "guard " << guard << ": pieces";
  for (const std::uint64_t n : textures.stats.pieces) std::cout << ' ' << n;
  std::cout << ", texels " << textures.stats.direct << ' ' << textures.stats.borrowed << ' ' << textures.stats.continued
            << '\n';
  const TextureLookup lookup(scene, clipped, textures);
  return render(trace(scene, elsewhere), scene, scale * width, scale * height,
                [&](PolygonId p, const glm::dvec3& x) { return lookup.at(p, x); });
}

/// Two rooms joined by a doorway in a thick wall, as in figure 1 of Funkhouser 1999.
Scene two_rooms() {
  PolygonSoup soup;
  const auto polygon = [&](std::initializer_list<glm::dvec3> corners) {
    for (const glm::dvec3& c : corners) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(c);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  const auto shell = [&](double x0, double x1, double y0, double y1, bool front, bool back) {
    polygon({{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}});
    polygon({{x0, y0, 3}, {x1, y0, 3}, {x1, y1, 3}, {x0, y1, 3}});
    polygon({{x0, y0, 0}, {x0, y1, 0}, {x0, y1, 3}, {x0, y0, 3}});
    polygon({{x1, y0, 0}, {x1, y1, 0}, {x1, y1, 3}, {x1, y0, 3}});
    if (front) polygon({{x0, y0, 0}, {x1, y0, 0}, {x1, y0, 3}, {x0, y0, 3}});
    if (back) polygon({{x0, y1, 0}, {x1, y1, 0}, {x1, y1, 3}, {x0, y1, 3}});
  };
  shell(-3.5, 3.5, 0, 4, true, false);  // polygons 0 to 4
  shell(-3, 3, 4.25, 8, false, true);   // 5 to 9
  shell(-1, 1, 4, 4.25, false, false);  // 10 to 13: the doorway
  for (const double y : {4.0, 4.25}) {  // 14 to 17: the walls beside it
    const double side = y == 4 ? 3.5 : 3;
    polygon({{-side, y, 0}, {-1, y, 0}, {-1, y, 3}, {-side, y, 3}});
    polygon({{1, y, 0}, {side, y, 0}, {side, y, 3}, {1, y, 3}});
  }
  return make_scene(std::move(soup));
}

void draw_doorway(const std::filesystem::path& folder) {
  const Scene scene = two_rooms();
  const auto paint = [&](PolygonId p, const glm::dvec3& x) {
    const glm::dvec3 n = glm::abs(normal_of(scene, p));
    const double light = 0.86 + 0.14 * n.y;
    const bool far_room = p >= 5 && p < 10;
    if (n.z > 0.5 && x.z < 1) {  // floors
      const bool odd = (static_cast<int>(std::floor(2 * x.x)) + static_cast<int>(std::floor(2 * x.y))) % 2 != 0;
      return odd ? glm::dvec3(150, 120, 95) : glm::dvec3(175, 145, 115);
    }
    if (n.z > 0.5) return glm::dvec3(225, 225, 220);
    return light * (far_room ? glm::dvec3(110, 150, 205) : glm::dvec3(250, 205, 40));
  };
  // The doorway's left side divides a column of pixels about in half, as some column in any photograph.
  const Camera camera = make_camera({0.3541, 0.4, 1.6}, {0, 1, 0}, {0, 0, 1}, 60, 4.0 / 3);
  const Camera aside = make_camera({-0.5, 3.6, 1.5}, {-0.4, 1, 0}, {0, 0, 1}, 60, 4.0 / 3);
  constexpr int width = 160, height = 120;
  save(folder / "photos-doorway.png", render(trace(scene, camera), scene, width, height, paint));
  for (const int guard : {0, 1}) {
    save(folder / (guard == 0 ? "photos-without-guard.png" : "photos-with-guard.png"),
         reconstructed(scene, std::span(&camera, 1), width, height, paint, guard, aside, 3));
  }
}

/// Storeys, stones and grass enough to see whether pictures fit together.
void draw_tower(const std::filesystem::path& folder) {
  const Model model = make_model("tower");
  const Scene scene = make_scene(model.soup);
  const auto paint = [&](PolygonId p, const glm::dvec3& x) {
    const glm::dvec3 n = normal_of(scene, p);
    const double light = 0.75 + 0.25 * std::abs(glm::dot(n, glm::normalize(glm::dvec3(0.4, 0.8, 0.5))));
    const auto stripe = [](double t, double part) { return t - std::floor(t) < part ? 0.8 : 1.0; };
    const glm::dvec3 hue(0.9 + 0.1 * std::sin(1.7 * p), 0.9 + 0.1 * std::sin(2.3 * p + 1),
                         0.9 + 0.1 * std::sin(3.1 * p + 2));
    if (std::abs(n.z) > 0.7) return light * hue * glm::dvec3(165, 185, 140) * stripe((x.x + x.y) / 4, 0.5);
    const double along = std::abs(n.x) > std::abs(n.y) ? x.y : x.x;
    return light * hue * glm::dvec3(225, 190, 150) * std::min(stripe(x.z / 2, 0.2), stripe(along / 2, 0.2));
  };
  std::vector<Camera> cameras;
  std::vector<CameraLine> lines;
  const auto camera_of = [](const CameraLine& c) {
    return make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
  };
  for (std::size_t k = 0; k < model.cameras.size(); k += 2) {
    lines.push_back(model.cameras[k]);
    cameras.push_back(camera_of(lines.back()));
  }
  constexpr int width = 480, height = 360;
  const std::filesystem::path own = folder / "tower";
  std::filesystem::create_directories(own);
  write_obj(own / "tower.obj", model.soup);
  write_cameras(own / "tower.cameras", lines);
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const std::string digits = std::to_string(c);
    save(own / (std::string(4 - digits.size(), '0') + digits + ".png"),
         render(trace(scene, cameras[c]), scene, width, height, paint));
  }
  const Camera elsewhere = camera_of(model.cameras[5]);
  save(folder / "photos-tower-truth.png", render(trace(scene, elsewhere), scene, width, height, paint));
  save(folder / "photos-tower.png", reconstructed(scene, cameras, width, height, paint, 1, elsewhere, 1));
}

}  // namespace
}  // namespace sightline::gallery

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: sightline_gallery_photographs FOLDER\n";
    return 2;
  }
  try {
    sightline::gallery::draw_doorway(argv[1]);
    sightline::gallery::draw_tower(argv[1]);
  } catch (const std::exception& e) {
    std::cerr << "sightline_gallery_photographs: " << e.what() << '\n';
    return 1;
  }
}
