#include "visibility_map/read.hpp"

#include "exact/window.hpp"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace sightline {

namespace {

using Json = nlohmann::json;

/// Reads one document; every member throws InputError naming the item.
class Reader {
 public:
  Reader(const Json& json, const std::string& name) : json_(json), name_(name) {}

  MapFile read() {
    if (!json_.is_object()) fail("the file", "is no JSON object");
    if (member(json_, "format", "the file") != "sightline-map") fail("format", "is not \"sightline-map\"");
    if (member(json_, "version", "the file") != 1) fail("version", "is not 1");
    read_scene(member(json_, "scene", "the file"));
    read_camera(member(json_, "camera", "the file"));
    each("lines", [&](const Json& j, const std::string& item) { map_.lines.push_back(line(j, item)); });
    each("vertices", [&](const Json& j, const std::string& item) { map_.vertices.push_back(vertex(j, item)); });
    each("edges", [&](const Json& j, const std::string& item) { map_.edges.push_back(edge(j, item)); });
    each("faces", [&](const Json& j, const std::string& item) { read_face(j, item); });
    check_connections();
    return {std::move(scene_), std::move(map_)};
  }

 private:
  [[noreturn]] void fail(const std::string& item, const std::string& what) const {
    throw InputError(name_ + ": " + item + ": " + what);
  }

  const Json& member(const Json& j, const char* key, const std::string& item) const {
    const auto found = j.find(key);
    if (found == j.end()) fail(item, std::string("has no \"") + key + '"');
    return *found;
  }
  const Json& object(const Json& j, const std::string& item) const {
    if (!j.is_object()) fail(item, "is no object");
    return j;
  }
  const Json& array(const Json& j, const std::string& item, std::size_t size = 0) const {
    if (!j.is_array()) fail(item, "is no array");
    if (size > 0 && j.size() != size) fail(item, "has not " + std::to_string(size) + " elements");
    return j;
  }
  template <class Read>
  void each(const char* key, Read read_element) {
    const Json& elements = array(member(json_, key, "the file"), key);
    if (elements.size() > 0x7fffffff) fail(key, "has too many elements");
    std::size_t index = 0;
    for (const Json& j : elements) read_element(j, key + ('[' + std::to_string(index++) + ']'));
  }

  double number(const Json& j, const std::string& item) const {
    if (!j.is_number()) fail(item, "is no number");
    const double value = j.get<double>();
    if (!std::isfinite(value)) fail(item, "is not finite");
    return value;
  }
  std::uint32_t index(const Json& j, const std::string& item, std::uint64_t size) const {
    if (!j.is_number_unsigned()) fail(item, "is no index");
    const auto value = j.get<std::uint64_t>();
    if (value >= size || value >= none) fail(item, "index " + std::to_string(value) + " is out of range");
    return static_cast<std::uint32_t>(value);
  }
  std::uint32_t index_or_none(const Json& j, const std::string& item, std::uint64_t size) const {
    return j.is_null() ? none : index(j, item, size);
  }
  glm::dvec3 vector(const Json& j, const char* key) const {
    const std::string item = std::string("camera.") + key;
    const Json& v = array(member(j, key, "camera"), item, 3);
    return {number(v[0], item), number(v[1], item), number(v[2], item)};
  }
  std::string string(const Json& j, const std::string& item) const {
    if (!j.is_string()) fail(item, "is no string");
    return j.get<std::string>();
  }

  void read_scene(const Json& j) {
    object(j, "scene");
    scene_.source = string(member(j, "source", "scene"), "scene.source");
    const auto count = [&](const char* key) -> std::uint64_t {
      const Json& value = member(j, key, "scene");
      if (!value.is_number_unsigned()) fail(std::string("scene.") + key, "is no count");
      return value.get<std::uint64_t>();
    };
    scene_.vertices = count("vertices");
    scene_.polygons = count("polygons");
    const Json& snap = member(j, "snap", "scene");
    if (!snap.is_null()) scene_.snap = string(snap, "scene.snap");
  }

