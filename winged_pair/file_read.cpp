#include <algorithm>
#include <stdexcept>

#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"
#include "winged_pair/check_stages.hpp"
#include "winged_pair/file.hpp"

namespace sightline {
namespace {

/// The file record by record, in the order in which write_wp writes them. Every index is checked against the counts
/// that stand in front, and these against the size of the file, before anything is stored.
class Reader {
 public:
  explicit Reader(const std::string& file)
      : file_(file), text_(load_file(file)), in_(file, text_, {.comments = false, .continuations = false}) {}

  SceneAndComplex read() {
    read_header();
    read_counts();
    Scene scene = read_scene();
    Complex c;
    read_planes(scene, c.planes);
    read_labels(scene, c);
    read_vertices(c);
    read_edges(scene, c);
    read_faces_and_cells(c);
    read_pairs(c);
    read_box(c);
    if (in_.find_token()) in_.fail({"end"}, "more than the counts say");
    check_structure(scene, c);
    return {std::move(scene), std::move(c)};
  }

 private:
  void read_header() {
    const Item item{"header"};
    if (in_.token() != "sightline-winged-pair") in_.fail(item, "not a winged-pair file");
    if (in_.integer(item, "version") != 1) in_.fail(item, "not version 1");
    end_line(item);
  }

  void read_counts() {
    for (const auto& [name, count] :
         std::initializer_list<std::pair<const char*, std::uint32_t*>>{{"scene_vertices", &points_},
                                                                       {"polygons", &polygons_},
                                                                       {"objects", &objects_},
                                                                       {"planes", &planes_},
                                                                       {"labels", &labels_},
                                                                       {"vertices", &vertices_},
                                                                       {"edges", &edges_},
                                                                       {"faces", &faces_},
                                                                       {"cells", &cells_},
                                                                       {"pairs", &pairs_}}) {
      const Item item{name};
      word(item, name);
      // No record is shorter than seven bytes.
      *count = number(item, "count", static_cast<std::uint32_t>(std::min<std::size_t>(text_.size() / 7, none - 1)) + 1);
      end_line(item);
    }
  }

  Scene read_scene() {
    PolygonSoup soup;
    SceneOptions options;
    word({"source"}, "source");
    soup.source = quoted_string({"source"});
    word({"snap"}, "snap");
    const std::size_t snap_line = in_.line();
    if (const std::string_view unit = in_.token(); unit != "none") options.snap = unit;
    end_line({"snap"});
    word({"opaque_from"}, "opaque_from");
    const std::string_view sides = in_.token();
    if (sides != "front" && sides != "both") in_.fail({"opaque_from"}, "neither front nor both");
    options.one_sided = sides == "front";
    end_line({"opaque_from"});
    for (std::size_t k = 0; k < objects_; ++k) {
      word({"object", k}, "object");
      soup.objects.push_back(quoted_string({"object", k}));
    }
    soup.vertices.reserve(points_);
    for (std::size_t k = 0; k < points_; ++k) {
      const Item item{"vertex of the scene", k};
      word(item, "v");
      glm::dvec3 x;
      for (int i = 0; i < 3; ++i) x[i] = in_.number(item, "coordinate");
      soup.vertices.push_back(x);
      end_line(item);
    }
    soup.first.reserve(polygons_ + std::size_t{1});
    for (std::size_t k = 0; k < polygons_; ++k) read_polygon({"polygon", k}, soup);
    try {
      return make_scene(std::move(soup), options);
    } catch (const InputError& error) {
      throw InputError(file_ + ": " + error.what());
    } catch (const std::invalid_argument& error) {
      fail_input(file_, snap_line, {"snap"}, error.what());
    }
  }

  void read_polygon(const Item& item, PolygonSoup& soup) {
    word(item, "f");
    bool named = false;
    while (!in_.at_line_end()) {
      if (in_.take('/')) {
        named = true;
        if (item.index == 0) soup.object_of.reserve(polygons_);
        soup.object_of.push_back(optional_number(item, "object", objects_));
        break;
      }
      soup.corners.push_back(number(item, "corner", points_));
    }
    if (named != !soup.object_of.empty()) in_.fail(item, "object missing, though other polygons name theirs");
    if (named && soup.object_of.size() != item.index + 1) in_.fail(item, "object named, though the first names none");
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    end_line(item);
  }

