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
    if (m.kind == Method::Kind::map && !m.views.empty()) return &m;
  }
  return nullptr;
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
    if (first) racer.result->views.push_back({out, false, 0, 0});
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

void run_children(Method& method, const std::vector<Camera>& cameras, const RunOptions& options, MethodResult& result) {
  double spent = 0;
  for (const Camera& camera : cameras) {
    if (spent >= options.budget) break;
    result.views.push_back({map_in_child(method, camera, options.child), false, 0, 0});
    spent += result.views.back().outcome.seconds;
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
  out.left_out = pieces_of(scene).left_out;
  out.methods.reserve(methods.size());  // racers point into it
  std::vector<Racer> racers;
  for (const auto& method : methods) {
    out.methods.push_back({method->name(), method->kind(), {}, {}, {}});
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
      run_children(*methods[k], cameras, options, out.methods[k]);
    } catch (const std::exception& e) {
      out.methods[k].fault = e.what();
    }
  }
  for (const auto& method : methods) method->release();

  std::vector<double> rays;
  for (const MethodResult& m : out.methods) {
    if (m.kind != Method::Kind::ray) continue;
    for (const ViewResult& v : m.views) rays.push_back(v.outcome.seconds);
  }
  out.ray_seconds = median(rays);
  if (const MethodResult* reference = out.reference()) {
    const std::vector<ViewResult> truth = reference->views;
    for (const ViewResult& v : truth) out.visible.push_back(static_cast<std::uint32_t>(v.outcome.visible.size()));
    for (MethodResult& m : out.methods) {
      for (std::size_t k = 0; k < std::min(m.views.size(), truth.size()); ++k) {
        const bool both = m.views[k].outcome.status == Status::done && truth[k].outcome.status == Status::done;
        if (both && m.views[k].outcome.gives_visible) judge(truth[k].outcome, m.views[k]);
      }
    }
  }
  return out;
}

}  // namespace sightline::peers
