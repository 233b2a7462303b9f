// Tables 2 to 5 of Yu's paper: pieces and seconds, ours and Weiler and Atherton's.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "bench/clip/weiler_atherton.hpp"
#include "bench/cpu_seconds.hpp"
#include "clip/clip.hpp"
#include "models/model.hpp"

namespace {

using namespace sightline;

/// Areas that thresholds may be parts of.
double square_of_longest_side(const Scene& scene) {
  glm::dvec3 low{1e300}, high{-1e300};
  for (const glm::dvec3& v : scene.soup().vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const double side = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  return side * side;
}
double mean_polygon(const Scene& scene) {
  double sum = 0;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    glm::dvec3 twice{0};
    const auto corners = scene.corners(p);
    const auto at = [&](std::size_t k) { return scene.soup().vertices[corners[k]]; };
    for (std::size_t k = 2; k < corners.size(); ++k) twice += glm::cross(at(k - 1) - at(0), at(k) - at(0));
    sum += glm::length(twice) / 2;
  }
  return sum / scene.polygon_count();
}

/// The part of each camera's window, summed up, in which something is seen: the same for both, but for their roundings.
template <class Sees>
double seen_area(std::span<const Camera> cameras, const Sees& each_seen_figure) {
  double sum = 0;
  for (std::uint32_t c = 0; c < cameras.size(); ++c) {
    const glm::dmat3 inverse = glm::inverse(glm::dmat3(cameras[c].forward, cameras[c].right, cameras[c].up));
    each_seen_figure(c, [&](const std::vector<glm::dvec3>& figure) {
      std::vector<glm::dvec2> st;
      for (const glm::dvec3& x : figure) {
        const glm::dvec3 v = inverse * (x - cameras[c].eye);
        st.emplace_back(v.y / v.x, v.z / v.x);
      }
      double twice = 0;
      for (std::size_t k = 2; k < st.size(); ++k) {
        const glm::dvec2 a = st[k - 1] - st[0], b = st[k] - st[0];
        twice += a.x * b.y - a.y * b.x;
      }
      sum += std::abs(twice) / 2;
    });
  }
  return sum;
}

double seen_by_ours(const ClipResult& result, std::span<const Camera> cameras) {
  return seen_area(cameras, [&](std::uint32_t c, const auto& figure) {
    for (const ClipPiece& piece : result.pieces) {
      const auto list = std::span(result.cameras).subspan(piece.first_camera, piece.camera_count);
      if (std::find(list.begin(), list.end(), c) == list.end()) continue;
      std::vector<glm::dvec3> corners;
      for (std::uint32_t k = 0; k < piece.corner_count; ++k) {
        const auto& at = result.corners[piece.first_corner + k].at;
        corners.emplace_back(at[0], at[1], at[2]);
      }
      figure(corners);
    }
  });
}

double seen_by_theirs(const std::vector<bench::WaPiece>& pieces, std::span<const Camera> cameras) {
  return seen_area(cameras, [&](std::uint32_t c, const auto& figure) {
    for (const bench::WaPiece& piece : pieces)
      if (std::find(piece.cameras.begin(), piece.cameras.end(), c) != piece.cameras.end()) figure(piece.corner);
  });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Tables 2 to 5 of Yu's hybrid"};
  std::vector<std::string> names{"tower", "campus", "random"};
  std::vector<double> thresholds{0.0001, 0.001, 0.01};
  std::string relative = "polygon";
  int buffer = 0;
  double limit = 600;
  bool alone = false, one_sided = true;
  app.add_option("models", names);
  app.add_option("--thresholds", thresholds, "areas, of --relative");
  app.add_option("--relative", relative, "polygon: the model's mean polygon; box: the square of its longest side")
      ->check(CLI::IsMember({"polygon", "box"}));
  app.add_option("--buffer", buffer);
  app.add_option("--limit", limit, "processor seconds that the baseline is given; what it has come to then counts");
  app.add_flag("--one-sided,!--two-sided", one_sided, "only the open sides of polygons are seen, or hide anything");
  app.add_flag("--alone", alone, "without the baseline");
  CLI11_PARSE(app, argc, argv);
  std::printf(
      "model | polygons | views | threshold | pieces: hybrid | WA | ratio | seconds: hybrid | WA | ratio | buffer, "
      "s | the rest, s\n");
  for (const std::string& name : names) {
    const Model model = make_model(name);
    // Front faces only, as in the paper.
    const Scene scene = make_scene(model.soup, {"", one_sided});
    std::vector<Camera> cameras;
    for (const CameraLine& c : model.cameras)
      cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    const double unit = relative == "box" ? square_of_longest_side(scene) : mean_polygon(scene);
    for (const double threshold : thresholds) {
      ClipOptions options;
      options.threshold = threshold * unit;
      options.buffer = buffer;
      const double start = cpu_seconds();
      const ClipResult ours = clip(scene, cameras, options);
      const double middle = cpu_seconds();
      bench::WaResult theirs;
      if (!alone) theirs = bench::weiler_atherton(scene, cameras, options.threshold, limit);
      const double end = cpu_seconds();
      const double a = middle - start, b = end - middle;
      std::printf("%s | %u | %zu | %g | %zu | %zu | %.2f | %.2f | %.2f | %.1f | %.2f | %.2f", name.c_str(),
                  scene.polygon_count(), cameras.size(), threshold, ours.pieces.size(), theirs.pieces.size(),
                  static_cast<double>(theirs.pieces.size()) / static_cast<double>(ours.pieces.size()), a, b, b / a,
                  ours.stats.buffer_seconds, ours.stats.clip_seconds);
      if (!alone && theirs.views < cameras.size()) std::printf(" | given up after %u views", theirs.views);
      // Without a threshold both see the same, but for the baseline's roundings.
      if (threshold == 0)
        std::printf(" | window seen, all views: %.9f | %.9f", seen_by_ours(ours, cameras),
                    seen_by_theirs(theirs.pieces, cameras));
      std::printf("\n");
      std::fflush(stdout);
    }
  }
}