  /// Makes every plane again; it must get the id that it had.
  void read_planes(const Scene& scene, PlaneTable& planes) {
    planes = scene.planes();
    for (std::size_t k = 0; k < planes_; ++k) {
      const Item item{"plane", k};
      word(item, "plane");
      const PlaneTable::Interned plane = read_plane(scene, planes, item);
      if (plane.id == none) in_.fail(item, "its points do not define a plane");
      if (plane.id != k) in_.fail(item, "is the same as plane " + std::to_string(plane.id));
      end_line(item);
    }
    if (planes.size() != planes_) in_.fail({"planes"}, "fewer than the scene has: " + std::to_string(planes.size()));
  }

  PlaneTable::Interned read_plane(const Scene& scene, PlaneTable& planes, const Item& item) {
    const std::string_view kind = in_.token();
    if (kind == "polygon" || kind == "points") {
      if (kind == "polygon") {
        const PolygonId p = number(item, "polygon", polygons_);
        const auto in_plane = [&](const Surface& s) { return s.plane == item.index; };
        if (std::ranges::none_of(scene.surfaces(p), in_plane)) in_.fail(item, "not the plane of its polygon");
      }
      const PointId a = number(item, "point", points_), b = number(item, "point", points_),
                    c = number(item, "point", points_);
      return planes.add_points(a, b, c);
    }
    if (kind == "edge") {
      const PointId a = number(item, "point", points_), b = number(item, "point", points_);
      const int k = axis(in_.token());
      if (k < 0) in_.fail(item, "axis missing");
      return planes.add_wall(a, b, k);
    }
    const int k = axis(kind);
    if (k < 0) in_.fail(item, quoted(kind) + " is none of polygon, points, edge, x, y, z");
    return planes.add_axis(k, axis_value(scene.grid(), k, item));
  }

  Integer axis_value(const Grid& grid, int axis, const Item& item) {
    if (in_.at_line_end()) in_.fail(item, "value missing");
    if (in_.next_is('g')) {
      constexpr std::size_t longest = 2000;  // digits; the doubles' whole range has 640
      Integer value;
      const bool keyword = in_.token() == "grid";
      const std::string digits(in_.token());
      if (!keyword || digits.empty() || digits.size() > longest || value.set_str(digits, 10) != 0) {
        in_.fail(item, "no integer after 'grid'");
      }
      return value;
    }
    glm::dvec3 world(0.0);
    world[axis] = in_.number(item, "value");
    const GridPoint point = grid.point(world);
    const Integer& value = point.c[static_cast<std::size_t>(axis)];
    // Only this axis counts: zero may be no point of the grid on the other two.
    const Integer step = Integer(1) << static_cast<unsigned>(point.shift);
    if (value % step != 0) in_.fail(item, "value not on the grid of the scene");
    return value / step;
  }

  void read_labels(const Scene& scene, Complex& c) {
    const auto surfaces = static_cast<std::uint32_t>(scene.surfaces().size());
    for (std::size_t k = 1; k <= labels_; ++k) {
      const Item item{"label", k};
      word(item, "label");
      while (!in_.at_line_end()) c.label_surfaces.push_back(number(item, "surface", surfaces));
      c.label_first.push_back(static_cast<std::uint32_t>(c.label_surfaces.size()));
      end_line(item);
    }
  }

  void read_vertices(Complex& c) {
    c.vertices.reserve(vertices_);
    for (std::size_t k = 0; k < vertices_; ++k) {
      const Item item{"vertex", k};
      word(item, "vertex");
      PlaneId p[3];
      for (PlaneId& plane : p) plane = number(item, "plane", planes_);
      Vertex vertex{{}, number(item, "edge", edges_)};
      try {
        vertex.place = make_vertex(c.planes, p[0], p[1], p[2]);
      } catch (const std::invalid_argument&) {
        in_.fail(item, "its planes do not meet in one point");
      }
      c.vertices.push_back(vertex);
      end_line(item);
    }
  }

  void read_edges(const Scene& scene, Complex& c) {
    c.edges.reserve(edges_);
    for (std::size_t k = 0; k < edges_; ++k) {
      const Item item{"edge", k};
      word(item, "edge");
      Edge edge;
      for (VertexId& v : edge.vertex) v = number(item, "vertex", vertices_);
      edge.pair = number(item, "pair", pairs_);
      for (PlaneId& p : edge.plane) p = number(item, "plane", planes_);
      edge.a = optional_number(item, "point", points_);
      edge.b = optional_number(item, "point", points_);
      if (edge.a != none && edge.b != none && scene.points().equal(edge.a, edge.b))
        in_.fail(item, "its points coincide");
      c.edges.push_back(edge);
      end_line(item);
    }
  }