  void read_camera(const Json& j) {
    object(j, "camera");
    map_.camera = {vector(j, "eye"), vector(j, "forward"), vector(j, "right"), vector(j, "up")};
    try {
      Window(map_.camera.forward, map_.camera.right, map_.camera.up);
    } catch (const std::invalid_argument& e) {
      fail("camera", e.what());
    }
  }

  MapLine line(const Json& j, const std::string& item) const {
    array(j, item);
    if (j.empty()) fail(item, "is empty");
    MapLine line{};
    const auto points = [&](const Json& list, std::size_t first, std::size_t count, int to) {
      for (std::size_t k = 0; k < count; ++k) line.v[to++] = index(list[first + k], item, scene_.vertices);
    };
    const std::string kind = string(j[0], item);
    if (kind == "window") {
      constexpr const char* sides[] = {"left", "right", "bottom", "top"};
      const std::string side = string(array(j, item, 2)[1], item);
      const auto* found = std::find(std::begin(sides), std::end(sides), side);
      if (found == std::end(sides)) fail(item, "names no side of the window");
      line.kind = MapLine::window;
      line.v[0] = static_cast<std::uint32_t>(found - std::begin(sides));
    } else if (kind == "edge") {
      line.kind = MapLine::edge;
      points(array(j, item, 3), 1, 2, 0);
    } else if (kind == "planes") {
      line.kind = MapLine::planes;
      array(j, item, 3);
      points(array(j[1], item, 3), 0, 3, 0);
      points(array(j[2], item, 3), 0, 3, 3);
    } else {
      fail(item, "is no line");
    }
    return line;
  }

  MapVertex vertex(const Json& j, const std::string& item) const {
    object(j, item);
    MapVertex v{};
    const Json& st = array(member(j, "st", item), item + ".st", 2);
    v.st = {number(st[0], item + ".st"), number(st[1], item + ".st")};
    const Camera& c = map_.camera;
    v.direction = glm::normalize(c.forward + (v.st.x - 0.5) * c.right + (v.st.y - 0.5) * c.up);
    const Json& lines = array(member(j, "lines", item), item + ".lines", 2);
    for (std::size_t k = 0; k < 2; ++k) v.line[k] = index(lines[k], item + ".lines", map_.lines.size());
    v.scene_vertex = index_or_none(member(j, "scene_vertex", item), item + ".scene_vertex", scene_.vertices);
    return v;
  }

  MapEdge edge(const Json& j, const std::string& item) const {
    object(j, item);
    MapEdge e{};
    const Json& ends = array(member(j, "vertices", item), item + ".vertices", 2);
    for (std::size_t k = 0; k < 2; ++k) e.vertex[k] = index(ends[k], item + ".vertices", map_.vertices.size());
    e.line = index(member(j, "line", item), item + ".line", map_.lines.size());
    const std::size_t faces = array(member(json_, "faces", "the file"), "faces").size();
    e.left = index_or_none(member(j, "left", item), item + ".left", faces);
    e.right = index_or_none(member(j, "right", item), item + ".right", faces);
    if (e.left == none && e.right == none) fail(item, "has no face on either side");
    constexpr const char* kinds[] = {"silhouette", "crease", "seam", "intersection", "window"};
    const std::string kind = string(member(j, "kind", item), item + ".kind");
    const auto* found = std::find(std::begin(kinds), std::end(kinds), kind);
    if (found == std::end(kinds)) fail(item + ".kind", "is no kind of edge");
    e.kind = static_cast<EdgeKind>(found - std::begin(kinds));
    e.owner = index_or_none(member(j, "owner", item), item + ".owner", scene_.polygons);
    return e;
  }

