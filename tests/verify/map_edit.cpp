#include "map_edit.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace sightline::verify {

std::string data_file(const std::string& name) { return std::string(VERIFY_DATA) + "/" + name; }

Json load_map(const std::string& name) { return Json::parse(load_file(data_file(name + ".map.json"))); }

Report check_map(const std::string& name, const Json& map) {
  Options options;
  options.one_sided = name == "one_sided";
  return Verifier(read_scene(data_file(name + ".obj")), options).check(name, map.dump());
}

std::string checks_of(const Report& report) {
  std::string names;
  for (const auto& [check, entry] : report.checks()) names += check + " ";
  return names;
}

std::string all_faults(const Report& report) {
  std::string text;
  for (const auto& [check, entry] : report.checks()) {
    for (const Fault& fault : entry.first) text += check + ": " + fault.item + ": " + fault.what + "\n";
  }
  return text;
}

std::vector<std::size_t> edges_of_kind(const Json& map, const std::string& kind) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < map["edges"].size(); ++i) {
    if (map["edges"][i]["kind"] == kind) out.push_back(i);
  }
  return out;
}

std::size_t split_edge(Json& map, std::size_t edge, double s, double t, std::size_t line) {
  const std::size_t vertex = map["vertices"].size();
  Json first = map["edges"][edge], second = first;
  map["vertices"].push_back({{"st", {s, t}}, {"lines", {first["line"], line}}, {"scene_vertex", nullptr}});
  first["vertices"][1] = vertex;
  second["vertices"][0] = vertex;
  map["edges"][edge] = first;
  map["edges"].push_back(second);
  return vertex;
}

void remove_edges(Json& map, std::vector<std::size_t> edges) {
  std::sort(edges.rbegin(), edges.rend());
  for (const std::size_t e : edges) map["edges"].erase(e);
  for (std::size_t v = map["vertices"].size(); v-- > 0;) {
    bool used = false;
    for (const Json& e : map["edges"]) used = used || e["vertices"][0] == v || e["vertices"][1] == v;
    if (used) continue;
    map["vertices"].erase(v);
    for (Json& e : map["edges"]) {
      for (Json& end : e["vertices"]) {
        if (end.get<std::size_t>() > v) end = end.get<std::size_t>() - 1;
      }
    }
  }
}

void remove_face(Json& map, std::size_t face) {
  map["faces"].erase(face);
  for (Json& e : map["edges"]) {
    for (const char* side : {"left", "right"}) {
      if (!e[side].is_null() && e[side].get<std::size_t>() > face) e[side] = e[side].get<std::size_t>() - 1;
    }
  }
}

namespace {

std::size_t end_of(const Json& map, long entry, bool last) {
  const bool forwards = entry >= 0;
  const Json& edge = map["edges"][static_cast<std::size_t>(forwards ? entry : -entry - 1)];
  return edge["vertices"][forwards == last ? 1 : 0].get<std::size_t>();
}

std::array<double, 2> place(const Json& map, std::size_t vertex) {
  return {map["vertices"][vertex]["st"][0].get<double>(), map["vertices"][vertex]["st"][1].get<double>()};
}

double direction(const Json& map, long entry) {
  const auto a = place(map, end_of(map, entry, false)), b = place(map, end_of(map, entry, true));
  return std::atan2(b[1] - a[1], b[0] - a[0]);
}

double area(const Json& map, const std::vector<long>& loop) {
  double sum = 0;
  for (const long entry : loop) {
    const auto a = place(map, end_of(map, entry, false)), b = place(map, end_of(map, entry, true));
    sum += (a[0] * b[1] - b[0] * a[1]) / 2;
  }
  return sum;
}

}  // namespace

void retrace(Json& map) {
  for (std::size_t f = 0; f < map["faces"].size(); ++f) {
    std::set<long> left;
    for (std::size_t e = 0; e < map["edges"].size(); ++e) {
      if (map["edges"][e]["left"] == f) left.insert(static_cast<long>(e));
      if (map["edges"][e]["right"] == f) left.insert(-static_cast<long>(e) - 1);
    }
    const std::set<long> all = left;
    std::vector<std::vector<long>> loops;
    while (!left.empty()) {
      std::vector<long> loop;
      for (long entry = *left.begin(); left.erase(entry) > 0;) {
        loop.push_back(entry);
        // The next entry clockwise, seen from the vertex, after the way back.
        const double back = direction(map, -entry - 1);
        double least = 10;
        long next = entry;
        for (const long other : all) {
          if (end_of(map, other, false) != end_of(map, entry, true)) continue;
          double turn = std::remainder(back - direction(map, other), 2 * M_PI);
          if (turn <= 1e-9) turn += 2 * M_PI;
          if (turn < least) {
            least = turn;
            next = other;
          }
        }
        entry = next;
      }
      loops.push_back(loop);
    }
    std::sort(loops.begin(), loops.end(), [&](const auto& a, const auto& b) { return area(map, a) > area(map, b); });
    map["faces"][f]["loops"] = loops;
  }
}

}  // namespace sightline::verify