  void read_faces_and_cells(Complex& c) {
    c.faces.reserve(faces_);
    for (std::size_t k = 0; k < faces_; ++k) {
      const Item item{"face", k};
      word(item, "face");
      Face face;
      for (CellId& cell : face.cell) cell = optional_number(item, "cell", cells_);
      face.pair = number(item, "pair", pairs_);
      face.plane = number(item, "plane", planes_);
      face.label = number(item, "label", labels_ + 1);
      c.faces.push_back(face);
      end_line(item);
    }
    c.cells.reserve(cells_);
    for (std::size_t k = 0; k < cells_; ++k) {
      word({"cell", k}, "cell");
      c.cells.push_back({number({"cell", k}, "face", faces_)});
      end_line({"cell", k});
    }
  }

  void read_pairs(Complex& c) {
    c.pairs.reserve(pairs_);
    for (std::size_t k = 0; k < pairs_; ++k) {
      const Item item{"pair", k};
      word(item, "pair");
      Pair pair;
      pair.face = number(item, "face", faces_);
      pair.edge = number(item, "edge", edges_);
      for (PairId& p : pair.clock) p = number(item, "clock", pairs_);
      for (PairId& p : pair.spin) p = number(item, "spin", pairs_);
      pair.direction = number(item, "direction", 2);
      c.pairs.push_back(pair);
      end_line(item);
    }
  }

  void read_box(Complex& c) {
    const Item item{"box"};
    word(item, "box");
    for (int k = 0; k < 3; ++k) {
      for (int end = 0; end < 2; ++end) {
        const PlaneId p = number(item, "plane", planes_);
        if (c.planes.axis(p) != k) in_.fail(item, "plane " + std::to_string(p) + " is not along the box");
        c.box_plane[k][end] = p;
        c.box[end][k] = c.planes.integer(p, 3);
      }
      if (c.box[0][k] >= c.box[1][k]) in_.fail(item, "is empty");
    }
    end_line(item);
  }

  void check_structure(const Scene& scene, const Complex& c) {
    check_detail::Faults faults(1);
    check_detail::check_records(c, scene, faults);
    if (faults.empty()) check_detail::check_loops(c, faults);
    if (!faults.empty()) throw InputError(file_ + ": " + faults.lines().front());
  }

  void word(const Item& item, std::string_view expected) {
    const std::string_view token = in_.token();
    if (token == expected) return;
    if (token.empty()) in_.fail(item, in_.at_end() ? "the file ends before it" : "missing");
    in_.fail(item, quoted(token) + " where '" + std::string(expected) + "' should stand");
  }

  std::uint32_t number(const Item& item, const char* what, std::uint32_t size) {
    const std::int64_t value = in_.integer(item, what);
    if (value < 0 || value >= size) in_.fail(item, std::string(what) + " " + std::to_string(value) + " out of range");
    return static_cast<std::uint32_t>(value);
  }

  std::uint32_t optional_number(const Item& item, const char* what, std::uint32_t size) {
    if (in_.at_line_end() || !in_.next_is('-')) return number(item, what, size);
    if (in_.token() != "-") in_.fail(item, std::string(what) + " out of range");
    return none;
  }

  std::string quoted_string(const Item& item) {
    const std::string_view raw = in_.rest_of_line();
    if (raw.size() < 2 || raw.front() != '"' || raw.back() != '"') in_.fail(item, "not a string in quotes");
    std::string s;
    const std::string_view inner = raw.substr(1, raw.size() - 2);
    for (std::size_t k = 0; k < inner.size(); ++k) {
      if (inner[k] != '\\') {
        s += inner[k];
        continue;
      }
      const int high = k + 3 < inner.size() && inner[k + 1] == 'x' ? hex(inner[k + 2]) : -1;
      const int low = high < 0 ? -1 : hex(inner[k + 3]);
      if (low < 0) in_.fail(item, "bad escape in a string");
      s += static_cast<char>(16 * high + low);
      k += 3;
    }
    end_line(item);
    return s;
  }

  static int hex(char c) { return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1; }
  static int axis(std::string_view name) { return name == "x" ? 0 : name == "y" ? 1 : name == "z" ? 2 : -1; }

  void end_line(const Item& item) {
    if (!in_.at_line_end()) in_.fail(item, quoted(in_.token()) + " at the end of the line");
    in_.next_line();
  }

  std::string file_;
  std::string text_;
  TextScanner in_;
  std::uint32_t points_ = 0, polygons_ = 0, objects_ = 0, planes_ = 0, labels_ = 0;
  std::uint32_t vertices_ = 0, edges_ = 0, faces_ = 0, cells_ = 0, pairs_ = 0;
};

}  // namespace

SceneAndComplex read_wp(const std::filesystem::path& file) { return Reader(file.string()).read(); }

}  // namespace sightline
