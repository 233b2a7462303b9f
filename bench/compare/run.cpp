#include "bench/compare/run.hpp"

#include "bench/compare/pieces.hpp"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>

namespace sightline::peers {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

const MethodResult* SceneResult::reference() const {
  for (const MethodResult& m : methods) {
    if (m.kind == Method::Kind::map && std::ranges::any_of(m.views, &ViewResult::done)) return &m;
  }
  return nullptr;
}

std::vector<double> SceneResult::visible_polygons() const {
  std::vector<double> out;
  if (reference() == nullptr) return out;
  for (const ViewResult& v : reference()->views) {
    if (v.done()) out.push_back(static_cast<double>(v.outcome.visible.size()));
  }
  return out;
}

std::vector<double> SceneResult::map_vertices() const {
  std::vector<double> out;
  if (reference() == nullptr) return out;
  for (const ViewResult& v : reference()->views) {
    if (v.done()) out.push_back(v.outcome.vertices);
  }
  return out;
}

namespace {

std::vector<std::size_t> spread(std::size_t available, std::size_t wanted) {
  if (wanted == 0 || wanted > available) wanted = available;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < wanted; ++k) out.push_back(k * available / wanted);
  return out;
}

/// Where coplanar polygons lie in the same place, any one of them is the right answer.
void judge(const Outcome& truth, ViewResult& view) {
  const std::vector<PolygonId>& named = view.outcome.visible;
  std::set<PolygonId> may(truth.visible.begin(), truth.visible.end());
  std::set<PolygonId> found(named.begin(), named.end());
  for (const auto& [seen, same] : truth.coincident) {
    may.insert(same);
    if (std::ranges::binary_search(named, same)) found.insert(seen);
  }
  view.judged = true;
  view.missed = view.falsely = 0;
  for (const PolygonId p : truth.visible) view.missed += found.contains(p) ? 0U : 1U;
  for (const PolygonId p : named) view.falsely += may.contains(p) ? 0U : 1U;
}

/// A method that runs in this process, with the times of its passes.
struct Racer {
  Method* method;
  MethodResult* result;
  std::vector<std::vector<double>> times;
  double spent = 0;
};

/// The cameras in turn: each is met with the caches as another camera left them.
void one_pass(Racer& racer, const std::vector<Camera>& cameras, const RunOptions& options, bool first) {
  for (std::size_t k = 0; k < cameras.size() && racer.spent < options.budget; ++k) {
    Outcome out;
    const double start = cpu_seconds();
    try {
      out = racer.method->map(cameras[k], first ? Want::visible : Want::time);
    } catch (const std::exception& e) {
      out = failure(e.what());
    }
    racer.spent += cpu_seconds() - start;
    if (first) racer.result->views[k].outcome = out;
    if (!first && out.status == Status::done) racer.times[k].push_back(out.seconds);
  }
}

/// All methods in turn, some times over: what else the machine does meets all of them alike. The first pass warms
/// buffers, and counts only where there is no other.
void race(std::vector<Racer>& racers, const std::vector<Camera>& cameras, const RunOptions& options) {
  for (int pass = 0; pass <= options.passes; ++pass) {
    for (Racer& racer : racers) one_pass(racer, cameras, options, pass == 0);
  }
  for (Racer& racer : racers) {
    for (std::size_t k = 0; k < racer.result->views.size(); ++k) {
      if (!racer.times[k].empty()) racer.result->views[k].outcome.seconds = median(racer.times[k]);
    }
  }
}

/// The cameras from the one with the median number of pieces in its view outwards: where the budget allows a slow
/// method a few views only, these are ordinary ones.
std::vector<std::size_t> ordinary_first(const Scene& scene, const Pieces& pieces, const std::vector<Camera>& cameras) {
  std::vector<std::pair<std::uint32_t, std::size_t>> by_size;
  Projected view;
  for (std::size_t k = 0; k < cameras.size(); ++k) {
    project(scene, pieces, cameras[k], view);
    by_size.emplace_back(view.size(), k);
  }
  std::ranges::sort(by_size);
  std::vector<std::size_t> out;
  const std::size_t n = by_size.size();
  for (std::size_t step = 0; step < n; ++step) {  // n/2, n/2 - 1, n/2 + 1, ...
    const std::size_t half = (step + 1) / 2, at = step % 2 == 1 ? n / 2 - half : n / 2 + half;
    out.push_back(by_size[at].second);
  }
  return out;
}

void run_children(Method& method, const std::vector<Camera>& cameras, std::span<const std::size_t> order,
                  const RunOptions& options, MethodResult& result) {
  double spent = 0;
  for (const std::size_t k : order) {
    if (spent >= options.budget) break;
    result.views[k].outcome = map_in_child(method, cameras[k], options.child);
    spent += result.views[k].outcome.seconds;
  }
}

}  // namespace

