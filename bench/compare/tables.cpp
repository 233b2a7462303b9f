// The tables, in Markdown.
#include <algorithm>
#include <array>
#include <cmath>

#include "bench/compare/report.hpp"

namespace sightline::peers {
namespace {

/// Three significant digits, `-` for none.
std::string number(double v, const char* before = "") {
  if (!(v > 0)) return "-";
  char text[64];
  const int digits = v >= 100  ? 0
                     : v >= 10 ? 1
                     : v >= 1  ? 2
                               : std::min(9, 2 - static_cast<int>(std::floor(std::log10(v))));
  std::snprintf(text, sizeof text, "%.*f", digits, v);
  std::string out = text;
  if (v >= 1000) {
    for (std::size_t at = out.size(); at > 3; at -= 3) out.insert(at - 3, ",");
  }
  return before + out;
}

std::string median_vertices(const SceneResult& scene) { return number(median(scene.map_vertices())); }

std::string median_visible(const SceneResult& scene) { return number(median(scene.visible_polygons())); }

}  // namespace

void print_scene(std::FILE* out, const SceneResult& scene) {
  std::fprintf(out, "\n### %s\n\n", scene.name.c_str());
  std::fprintf(out,
               "%u polygons, %u vertices, %d bits; made exact in %s s; %zu cameras; median %s polygons visible, %s map "
               "vertices; one incoherent ray %s us.\n\n",
               scene.polygons, scene.vertices, scene.bits, number(scene.read_seconds).c_str(), scene.cameras.size(),
               median_visible(scene).c_str(), median_vertices(scene).c_str(), number(scene.ray_seconds * 1e6).c_str());
  std::fprintf(
      out,
      "| method | prepared s | MB | views | ms median | ms worst | x ours median | least | most | x limit median "
      "| most | wrong views | missed | falsely visible |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const MethodResult& m : scene.methods) {
    if (m.kind == Method::Kind::ray) continue;
    if (!m.fault.empty()) {
      std::fprintf(out, "| %s | failed: %s |\n", m.name.c_str(), m.fault.c_str());
      continue;
    }
    const Figures f = figures_of(scene, m);
    const char* least = 2 * f.cut_off >= f.views && f.cut_off > 0 ? ">" : "";
    const char* worst = f.cut_off > 0 ? ">" : "";
    std::string views = std::to_string(f.views);
    if (f.cut_off > 0) views += ", " + std::to_string(f.cut_off) + " cut off";
    if (f.failed > 0) views += ", " + std::to_string(f.failed) + " failed";
    std::fprintf(out, "| %s | %s | %s | %s | %s | %s | %s | %s | %s | %s | %s |", m.name.c_str(),
                 number(m.cost.seconds).c_str(), number(static_cast<double>(m.cost.bytes) / 1e6).c_str(), views.c_str(),
                 number(f.median_seconds * 1e3, least).c_str(), number(f.worst_seconds * 1e3, worst).c_str(),
                 number(f.to_ours, least).c_str(), number(f.to_ours_least).c_str(),
                 number(f.to_ours_most, worst).c_str(), number(f.to_limit, least).c_str(),
                 number(f.to_limit_most, worst).c_str());
    if (f.judged == 0) {
      std::fprintf(out, " - | - | - |\n");
    } else {
      std::fprintf(out, " %zu of %zu | %zu | %zu |\n", f.wrong_views, f.judged, f.missed, f.falsely);
    }
    for (const ViewResult& v : m.views) {
      if (v.outcome.status != Status::failed) continue;
      std::fprintf(stderr, "%s: %s failed: %s\n", scene.name.c_str(), m.name.c_str(), v.outcome.note.c_str());
      break;
    }
  }
  std::fflush(out);
}

void print_summary(std::FILE* out, std::span<const SceneResult> scenes) {
  std::vector<std::string> names;
  for (const SceneResult& s : scenes) {
    for (const MethodResult& m : s.methods) {
      if (m.kind != Method::Kind::ray && std::ranges::find(names, m.name) == names.end()) names.push_back(m.name);
    }
  }
  std::fprintf(
      out,
      "\n### The measure that counts\n\nTime / (map vertices x one incoherent ray of the same run), median over "
      "the cameras; in brackets the median time in ms.\n\n| scene | polygons | visible | map vertices | one ray us "
      "| limit us |");
  for (const std::string& n : names) std::fprintf(out, " %s |", n.c_str());
  std::fprintf(out, "\n|---|---|---|---|---|---|");
  for (std::size_t k = 0; k < names.size(); ++k) std::fprintf(out, "---|");
  std::fprintf(out, "\n");
  for (const SceneResult& s : scenes) {
    const double limit = median(s.map_vertices()) * s.ray_seconds * 1e6;
    std::fprintf(out, "| %s | %u | %s | %s | %s | %s |", s.name.c_str(), s.polygons, median_visible(s).c_str(),
                 median_vertices(s).c_str(), number(s.ray_seconds * 1e6).c_str(), number(limit).c_str());
    for (const std::string& n : names) {
      const auto m = std::ranges::find(s.methods, n, &MethodResult::name);
      if (m == s.methods.end() || std::ranges::none_of(m->views, &ViewResult::begun)) {
        std::fprintf(out, " - |");
        continue;
      }
      const Figures f = figures_of(s, *m);
      const char* least = 2 * f.cut_off >= f.views && f.cut_off > 0 ? ">" : "";
      std::fprintf(out, " %s (%s) |", number(f.to_limit, least).c_str(), number(f.median_seconds * 1e3, least).c_str());
    }
    std::fprintf(out, "\n");
  }
  std::fflush(out);
}

}  // namespace sightline::peers