  void read_face(const Json& j, const std::string& item) {
    object(j, item);
    MapFace face{};
    face.polygon = index_or_none(member(j, "polygon", item), item + ".polygon", scene_.polygons);
    face.first_coincident = static_cast<std::uint32_t>(map_.coincident.size());
    for (const Json& p : array(member(j, "coincident", item), item + ".coincident")) {
      map_.coincident.push_back(index(p, item + ".coincident", scene_.polygons));
    }
    face.coincident_count = static_cast<std::uint32_t>(map_.coincident.size()) - face.first_coincident;
    face.first_loop = static_cast<std::uint32_t>(map_.first_edge.size()) - 1;
    for (const Json& loop : array(member(j, "loops", item), item + ".loops")) {
      if (array(loop, item + ".loops").empty()) fail(item + ".loops", "an empty loop");
      for (const Json& e : loop) {
        const auto edges = static_cast<std::int64_t>(map_.edges.size());
        if (!e.is_number_integer()) fail(item + ".loops", "is no reference to an edge");
        const auto value = e.get<std::int64_t>();
        if (value >= edges || value < -edges || (e.is_number_unsigned() && value < 0)) {
          fail(item + ".loops", "edge " + e.dump() + " is out of range");
        }
        map_.loop_edges.push_back(static_cast<std::int32_t>(value));
      }
      map_.first_edge.push_back(static_cast<std::uint32_t>(map_.loop_edges.size()));
    }
    face.loop_count = static_cast<std::uint32_t>(map_.first_edge.size()) - 1 - face.first_loop;
    if (face.loop_count == 0) fail(item, "has no loop");
    face.area = number(member(j, "area", item), item + ".area");
    face.solid_angle = number(member(j, "solid_angle", item), item + ".solid_angle");
    map_.faces.push_back(face);
  }

  void check_connections() const {
    std::vector<char> used(2 * map_.edges.size());
    for (std::uint32_t f = 0; f < map_.faces.size(); ++f) {
      const MapFace& face = map_.faces[f];
      const std::string item = "faces[" + std::to_string(f) + "].loops";
      for (std::uint32_t k = 0; k < face.loop_count; ++k) {
        const auto loop = map_.loop(face.first_loop + k);
        std::uint32_t at = head(loop.back());
        for (const std::int32_t e : loop) {
          const bool forwards = e >= 0;
          const auto number = static_cast<std::size_t>(forwards ? e : -(e + 1));
          const MapEdge& edge = map_.edges[number];
          if (edge.vertex[forwards ? 0 : 1] != at)
            fail(item, "edge " + std::to_string(e) + " does not begin where the one before ends");
          if ((forwards ? edge.left : edge.right) != f) fail(item, "edge " + std::to_string(e) + " names another face");
          if (used[2 * number + forwards]++) fail(item, "edge " + std::to_string(e) + " stands twice");
          at = edge.vertex[forwards ? 1 : 0];
        }
      }
    }
    for (std::size_t e = 0; e < map_.edges.size(); ++e) {
      const MapEdge& edge = map_.edges[e];
      if (used[2 * e + 1] != (edge.left != none) || used[2 * e] != (edge.right != none)) {
        fail("edges[" + std::to_string(e) + "]", "stands in no loop of a face that it names");
      }
    }
  }
  std::uint32_t head(std::int32_t e) const {
    return e >= 0 ? map_.edges[static_cast<std::size_t>(e)].vertex[1]
                  : map_.edges[static_cast<std::size_t>(-(e + 1))].vertex[0];
  }

  const Json& json_;
  const std::string& name_;
  MapScene scene_;
  VisibilityMap map_;
};

}  // namespace

MapFile parse_map(std::string_view text, const std::string& name) {
  Json json;
  try {
    json = Json::parse(text);
  } catch (const Json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw InputError(name + ':' + std::to_string(line) + ": not JSON" + (text.empty() ? ": the file is empty" : ""));
  } catch (const Json::exception&) {
    throw InputError(name + ": a number is out of range");
  }
  return Reader(json, name).read();
}

MapFile read_map(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file)) throw InputError(file.string() + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw InputError(file.string() + ": cannot be read");
  return parse_map(text, file.string());
}

}  // namespace sightline
