// Written by hand, not through a JSON library: the bytes are part of the contract, and maps are large.
#include "visibility_map/write.hpp"
#include "visibility_map/write_text.hpp"

#include <stdexcept>

namespace sightline {

namespace {

using text::append;
using text::append_or_null;

constexpr const char* side_name[] = {"left", "right", "bottom", "top"};
constexpr const char* kind_name[] = {"silhouette", "crease", "seam", "intersection", "window"};

void append_vector(std::string& out, const char* key, const glm::dvec3& v, const char* end) {
  out += '"';
  out += key;
  out += "\": [";
  append(out, v.x);
  out += ", ";
  append(out, v.y);
  out += ", ";
  append(out, v.z);
  out += ']';
  out += end;
}

void append_line(std::string& out, const MapLine& line) {
  if (line.kind == MapLine::window) {
    out += "[\"window\", \"";
    out += side_name[line.v[0]];
    out += "\"]";
  } else if (line.kind == MapLine::edge) {
    out += "[\"edge\", ";
    append(out, line.v[0]);
    out += ", ";
    append(out, line.v[1]);
    out += ']';
  } else {
    out += "[\"planes\", [";
    for (int k = 0; k < 6; ++k) {
      append(out, line.v[k]);
      out += k == 2 ? "], [" : k == 5 ? "]]" : ", ";
    }
  }
}

void append_vertex(std::string& out, const MapVertex& vertex) {
  out += "{\"st\": [";
  append(out, vertex.st.x);
  out += ", ";
  append(out, vertex.st.y);
  out += "], \"lines\": [";
  append(out, vertex.line[0]);
  out += ", ";
  append(out, vertex.line[1]);
  out += "], \"scene_vertex\": ";
  append_or_null(out, vertex.scene_vertex);
  out += '}';
}

void append_edge(std::string& out, const MapEdge& edge) {
  out += "{\"vertices\": [";
  append(out, edge.vertex[0]);
  out += ", ";
  append(out, edge.vertex[1]);
  out += "], \"line\": ";
  append(out, edge.line);
  out += ", \"left\": ";
  append_or_null(out, edge.left);
  out += ", \"right\": ";
  append_or_null(out, edge.right);
  out += ", \"kind\": \"";
  out += kind_name[static_cast<int>(edge.kind)];
  out += "\", \"owner\": ";
  append_or_null(out, edge.owner);
  out += '}';
}

template <class Range>
void append_list(std::string& out, const Range& values) {
  out += '[';
  bool first = true;
  for (const auto value : values) {
    if (!first) out += ", ";
    first = false;
    append(out, value);
  }
  out += ']';
}

void append_face(std::string& out, const VisibilityMap& map, const MapFace& face) {
  out += "{\"polygon\": ";
  append_or_null(out, face.polygon);
  out += ", \"coincident\": ";
  append_list(out, map.coincident_of(face));
  out += ", \"loops\": [";
  for (std::uint32_t k = 0; k < face.loop_count; ++k) {
    if (k > 0) out += ", ";
    append_list(out, map.loop(face.first_loop + k));
  }
  out += "], \"area\": ";
  append(out, face.area);
  out += ", \"solid_angle\": ";
  append(out, face.solid_angle);
  out += '}';
}

/// One element a line.
template <class Elements, class Append>
void append_array(std::string& out, const char* key, const Elements& elements, Append append_element) {
  out += '"';
  out += key;
  out += "\": [";
  bool first = true;
  for (const auto& element : elements) {
    out += first ? "\n" : ",\n";
    first = false;
    append_element(element);
  }
  out += first ? "]" : "\n]";
}

}  // namespace

MapScene map_scene(const Scene& scene) {
  return {scene.soup().source, scene.soup().vertices.size(), scene.polygon_count(), scene.options().snap};
}

std::string map_json(const VisibilityMap& map, const Scene& scene) { return map_json(map, map_scene(scene)); }

std::string map_json(const VisibilityMap& map, const MapScene& scene) {
  if (map.sphere) throw std::invalid_argument("a map of the whole sphere has no window, so no map file");
  std::string out;
  out.reserve(512 + 48 * map.lines.size() + 96 * map.vertices.size() + 112 * map.edges.size() + 112 * map.faces.size() +
              8 * map.loop_edges.size());
  out += "{\"format\": \"sightline-map\", \"version\": 1,\n\"scene\": {\"source\": ";
  text::append_json_string(out, scene.source);
  out += ", \"vertices\": ";
  append(out, scene.vertices);
  out += ", \"polygons\": ";
  append(out, scene.polygons);
  out += ", \"snap\": ";
  if (scene.snap.empty()) {
    out += "null";
  } else {
    text::append_json_string(out, scene.snap);
  }
  out += "},\n\"camera\": {";
  append_vector(out, "eye", map.camera.eye, ", ");
  append_vector(out, "forward", map.camera.forward, ", ");
  append_vector(out, "right", map.camera.right, ", ");
  append_vector(out, "up", map.camera.up, "},\n");
  append_array(out, "lines", map.lines, [&](const MapLine& line) { append_line(out, line); });
  out += ",\n";
  append_array(out, "vertices", map.vertices, [&](const MapVertex& vertex) { append_vertex(out, vertex); });
  out += ",\n";
  append_array(out, "edges", map.edges, [&](const MapEdge& edge) { append_edge(out, edge); });
  out += ",\n";
  append_array(out, "faces", map.faces, [&](const MapFace& face) { append_face(out, map, face); });
  out += "}\n";
  return out;
}

}  // namespace sightline
