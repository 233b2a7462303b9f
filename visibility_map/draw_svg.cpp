#include "visibility_map/draw.hpp"
#include "visibility_map/query.hpp"
#include "visibility_map/write_text.hpp"

namespace sightline {

namespace {

constexpr const char* kind_name[] = {"silhouette", "crease", "seam", "intersection", "window"};
constexpr EdgeKind thin_to_heavy[] = {EdgeKind::seam, EdgeKind::crease, EdgeKind::intersection, EdgeKind::silhouette,
                                      EdgeKind::window};

void append_colour(std::string& out, Colour c) {
  constexpr char hex[] = "0123456789abcdef";
  out += '#';
  for (const std::uint8_t v : {c.r, c.g, c.b}) {
    out += hex[v >> 4];
    out += hex[v & 15];
  }
}

void append_place(std::string& out, const glm::dvec2& place) {
  text::append_fixed(out, place.x, 3);
  out += ' ';
  text::append_fixed(out, place.y, 3);
}

void append_style(std::string& out, const Drawing& drawing) {
  out += "<style>\n.face{fill-rule:evenodd;stroke-width:";
  text::append_fixed(out, Drawing::seal, 3);
  out += ";stroke-linejoin:round}\n.edges path{fill:none;stroke-linecap:round}\n";
  for (const EdgeKind kind : thin_to_heavy) {
    const Stroke stroke = drawing.stroke(kind);
    out += '.';
    out += kind_name[static_cast<int>(kind)];
    out += "{stroke:";
    append_colour(out, stroke.colour);
    out += ";stroke-width:";
    text::append_fixed(out, stroke.width, 3);
    if (stroke.opacity < 1) {
      out += ";stroke-opacity:";
      text::append_fixed(out, stroke.opacity, 3);
    }
    out += "}\n";
  }
  out += "</style>\n";
}

void append_face(std::string& out, const VisibilityMap& map, const MapFace& face, const Drawing& drawing) {
  out += "<path class=\"face\" data-polygon=\"";
  if (face.polygon == none) {
    out += "none";
  } else {
    text::append(out, face.polygon);
  }
  if (drawing.options().fill == DrawOptions::Fill::empty) {
    out += "\" fill=\"none\" d=\"";
  } else {
    out += "\" fill=\"";
    append_colour(out, drawing.fill(face));
    out += "\" stroke=\"";
    append_colour(out, drawing.fill(face));
    out += "\" d=\"";
  }
  for (std::uint32_t k = 0; k < face.loop_count; ++k) {
    char command = 'M';
    for (const std::int32_t e : map.loop(face.first_loop + k)) {
      out += command;
      append_place(out, drawing.place(map.vertices[start_vertex(map, e)].st));
      command = 'L';
    }
    out += 'Z';
  }
  out += "\"/>\n";
}

void append_patch(std::string& out, const DrawnPatch& patch, const Drawing& drawing) {
  out += "<path class=\"face\" data-cameras=\"";
  text::append(out, patch.what);
  out += "\" fill=\"";
  append_colour(out, patch.colour);
  out += "\" stroke=\"";
  append_colour(out, patch.colour);
  out += "\" d=\"";
  for (std::size_t k = 0; k < patch.st.size(); ++k) {
    out += k == 0 ? 'M' : 'L';
    append_place(out, drawing.place(patch.st[k]));
  }
  out += "Z\"/>\n";
}

void append_edge(std::string& out, const VisibilityMap& map, const MapEdge& edge, const Drawing& drawing) {
  out += "<path class=\"";
  out += kind_name[static_cast<int>(edge.kind)];
  if (edge.owner != none) {
    out += "\" data-owner=\"";
    text::append(out, edge.owner);
  }
  out += "\" d=\"M";
  append_place(out, drawing.place(map.vertices[edge.vertex[0]].st));
  out += 'L';
  append_place(out, drawing.place(map.vertices[edge.vertex[1]].st));
  out += "\"/>\n";
}

std::string drawing_svg(const VisibilityMap& map, const Scene& scene, const DrawOptions& options,
                        std::span<const DrawnPatch> patches) {
  const Drawing drawing(map, scene, options);
  const std::string width = std::to_string(drawing.width()), height = std::to_string(drawing.height());
  std::string out;
  out.reserve(2048 + 96 * map.faces.size() + 20 * map.loop_edges.size() + 80 * map.edges.size());
  out += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " +
         width + ' ' + height + "\">\n<title>";
  text::append_xml(out, scene.soup().source);
  out += "</title>\n<desc>Visibility map: " + std::to_string(map.faces.size()) + " faces, " +
         std::to_string(map.edges.size()) + " edges, " + std::to_string(map.vertices.size()) + " vertices</desc>\n";
  append_style(out, drawing);
  out += "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"";
  append_colour(out, Drawing::paper);
  out += "\"/>\n<g class=\"faces\">\n";
  if (patches.empty()) {
    for (const MapFace& face : map.faces) append_face(out, map, face, drawing);
  } else {
    for (const DrawnPatch& patch : patches) append_patch(out, patch, drawing);
  }
  out += "</g>\n<g class=\"edges\">\n";
  for (const EdgeKind kind : thin_to_heavy) {
    if (!drawing.drawn(kind)) continue;
    for (const MapEdge& edge : map.edges) {
      if (edge.kind == kind) append_edge(out, map, edge, drawing);
    }
  }
  out += "</g>\n</svg>\n";
  return out;
}

}  // namespace

std::string map_svg(const VisibilityMap& map, const Scene& scene, int width) {
  return map_svg(map, scene, DrawOptions{.width = width});
}

std::string map_svg(const VisibilityMap& map, const Scene& scene, const DrawOptions& options) {
  return drawing_svg(map, scene, options, {});
}

std::string patches_svg(std::span<const DrawnPatch> patches, const VisibilityMap& map, const Scene& scene,
                        const DrawOptions& options) {
  return drawing_svg(map, scene, options, patches);
}

}  // namespace sightline
