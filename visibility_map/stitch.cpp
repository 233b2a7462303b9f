#include "visibility_map/stitch.hpp"

#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sightline {

struct Stitcher::Work : stitching::State {
  std::optional<Window> own_window;
  Camera own_camera;
};

Stitcher::Stitcher() : work_(std::make_unique<Work>()) {}
Stitcher::~Stitcher() = default;
Stitcher::Stitcher(Stitcher&&) noexcept = default;
Stitcher& Stitcher::operator=(Stitcher&&) noexcept = default;

namespace {

bool same_window(const Camera& a, const Camera& b) {
  return a.forward == b.forward && a.right == b.right && a.up == b.up;
}

void set_eye(stitching::State& s) {
  s.eye = s.table->eye_approx();
  s.scale = std::max({1.0, std::abs(s.eye.x), std::abs(s.eye.y), std::abs(s.eye.z)});
}

void run(stitching::State& s, VisibilityMap& map) {
  set_eye(s);
  arrange(s);
  find_kinds(s);
  join_parts(s);
  number(s, map);
  trace_loops(s, map);
  measure(s, map);
  name_scene_vertices(s, map);
}

}  // namespace

void Stitcher::stitch(const Scene& scene, const Camera& camera, SightlineTable& table, const Fragments& fragments,
                      VisibilityMap& map) {
  Work& s = *work_;
  if (!s.own_window || !same_window(s.own_camera, camera)) {
    s.own_window.emplace(camera.forward, camera.right, camera.up);
    s.own_camera = camera;
  }
  const Window& w = *s.own_window;
  stitch(scene, camera, w,
         {w.side(table, Window::left), w.side(table, Window::right), w.side(table, Window::bottom),
          w.side(table, Window::top)},
         table, fragments, map);
}

namespace {

void set(stitching::State& s, const Scene& scene, const Camera& camera, const Window& window,
         const std::array<SightlineRef, 4>& border, SightlineTable& table, const Fragments& fragments) {
  s.scene = &scene;
  s.camera = &camera;
  s.window = &window;
  s.table = &table;
  s.fragments = &fragments;
  s.handedness = window.handedness();
  std::copy(border.begin(), border.end(), s.border);
  // Not camera.forward: of a window that stands askew to it, a ray may lie opposite to forward along a line.
  s.ahead = window.ahead();
  set_frame(s);
}

}  // namespace

void Stitcher::stitch(const Scene& scene, const Camera& camera, const Window& window,
                      const std::array<SightlineRef, 4>& border, SightlineTable& table, const Fragments& fragments,
                      VisibilityMap& map) {
  set(*work_, scene, camera, window, border, table, fragments);
  map.camera = camera;
  map.sphere = false;
  run(*work_, map);
}

void Stitcher::areas(const Scene& scene, const Camera& camera, const Window& window,
                     const std::array<SightlineRef, 4>& border, SightlineTable& table, const Fragments& fragments,
                     std::vector<PolygonArea>& areas) {
  set(*work_, scene, camera, window, border, table, fragments);
  set_eye(*work_);
  sum_areas(*work_, areas);
}

void Stitcher::stitch_sphere(const Scene& scene, const glm::dvec3& eye, SightlineTable& table,
                             const Fragments& fragments, VisibilityMap& map) {
  Work& s = *work_;
  s.scene = &scene;
  s.camera = nullptr;
  s.table = &table;
  s.fragments = &fragments;
  s.handedness = 1;
  s.ahead = {0, 0, 0};
  map.camera = Camera{};
  map.camera.eye = eye;
  map.sphere = true;
  run(s, map);
}

}  // namespace sightline
