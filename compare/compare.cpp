#include "compare/compare.hpp"

#include "beam/trace.hpp"
#include "bsp/tree.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace sightline::comparison {
namespace {

/// A method that has been prepared, or the reason why it could not be.
struct Prepared {
  std::unique_ptr<Method> method;
  std::string why;
};

Prepared prepare(const MethodName& name, const Scene& scene, double& seconds) {
  Prepared out;
  const double start = thread_seconds();
  try {
    out.method = name.make(scene);
  } catch (const std::runtime_error& error) {
    out.why = error.what();
  }
  seconds = thread_seconds() - start;
  if (out.method != nullptr) seconds = std::max(seconds, out.method->spent_elsewhere());
  return out;
}

ViewResult view(const Prepared& prepared, const Camera& camera, const Reference& exact, double usual) {
  Measured measured;
  measured.why = prepared.why;
  if (prepared.method != nullptr) measured = prepared.method->view(camera, usual);
  const bool failed = !measured.why.empty();
  return {measured.seconds, failed ? exact.error_of_nothing() : exact.error_of(measured.answer), measured.why};
}

Summary summarise(const MethodResult& method, bool all) {
  Summary out;
  std::vector<double> times;
  std::size_t counted = 0;
  for (const ViewResult& v : method.views) {
    const bool done = v.why.empty();
    if (done) times.push_back(v.seconds);
    out.failed += done ? 0 : 1;
    if (!done && !all) continue;
    ++counted;
    out.missed += v.error.missed;
    out.falsely += v.error.falsely;
    out.wrong_area += v.error.wrong_area;
    out.worst_area = std::max(out.worst_area, v.error.worst_area);
  }
  for (double* mean : {&out.missed, &out.falsely, &out.wrong_area}) {
    if (counted > 0) *mean /= static_cast<double>(counted);
  }
  std::ranges::sort(times);
  const std::size_t n = times.size();
  out.seconds = n == 0 ? std::numeric_limits<double>::quiet_NaN() : (times[(n - 1) / 2] + times[n / 2]) / 2;
  return out;
}

}  // namespace

Summary summary_of(const MethodResult& method) { return summarise(method, true); }
Summary summary_of_done(const MethodResult& method) { return summarise(method, false); }

std::vector<MethodResult> compare_methods(const Scene& scene, std::span<const Camera> cameras,
                                          std::span<const MethodName> methods, const std::function<void()>& step) {
  const BspTree tree(scene);
  Tracer tracer(tree);
  std::vector<MethodResult> results;
  std::vector<Prepared> prepared;
  for (const MethodName& name : methods) {
    results.push_back({name.text, 0, {}});
    prepared.push_back(prepare(name, scene, results.back().prepare_seconds));
  }
  VisibilityMap map;
  for (const Camera& camera : cameras) {
    const double begun = thread_seconds();
    tracer.trace(camera, map);
    const double seconds = thread_seconds() - begun;
    const Reference exact(map);
    for (std::size_t k = 0; k < methods.size(); ++k) {
      results[k].views.push_back(view(prepared[k], camera, exact, seconds));
    }
    step();
  }
  return results;
}

}  // namespace sightline::comparison
