#include "app/report.hpp"

#include "app/files.hpp"
#include "bsp/build.hpp"
#include "exact/tally.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace sightline::app {

namespace {

using Json = nlohmann::ordered_json;

/// Of this process or of the largest that it ran.
std::uint64_t peak_bytes() {
  rusage self{}, children{};
  getrusage(RUSAGE_SELF, &self);
  getrusage(RUSAGE_CHILDREN, &children);
  return static_cast<std::uint64_t>(std::max(self.ru_maxrss, children.ru_maxrss)) * 1024;  // Linux counts in KiB
}

Json scene_json(const Scene& scene) {
  const SceneReport& r = scene.report();
  return {{"source", scene.soup().source},
          {"polygons", scene.polygon_count()},
          {"vertices", scene.soup().vertices.size()},
          {"dropped", r.dropped},
          {"nonplanar", r.nonplanar},
          {"nonconvex", r.nonconvex},
          {"self_crossing", r.self_crossing},
          {"duplicates", r.duplicates},
          {"surfaces", scene.surfaces().size()},
          {"planes", scene.planes().size()},
          {"bits", scene.grid().bits()},
          {"snap", scene.options().snap.empty() ? Json() : Json(scene.options().snap)},
          {"largest_displacement", r.largest_displacement},
          {"one_sided", scene.options().one_sided}};
}

Json complex_json(const ComplexFigures& c) {
  return {{"seconds", c.seconds}, {"from_file", c.from_file}, {"cells", c.cells},  {"faces", c.faces},
          {"edges", c.edges},     {"vertices", c.vertices},   {"pairs", c.pairs},  {"bytes", c.bytes},
          {"lazy", c.lazy},       {"nodes", c.nodes},         {"pieces", c.pieces}};
}

Json clip_json(const ClipFigures& c) {
  return {{"pieces", c.pieces},
          {"seen", c.seen},
          {"cuts", c.cuts},
          {"buffer_proofs", c.buffer_proofs},
          {"buffer_seconds", c.buffer_seconds},
          {"clip_seconds", c.clip_seconds}};
}

Json photos_json(const PhotoFigures& p) {
  const auto pieces = [&](PieceTexture::Source source) { return p.stats.pieces[source]; };
  return {{"guard", p.guard},
          {"pages", p.pages},
          {"pieces",
           {{"best", pieces(PieceTexture::best)},
            {"next", pieces(PieceTexture::next)},
            {"uniform", pieces(PieceTexture::uniform)},
            {"polygon", pieces(PieceTexture::polygon)},
            {"unknown", pieces(PieceTexture::unknown)},
            {"hidden", pieces(PieceTexture::hidden)}}},
          {"texels", {{"direct", p.stats.direct}, {"borrowed", p.stats.borrowed}, {"continued", p.stats.continued}}},
          {"seconds", p.stats.seconds}};
}

Json bitfield_json(const BitfieldFigures& b) {
  return {{"samples", b.samples},
          {"exact", b.exact},
          {"pixels", b.pixels},
          {"bits", b.bits},
          {"transparent", b.transparent},
          {"faces", b.faces},
          {"mean_list", b.mean_list},
          {"seconds", b.seconds},
          {"plain_bytes", b.plain_bytes},
          {"hierarchical_bytes", b.hierarchical_bytes},
          {"compressed_bytes", b.compressed_bytes},
          {"list_bytes", b.list_bytes},
          {"file_bytes", b.file_bytes}};
}

Json bitfield_view_json(std::size_t index, const BitfieldViewFigures& v) {
  return {{"index", index},
          {"seconds", v.seconds},
          {"face", v.face == none ? Json() : Json(v.face)},
          {"samples", v.samples},
          {"polygons", v.polygons}};
}

Json field_json(const FieldFigures& f) {
  return {{"slabs", f.slabs},
          {"samples", f.samples},
          {"ids", f.ids},
          {"cells", f.cells},
          {"lists", f.lists},
          {"mipmaps", f.mipmaps},
          {"rays", f.rays},
          {"seconds", f.seconds},
          {"array_bytes", f.array_bytes},
          {"memory_bytes", f.memory_bytes},
          {"file_bytes", f.file_bytes},
          {"compression", static_cast<double>(f.array_bytes) / static_cast<double>(f.file_bytes)}};
}

Json field_view_json(std::size_t index, const FieldViewFigures& v) {
  return {{"index", index},         {"seconds", v.seconds},     {"cells", v.cells},
          {"polygons", v.polygons}, {"looked_up", v.looked_up}, {"covered", v.covered}};
}

Json camera_json(std::size_t index, const CameraFigures& c) {
  if (!c.error.empty()) return {{"index", index}, {"error", c.error}};
  return {{"index", index},   {"seconds", c.seconds}, {"beams", c.beams},       {"cells", c.cells},
          {"faces", c.faces}, {"edges", c.edges},     {"vertices", c.vertices}, {"left_out", c.left_out}};
}

Json decisions_json() {
  const Tally total = tally_total();
  Json exact = Json::object();
  for (std::size_t k = 0; k < Tally::widths.size(); ++k) {
    exact[Tally::widths[k] == 0 ? "longer" : std::to_string(Tally::widths[k])] = total.exact[k];
  }
  return {{"identity", total.identity}, {"filter", total.filter}, {"exact", exact}};
}

}  // namespace

ComplexFigures figures_of(const Complex& complex) {
  ComplexFigures f;
  f.cells = complex.cells.size();
  f.faces = complex.faces.size();
  f.edges = complex.edges.size();
  f.vertices = complex.vertices.size();
  f.pairs = complex.pairs.size();
  f.bytes = complex_bytes(complex);
  return f;
}

ComplexFigures figures_of(const BspTree& tree) {
  ComplexFigures f;
  const BspTree::Size size = tree.size();
  f.cells = size.nodes + 1;  // regions into which the nodes part space
  f.nodes = size.nodes;
  f.pieces = size.pieces;
  f.bytes = size.bytes;
  return f;
}

std::string report_json(const Report& report, const CommonOptions& options) {
  Json json = {{"version", SIGHTLINE_VERSION}, {"command", report.command}, {"threads", options.threads},
               {"engine", options.engine},     {"seconds", report.seconds}, {"exit_code", report.exit_code},
               {"peak_bytes", peak_bytes()}};
  if (report.scene) json["scene"] = scene_json(*report.scene);
  if (report.complex) json["complex"] = complex_json(*report.complex);
  if (report.clip) json["clip"] = clip_json(*report.clip);
  if (report.photos) json["photos"] = photos_json(*report.photos);
  if (report.bitfield) json["bitfield"] = bitfield_json(*report.bitfield);
  if (report.field) json["field"] = field_json(*report.field);
  json["cameras"] = Json::array();
  for (std::size_t k = 0; k < report.bitfield_views.size(); ++k) {
    json["cameras"].push_back(bitfield_view_json(k, report.bitfield_views[k]));
  }
  for (std::size_t k = 0; k < report.field_views.size(); ++k) {
    json["cameras"].push_back(field_view_json(k, report.field_views[k]));
  }
  for (std::size_t k = 0; k < report.cameras.size(); ++k) json["cameras"].push_back(camera_json(k, report.cameras[k]));
  json["decisions"] = decisions_json();
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void publish(const Report& report, const CommonOptions& options) {
  if (options.report.empty() && !options.json) return;
  const std::string text = report_json(report, options);
  if (!options.report.empty()) write_text(options.report, text);
  if (options.json) print_result(text);
}

}  // namespace sightline::app