SceneResult run(Subject subject, const Methods& methods, const RunOptions& options) {
  SceneResult out;
  out.name = subject.name;
  out.cameras = spread(subject.cameras.size(), options.cameras);
  std::vector<Camera> cameras;
  for (const std::size_t k : out.cameras) cameras.push_back(subject.cameras[k]);
  const double start = cpu_seconds();
  const Scene scene = make_scene(std::move(subject.soup));
  out.read_seconds = cpu_seconds() - start;
  out.polygons = scene.polygon_count();
  out.vertices = static_cast<std::uint32_t>(scene.soup().vertices.size());
  out.bits = scene.grid().bits();
  const Pieces pieces = pieces_of(scene);
  out.left_out = pieces.left_out;
  const std::vector<std::size_t> order = ordinary_first(scene, pieces, cameras);
  out.methods.reserve(methods.size());  // racers point into it
  std::vector<Racer> racers;
  for (const auto& method : methods) {
    out.methods.push_back({method->name(), method->kind(), {}, {}, std::vector<ViewResult>(cameras.size())});
    if (method->in_child()) continue;
    MethodResult& result = out.methods.back();
    std::fprintf(stderr, "%s: %s prepares\n", out.name.c_str(), method->name().c_str());
    try {
      result.cost = method->prepare(scene);
      racers.push_back({method.get(), &result, std::vector<std::vector<double>>(cameras.size()), 0});
    } catch (const std::exception& e) {
      result.fault = e.what();
    }
  }
  std::fprintf(stderr, "%s: %zu methods, %zu cameras\n", out.name.c_str(), racers.size(), cameras.size());
  race(racers, cameras, options);
  for (std::size_t k = 0; k < methods.size(); ++k) {
    if (!methods[k]->in_child()) continue;
    std::fprintf(stderr, "%s: %s\n", out.name.c_str(), methods[k]->name().c_str());
    try {
      out.methods[k].cost = methods[k]->prepare(scene);
      run_children(*methods[k], cameras, order, options, out.methods[k]);
    } catch (const std::exception& e) {
      out.methods[k].fault = e.what();
    }
  }
  for (const auto& method : methods) method->release();

  std::vector<double> rays;
  for (const MethodResult& m : out.methods) {
    if (m.kind != Method::Kind::ray) continue;
    for (const ViewResult& v : m.views) {
      if (v.done()) rays.push_back(v.outcome.seconds);
    }
  }
  out.ray_seconds = median(rays);
  if (const MethodResult* reference = out.reference()) {
    const std::vector<ViewResult> truth = reference->views;
    for (MethodResult& m : out.methods) {
      for (std::size_t k = 0; k < truth.size(); ++k) {
        const bool both = m.views[k].done() && truth[k].done();
        if (both && m.views[k].outcome.gives_visible) judge(truth[k].outcome, m.views[k]);
      }
    }
  }
  return out;
}

}  // namespace sightline::peers
