#include "beam/trace.hpp"

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <optional>
#include <stdexcept>

#include "beam/cells.hpp"
#include "beam/crew.hpp"
#include "beam/front_to_back.hpp"
#include "visibility_map/stitch.hpp"

namespace sightline {

namespace {

using Border = std::array<SightlineRef, 4>;  // by Window::Side

void count(const VisibilityMap& map, TraceStats* stats) {
  if (!stats) return;
  stats->faces = static_cast<std::uint32_t>(map.faces.size());
  stats->edges = static_cast<std::uint32_t>(map.edges.size());
  stats->vertices = static_cast<std::uint32_t>(map.vertices.size());
}

}  // namespace

struct Tracer::State {
  State(std::unique_ptr<Engine> e, const TraceOptions& o) : engine(std::move(e)), options(o) {
    if (options.threads > 1) crew.emplace(options.threads);
  }

  void begin(const glm::dvec3& eye);
  /// The fragments of a camera's window; gives the window's sides.
  Border fill(const Camera& camera, const Window& window);
  void finish(TraceStats* stats) const;

  std::unique_ptr<Engine> engine;
  TraceOptions options;
  std::optional<Crew> crew;
  Stitcher stitcher;
  GridPoint eye_point;
  std::chrono::steady_clock::time_point start;
};

void Tracer::State::begin(const glm::dvec3& eye) {
  engine->view.scene.grid().point(eye, eye_point);
  engine->start(eye_point);
}

namespace {

Border border_of(const Window& window, SightlineTable& table) {
  return {window.side(table, Window::left), window.side(table, Window::right), window.side(table, Window::bottom),
          window.side(table, Window::top)};
}

/// Counter-clockwise as an ordinary camera sees it; a mirrored one has its right side on the eye's left.
std::array<SightlineRef, 4> around(const Border& border, const Window& window) {
  const bool mirrored = window.handedness() < 0;
  return {border[Window::bottom], border[mirrored ? Window::left : Window::right], border[Window::top],
          border[mirrored ? Window::right : Window::left]};
}

}  // namespace

Border Tracer::State::fill(const Camera& camera, const Window& window) {
  begin(camera.eye);
  const Border border = border_of(window, engine->view.table);
  // Where not all beams are followed, what is not may end along a border between parts, which has no name in the scene.
  if (!crew || options.min_angle > 0) {
    engine->fill(around(border, window), window.ahead());
    return border;
  }
  const unsigned parts = 2 * crew->threads();  // upright strips of the window
  crew->fill(*engine, parts, [&window, parts](Engine& own, unsigned k) {
    SightlineTable& table = own.view.table;
    Border strip = border_of(window, table);
    if (k > 0) strip[Window::left] = window.upright(table, k, parts);
    if (k + 1 < parts) strip[Window::right] = -window.upright(table, k + 1, parts);
    own.fill(around(strip, window), window.ahead());
  });
  return border;
}

void Tracer::State::finish(TraceStats* stats) const {
  if (!stats) return;
  *stats = {};
  stats->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  stats->beams = engine->view.beams;
  stats->cells = engine->view.cells;
  stats->fragments = static_cast<std::uint32_t>(engine->view.fragments.fragments.size());
  stats->left_out = engine->view.left_out;
}

namespace {

void check(const TraceOptions& options) {
  if (!(options.min_angle >= 0 && options.min_angle <= 0.01)) {
    throw std::invalid_argument("min_angle is not between 0 and 0.01");
  }
  if (!(options.max_distance > 0)) throw std::invalid_argument("max_distance is not positive");
  if (options.threads == 0) throw std::invalid_argument("no thread to trace on");
}

}  // namespace

Tracer::Tracer(const Scene& scene, const Complex& complex, const TraceOptions& options) {
  check(options);
  if (options.min_angle != 0) throw std::invalid_argument("min_angle: the engine follows all beams");
  state_ = std::make_unique<State>(cells_engine(scene, complex, options.max_distance), options);
}
Tracer::Tracer(const BspTree& tree, const TraceOptions& options) {
  check(options);
  state_ = std::make_unique<State>(front_to_back_engine(tree, options.min_angle, options.max_distance), options);
}
Tracer::Tracer(const Tracer& other)
    : state_(std::make_unique<State>(other.state_->engine->copy(), other.state_->options)) {}
Tracer::~Tracer() = default;

namespace {

/// The part of the window that a solid angle may be. Seen along r = forward + (s - 1/2) right + (t - 1/2) up, the solid
/// angle of ds dt is |det(forward, right, up)| / |r|^3.
double part_of_window(const Camera& c, double solid_angle) {
  const double r = glm::length(c.forward) + (glm::length(c.right) + glm::length(c.up)) / 2;
  const double bound = 1.001 * solid_angle * (r * r) * r / std::abs(glm::dot(c.forward, glm::cross(c.right, c.up)));
  return solid_angle == 0 ? 0 : std::min(1.0, bound);
}

}  // namespace

void Tracer::trace(const Camera& camera, VisibilityMap& map, TraceStats* stats) {
  State& s = *state_;
  s.start = std::chrono::steady_clock::now();
  const Window window(camera.forward, camera.right, camera.up);
  const Border border = s.fill(camera, window);
  View& view = s.engine->view;
  s.stitcher.stitch(view.scene, camera, window, border, view.table, view.fragments, map);
  s.finish(stats);
  count(map, stats);
  if (stats) stats->left_out = part_of_window(camera, stats->left_out);
}

void Tracer::visible(const Camera& camera, std::vector<PolygonId>& polygons, TraceStats* stats) {
  State& s = *state_;
  s.start = std::chrono::steady_clock::now();
  s.fill(camera, Window(camera.forward, camera.right, camera.up));
  const View& view = s.engine->view;
  polygons.clear();
  for (const Fragment& f : view.fragments.fragments) {
    if (f.seen_count == 0) continue;
    polygons.push_back(view.scene.surfaces()[view.fragments.seen[f.first_seen]].polygon);
  }
  std::sort(polygons.begin(), polygons.end());
  polygons.erase(std::unique(polygons.begin(), polygons.end()), polygons.end());
  s.finish(stats);
  if (stats) stats->left_out = part_of_window(camera, stats->left_out);
}

void Tracer::areas(const Camera& camera, std::vector<PolygonArea>& areas, TraceStats* stats) {
  State& s = *state_;
  s.start = std::chrono::steady_clock::now();
  const Window window(camera.forward, camera.right, camera.up);
  const Border border = s.fill(camera, window);
  View& view = s.engine->view;
  s.stitcher.areas(view.scene, camera, window, border, view.table, view.fragments, areas);
  s.finish(stats);
  if (stats) stats->left_out = part_of_window(camera, stats->left_out);
}

namespace {

/// An eighth of all directions, by the signs of its coordinates: bit k says that coordinate k is negative.
void fill_octant(Engine& engine, unsigned octant) {
  SightlineRef side[3];
  glm::dvec3 ahead;
  for (unsigned k = 0; k < 3; ++k) {
    std::array<Integer, 3> n{0, 0, 0};
    n[k] = 1;
    const SightlineRef axis = engine.view.table.of_normal(n);
    const bool negative = octant >> k & 1;
    side[k] = negative ? -axis : axis;
    ahead[static_cast<int>(k)] = negative ? -1 : 1;
  }
  // x, z, y run counter-clockwise around the octant of the positive axes; each mirroring turns that round.
  const bool even = octant == 0 || octant == 3 || octant == 5 || octant == 6;
  const SightlineRef around[] = {side[0], even ? side[2] : side[1], even ? side[1] : side[2]};
  engine.fill(around, ahead);
}

}  // namespace

void Tracer::trace_sphere(const glm::dvec3& eye, VisibilityMap& map, TraceStats* stats) {
  State& s = *state_;
  s.start = std::chrono::steady_clock::now();
  s.begin(eye);
  View& view = s.engine->view;
  constexpr unsigned octants = 8;
  if (s.crew) {
    s.crew->fill(*s.engine, octants, fill_octant);
  } else {
    for (unsigned octant = 0; octant < octants; ++octant) fill_octant(*s.engine, octant);
  }
  s.stitcher.stitch_sphere(view.scene, eye, view.table, view.fragments, map);
  s.finish(stats);
  count(map, stats);
}

}  // namespace sightline
