#include "verify/map_file.hpp"

#include "verify/read.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace sightline::verify {

using nlohmann::json;

namespace {

constexpr std::array<const char*, 5> kind_names{"silhouette", "crease", "seam", "intersection", "window"};

/// What is wrong with a value: its place in the file and why.
struct SchemaFault {
  std::string item, what;
};

/// A value with its place.
class Value {
 public:
  Value(const json& value, std::string place) : value_(value), place_(std::move(place)) {}
  [[noreturn]] void fail(const std::string& what) const { throw SchemaFault{place_, what}; }

  Value operator[](const char* key) const {
    if (!value_.is_object()) fail("is no object");
    const auto found = value_.find(key);
    if (found == value_.end()) fail(std::string("has no \"") + key + "\"");
    return {*found, place_.empty() ? key : place_ + "." + key};
  }
  Value at(std::size_t i) const { return {value_[i], place_ + "[" + std::to_string(i) + "]"}; }
  std::size_t size() const {
    if (!value_.is_array()) fail("is no list");
    return value_.size();
  }
  void expect_size(std::size_t n) const {
    if (size() != n) fail("has not " + std::to_string(n) + " items");
  }
  bool is_null() const { return value_.is_null(); }
  std::string string() const {
    if (!value_.is_string()) fail("is no string");
    return value_.get<std::string>();
  }
  double number() const {
    if (!value_.is_number()) fail("is no number");
    const double x = value_.get<double>();
    if (!std::isfinite(x)) fail("is not finite");
    return x;
  }
  std::int64_t integer() const {
    if (!value_.is_number_integer()) fail("is no integer");
    if (value_.is_number_unsigned() && value_.get<std::uint64_t>() > INT64_MAX) fail("is out of range");
    return value_.get<std::int64_t>();
  }
  /// An integer from 0 to count - 1.
  std::uint32_t index(std::size_t count) const {
    const std::int64_t i = integer();
    if (i < 0 || static_cast<std::uint64_t>(i) >= count) fail("is " + std::to_string(i) + ", out of range");
    return static_cast<std::uint32_t>(i);
  }
  std::uint32_t index_or_null(std::size_t count) const { return is_null() ? none : index(count); }
  std::array<double, 3> vector() const {
    expect_size(3);
    return {at(0).number(), at(1).number(), at(2).number()};
  }

 private:
  const json& value_;
  std::string place_;
};

template <std::size_t N>
std::uint32_t one_of(const Value& value, const std::array<const char*, N>& names) {
  const std::string name = value.string();
  for (std::uint32_t i = 0; i < N; ++i) {
    if (name == names[i]) return i;
  }
  value.fail("is \"" + name + "\"");
}

MapLine read_line(const Value& value, std::size_t scene_vertices) {
  MapLine line;
  if (value.size() == 0) value.fail("is empty");
  line.kind = static_cast<MapLine::Kind>(one_of(value.at(0), std::array{"window", "edge", "planes"}));
  value.expect_size(line.kind == MapLine::window ? 2 : 3);
  if (line.kind == MapLine::window) {
    line.v[0] = one_of(value.at(1), std::array{"left", "right", "bottom", "top"});
  } else if (line.kind == MapLine::edge) {
    line.v[0] = value.at(1).index(scene_vertices);
    line.v[1] = value.at(2).index(scene_vertices);
  } else {
    for (std::size_t side = 0; side < 2; ++side) {
      value.at(side + 1).expect_size(3);
      for (std::size_t i = 0; i < 3; ++i) line.v[3 * side + i] = value.at(side + 1).at(i).index(scene_vertices);
    }
  }
  return line;
}

/// Names of places are made only for what is looked at: one Value an item, not one a number.
MapFile read_map(const json& root) {
  MapFile map;
  const Value top(root, "");
  if (top["format"].string() != "sightline-map") top["format"].fail("is not \"sightline-map\"");
  if (top["version"].integer() != 1) top["version"].fail("is not 1");
  const Value scene = top["scene"], camera = top["camera"];
  scene["source"].string();
  map.scene_vertices = scene["vertices"].index(none);
  map.scene_polygons = scene["polygons"].index(none);
  if (!scene["snap"].is_null()) {
    map.snap = scene["snap"].string();
    if (map.snap.empty()) scene["snap"].fail("is empty");
  }
  map.eye = camera["eye"].vector();
  map.forward = camera["forward"].vector();
  map.right = camera["right"].vector();
  map.up = camera["up"].vector();

  const Value lines = top["lines"], vertices = top["vertices"], edges = top["edges"], faces = top["faces"];
  for (std::size_t i = 0; i < lines.size(); ++i) map.lines.push_back(read_line(lines.at(i), map.scene_vertices));
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Value v = vertices.at(i), st = v["st"], pair = v["lines"];
    st.expect_size(2);
    pair.expect_size(2);
    map.vertices.push_back({{st.at(0).number(), st.at(1).number()},
                            {pair.at(0).index(map.lines.size()), pair.at(1).index(map.lines.size())},
                            v["scene_vertex"].index_or_null(map.scene_vertices)});
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Value e = edges.at(i), ends = e["vertices"];
    ends.expect_size(2);
    map.edges.push_back({{ends.at(0).index(map.vertices.size()), ends.at(1).index(map.vertices.size())},
                         e["line"].index(map.lines.size()),
                         e["left"].index_or_null(faces.size()),
                         e["right"].index_or_null(faces.size()),
                         static_cast<EdgeKind>(one_of(e["kind"], kind_names)),
                         e["owner"].index_or_null(map.scene_polygons)});
  }
  const auto edge_count = static_cast<std::int64_t>(edges.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Value f = faces.at(i), coincident = f["coincident"], loops = f["loops"];
    MapFace face;
    face.polygon = f["polygon"].index_or_null(map.scene_polygons);
    face.area = f["area"].number();
    face.solid_angle = f["solid_angle"].number();
    for (std::size_t k = 0; k < coincident.size(); ++k) {
      face.coincident.push_back(coincident.at(k).index(map.scene_polygons));
      if (k > 0 && face.coincident[k] <= face.coincident[k - 1]) coincident.fail("does not ascend");
    }
    for (std::size_t k = 0; k < loops.size(); ++k) {
      const Value loop = loops.at(k);
      auto& entries = face.loops.emplace_back();
      for (std::size_t j = 0; j < loop.size(); ++j) {
        const std::int64_t entry = loop.at(j).integer();
        if (entry >= edge_count || entry < -edge_count)
          loop.at(j).fail("is " + std::to_string(entry) + ", out of range");
        entries.push_back(static_cast<std::int32_t>(entry));
      }
    }
    map.faces.push_back(std::move(face));
  }
  return map;
}

}  // namespace

const char* name_of(EdgeKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

std::optional<MapFile> parse_map(const std::string& file, std::string_view text, Report& report) {
  json root;
  try {
    root = json::parse(text);
  } catch (const json::exception& error) {
    std::string what = error.what();
    for (char& c : what) {
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    throw InputError(file + ": is no JSON: " + what);
  }
  try {
    return read_map(root);
  } catch (const SchemaFault& fault) {
    report.fault("schema", fault.item.empty() ? "map" : fault.item, fault.what);
    return std::nullopt;
  }
}

}  // namespace sightline::verify
