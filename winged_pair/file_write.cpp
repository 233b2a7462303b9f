#include <charconv>
#include <stdexcept>

#include "scene/read.hpp"
#include "winged_pair/file.hpp"

namespace sightline {
namespace {

/// The whole file as text, built record by record.
class Text {
 public:
  explicit Text(std::size_t reserve) { text_.reserve(reserve); }
  Text& word(std::string_view w) {
    if (!line_start_) text_ += ' ';
    text_ += w;
    line_start_ = false;
    return *this;
  }
  /// An integer or a double, as the shortest decimal that reads back the same.
  template <class Number>
  Text& number(Number value) {
    char digits[32];
    const char* end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return word({digits, static_cast<std::size_t>(end - digits)});
  }
  Text& index(std::uint32_t value) { return value == none ? word("-") : number(value); }
  /// In quotes, with everything escaped that would end the string or the line.
  Text& quoted(std::string_view s) {
    constexpr const char* hex = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : s) {
      const auto u = static_cast<unsigned char>(c);
      if (u < 0x20 || u == 0x7f || c == '"' || c == '\\') {
        out += {'\\', 'x', hex[u >> 4], hex[u & 15]};
      } else {
        out += c;
      }
    }
    return word(out + '"');
  }
  void end() {
    text_ += '\n';
    line_start_ = true;
  }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
  bool line_start_ = true;
};

constexpr const char* axis_names[3] = {"x", "y", "z"};

void write_counts(Text& out, const Scene& scene, const Complex& c) {
  const auto count = [&out](const char* name, std::size_t n) { out.word(name).number(n).end(); };
  count("scene_vertices", scene.soup().vertices.size());
  count("polygons", scene.polygon_count());
  count("objects", scene.soup().objects.size());
  count("planes", c.planes.size());
  count("labels", c.label_first.size() - 2);
  count("vertices", c.vertices.size());
  count("edges", c.edges.size());
  count("faces", c.faces.size());
  count("cells", c.cells.size());
  count("pairs", c.pairs.size());
}

void write_scene(Text& out, const Scene& scene) {
  const PolygonSoup& soup = scene.soup();
  out.word("source").quoted(soup.source).end();
  out.word("snap").word(scene.options().snap.empty() ? "none" : scene.options().snap).end();
  out.word("opaque_from").word(scene.options().one_sided ? "front" : "both").end();
  for (const std::string& name : soup.objects) out.word("object").quoted(name).end();
  for (const glm::dvec3& v : soup.vertices) out.word("v").number(v.x).number(v.y).number(v.z).end();
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    out.word("f");
    for (const PointId v : scene.corners(p)) out.number(v);
    if (!soup.object_of.empty()) out.word("/").index(soup.object_of[p]);
    out.end();
  }
}

/// The lowest polygon that lies in each plane of the scene, or none.
std::vector<PolygonId> polygons_of_planes(const Scene& scene) {
  std::vector<PolygonId> polygon(scene.planes().size(), none);
  for (const Surface& s : scene.surfaces()) polygon[s.plane] = std::min(polygon[s.plane], s.polygon);
  return polygon;
}

void write_planes(Text& out, const Scene& scene, const PlaneTable& planes) {
  const std::vector<PolygonId> polygon = polygons_of_planes(scene);
  const Grid& grid = scene.grid();
  for (PlaneId p = 0; p < planes.size(); ++p) {
    const PlaneSource& source = planes.source(p);
    out.word("plane");
    switch (source.kind) {
      case PlaneSource::points:
        if (p < polygon.size() && polygon[p] != none) {
          out.word("polygon").number(polygon[p]);
        } else {
          out.word("points");
        }
        out.number(source.a).number(source.b).number(source.c);
        break;
      case PlaneSource::wall:
        out.word("edge").number(source.a).number(source.b).word(axis_names[source.c]);
        break;
      case PlaneSource::axis: {
        const int axis = static_cast<int>(source.a);
        const Integer value = planes.integer(p, 3);
        glm::dvec3 world(0.0);
        world[axis] = grid.world(value, axis);
        const GridPoint back = grid.point(world);
        out.word(axis_names[axis]);
        // A value that no double stands for is written in steps of the grid.
        if (back.shift == 0 && back.c[source.a] == value) {
          out.number(world[axis]);
        } else {
          out.word("grid").word(value.get_str());
        }
        break;
      }
    }
    out.end();
  }
}

void write_records(Text& out, const Complex& c) {
  for (std::size_t k = 1; k + 1 < c.label_first.size(); ++k) {
    out.word("label");
    for (std::uint32_t i = c.label_first[k]; i < c.label_first[k + 1]; ++i) out.number(c.label_surfaces[i]);
    out.end();
  }
  for (const Vertex& v : c.vertices) {
    out.word("vertex").number(v.place.plane[0]).number(v.place.plane[1]).number(v.place.plane[2]).index(v.edge).end();
  }
  for (const Edge& e : c.edges) {
    out.word("edge").number(e.vertex[0]).number(e.vertex[1]).number(e.pair).number(e.plane[0]).number(e.plane[1]);
    out.index(e.a).index(e.b).end();
  }
  for (const Face& f : c.faces) {
    out.word("face").index(f.cell[0]).index(f.cell[1]).number(f.pair).number(f.plane).number(f.label).end();
  }
  for (const Cell& cell : c.cells) out.word("cell").number(cell.face).end();
  for (const Pair& p : c.pairs) {
    out.word("pair").number(p.face).number(p.edge).number(p.clock[0]).number(p.clock[1]);
    out.number(p.spin[0]).number(p.spin[1]).number(p.direction).end();
  }
  out.word("box");
  for (const auto& side : c.box_plane) out.number(side[0]).number(side[1]);
  out.end();
}

}  // namespace

void write_wp(const std::filesystem::path& file, const Scene& scene, const Complex& complex) {
  Text out(64 * (scene.soup().vertices.size() + complex.pairs.size()) + 24 * std::size_t{complex.planes.size()});
  out.word("sightline-winged-pair").number(1).end();
  write_counts(out, scene, complex);
  write_scene(out, scene);
  write_planes(out, scene, complex.planes);
  write_records(out, complex);
  write_file(file, out.str());
}

}  // namespace sightline
