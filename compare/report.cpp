#include "compare/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

namespace sightline::comparison {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char line[256];
  std::snprintf(line, sizeof line, format, values...);
  return line;
}

std::string area(double a) { return a == 0 ? "0" : formatted("%.2e", a); }

}  // namespace

std::string table(std::span<const MethodResult> methods) {
  std::size_t width = 6;
  for (const MethodResult& m : methods) width = std::max(width, m.name.size());
  const int w = static_cast<int>(width);
  std::string text = formatted("%-*s %12s %12s %10s %10s %12s %12s %7s\n", w, "method", "prepare ms", "ms a view",
                               "missed", "false", "wrong area", "worst area", "failed");
  for (const MethodResult& m : methods) {
    const Summary s = summary_of(m);
    text += formatted("%-*s %12.2f %12.4f %10.3g %10.3g %12s %12s %7zu\n", w, m.name.c_str(), m.prepare_seconds * 1e3,
                      s.seconds * 1e3, s.missed, s.falsely, area(s.wrong_area).c_str(), area(s.worst_area).c_str(),
                      s.failed);
  }
  for (const MethodResult& m : methods) {
    const Summary s = summary_of_done(m);
    if (s.failed == 0) continue;
    std::map<std::string, int> reasons;
    for (const ViewResult& v : m.views) {
      if (!v.why.empty()) ++reasons[v.why];
    }
    text += formatted("%s failed in %zu of %zu views, counted above as showing nothing", m.name.c_str(), s.failed,
                      m.views.size());
    if (s.failed < m.views.size()) {
      text += formatted("; in the others: missed %.3g, false %.3g, wrong area %s, worst area %s", s.missed, s.falsely,
                        area(s.wrong_area).c_str(), area(s.worst_area).c_str());
    }
    for (const auto& [why, count] : reasons) text += formatted("\n  %d x ", count) + why;
    text += "\n";
  }
  return text;
}

std::string json(std::span<const MethodResult> methods, std::size_t cameras) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const MethodResult& m : methods) {
    const Summary s = summary_of(m);
    list.push_back({{"name", m.name},
                    {"seconds", s.seconds},
                    {"missed", s.missed},
                    {"false", s.falsely},
                    {"wrong_area", s.wrong_area},
                    {"worst_area", s.worst_area}});
  }
  return nlohmann::ordered_json{{"methods", list}, {"cameras", cameras}}.dump(1) + "\n";
}

std::string csv(std::span<const MethodResult> methods) {
  std::string text = "camera,method,seconds,missed,false,wrong_area,worst_area,failed\n";
  const std::size_t cameras = methods.empty() ? 0 : methods.front().views.size();
  for (std::size_t k = 0; k < cameras; ++k) {
    for (const MethodResult& m : methods) {
      const ViewResult& v = m.views[k];
      text += formatted("%zu,%s,%.9g,%u,%u,%.17g,%.17g,%d\n", k, m.name.c_str(), v.seconds, v.error.missed,
                        v.error.falsely, v.error.wrong_area, v.error.worst_area, v.why.empty() ? 0 : 1);
    }
  }
  return text;
}

}  // namespace sightline::comparison
