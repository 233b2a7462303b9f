// Every kind of damage to a right map is refused, by the check whose matter it is.
#include "map_edit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace sightline::verify {
namespace {

struct Damage {
  const char* name;
  const char* map;
  const char* check;  // that must find it
  std::function<void(Json&)> inflict;
};

std::ostream& operator<<(std::ostream& out, const Damage& damage) { return out << damage.name; }

/// An edge of the map between faces that see these polygons (-1: nothing).
std::size_t edge_between(const Json& map, int p, int q) {
  const auto polygon = [&](const Json& face) {
    const Json& seen = map["faces"][face.get<std::size_t>()]["polygon"];
    return seen.is_null() ? -1 : seen.get<int>();
  };
  for (std::size_t i = 0; i < map["edges"].size(); ++i) {
    const Json& e = map["edges"][i];
    if (e["left"].is_null() || e["right"].is_null()) continue;
    const int l = polygon(e["left"]), r = polygon(e["right"]);
    if ((l == p && r == q) || (l == q && r == p)) return i;
  }
  throw std::logic_error("no such edge");
}

Json& first_edge(Json& map, const char* kind) { return map["edges"][edges_of_kind(map, kind).at(0)]; }

/// One face takes the place of another as well.
void merge_faces(Json& map, std::size_t stays, std::size_t goes) {
  std::vector<std::size_t> between;
  for (std::size_t i = 0; i < map["edges"].size(); ++i) {
    Json& e = map["edges"][i];
    for (const char* side : {"left", "right"}) {
      if (e[side] == goes) e[side] = stays;
    }
    if (e["left"] == e["right"]) between.push_back(i);
  }
  for (const char* size : {"area", "solid_angle"}) {
    map["faces"][stays][size] = map["faces"][stays][size].get<double>() + map["faces"][goes][size].get<double>();
  }
  remove_edges(map, between);
  remove_face(map, goes);
  retrace(map);
}

/// The map "two" with its face 0 cut in two by a line from vertex 4 to the left.
void cut_face(Json& map) {
  const std::size_t vertex = split_edge(map, 3, 0.25, 0.5, 8);
  const std::size_t above = map["edges"].size() - 1, face = map["faces"].size();
  map["edges"].push_back(
      {{"vertices", {vertex, 4}}, {"line", 8}, {"left", face}, {"right", 0}, {"kind", "seam"}, {"owner", nullptr}});
  map["edges"][above]["right"] = face;
  map["edges"][5]["right"] = face;
  map["edges"][6]["left"] = face;
  map["faces"].push_back(map["faces"][0]);
  map["faces"][0]["area"] = 0.125;
  map["faces"][face]["area"] = 0.0625;
  retrace(map);
}

void reverse_loop(Json& loop) {
  std::reverse(loop.begin(), loop.end());
  for (Json& entry : loop) entry = -entry.get<int>() - 1;
}

const std::vector<Damage>& all_damage() {
  static const std::vector<Damage> list{
      // The file.
      {"FormatUnknown", "two", "schema", [](Json& m) { m["format"] = "sightline"; }},
      {"VersionUnknown", "two", "schema", [](Json& m) { m["version"] = 2; }},
      {"KeyMissing", "two", "schema", [](Json& m) { m["faces"][0].erase("coincident"); }},
      {"SnapMissing", "two", "schema", [](Json& m) { m["scene"].erase("snap"); }},
      {"EdgeOutOfRange", "two", "schema", [](Json& m) { m["faces"][0]["loops"][0][0] = 99; }},
      {"VertexOutOfRange", "two", "schema", [](Json& m) { m["edges"][0]["vertices"][0] = -1; }},
      {"PolygonOutOfRange", "two", "schema", [](Json& m) { m["faces"][0]["polygon"] = 2; }},
      {"NumberNotFinite", "two", "schema", [](Json& m) { m["faces"][0]["area"] = "NaN"; }},
      {"KindUnknown", "two", "schema", [](Json& m) { m["edges"][0]["kind"] = "border"; }},
      {"CoincidentUnsorted", "coplanar", "schema",
       [](Json& m) {
         m["faces"][1]["coincident"] = {3, 1};
       }},
      {"VertexCountWrong", "two", "scene", [](Json& m) { m["scene"]["vertices"] = 8; }},
      {"PolygonCountWrong", "two", "scene", [](Json& m) { m["scene"]["polygons"] = 3; }},
      {"CameraFlat", "two", "scene", [](Json& m) { m["camera"]["up"] = m["camera"]["right"]; }},
      {"CameraMoved", "two", "st",
       [](Json& m) {
         m["camera"]["eye"] = {0, 0x1p-40, 0};
       }},
      {"SnapChanged", "snapped", "st", [](Json& m) { m["scene"]["snap"] = "0.0001"; }},
      // Lines and vertices.
      {"LineOfOneVertex", "two", "lines",
       [](Json& m) {
         m["lines"][4] = {"edge", 1, 1};
       }},
      {"LineOfParallelPlanes", "two", "lines",
       [](Json& m) {
         m["lines"][4] = {"planes", {0, 1, 2}, {1, 2, 3}};
       }},
      {"PlaneOfALine", "two", "lines",
       [](Json& m) {
         m["lines"][4] = {"planes", {0, 1, 1}, {4, 5, 6}};
       }},
      {"LineOfASceneEdgeElsewhere", "islands", "lines", [](Json& m) { m["edges"][13]["line"] = 8; }},
      {"MovedSt", "two", "st", [](Json& m) { m["vertices"][5]["st"][1] = std::nextafter(0.75, 1); }},
      {"SwappedSt", "two", "st",
       [](Json& m) {
         m["vertices"][3]["st"] = {0.75, 0.25};
       }},
      {"VertexOnParallelLines", "two", "vertices",
       [](Json& m) {
         m["vertices"][2]["lines"] = {5, 7};
       }},
      {"VertexOutsideWindow", "islands", "vertices",
       [](Json& m) {
         m["vertices"][2]["lines"] = {6, m["lines"].size()};
         m["lines"].push_back({"edge", 7, 10});
       }},
      {"DuplicateVertex", "two", "vertices", [](Json& m) { m["vertices"].push_back(m["vertices"][4]); }},
      {"UnusedVertex", "two", "edges",
       [](Json& m) {
         m["vertices"].push_back({{"st", {0.25, 0.5}}, {"lines", {7, 8}}, {"scene_vertex", nullptr}});
       }},
      {"VertexLineRenamed", "two", "st",
       [](Json& m) {
         m["vertices"][2]["lines"] = {4, 9};
       }},
      {"VertexLinesOfAnother", "two", "edges",
       [](Json& m) {
         m["vertices"][8]["lines"] = {8, 7};
       }},
      // Edges.
      {"LineRenamed", "two", "edges", [](Json& m) { m["edges"][4]["line"] = 6; }},
      {"EdgeOfNoLength", "two", "edges",
       [](Json& m) {
         m["edges"][4]["vertices"] = {2, 2};
       }},
      {"EdgeToAnotherVertex", "two", "edges",
       [](Json& m) {
         m["edges"][4]["vertices"] = {2, 8};
       }},
      {"EdgeTwice", "two", "crossings", [](Json& m) { m["edges"].push_back(m["edges"][4]); }},
      {"EdgeOverlaps", "two", "crossings",
       [](Json& m) {
         m["edges"].push_back(m["edges"][6]);
         m["edges"].back()["vertices"] = {4, 6};
       }},
      {"EdgeCrosses", "two", "crossings",
       [](Json& m) {
         const std::size_t v = split_edge(m, 3, 0.25, 0.5, 8);  // and from there along line 8 to the window's border
         m["edges"].push_back(m["edges"][7]);
         m["edges"].back()["vertices"] = {v, 10};
       }},
      {"EdgeCrossesAnother", "two", "crossings",
       [](Json& m) {  // from the window's border up to vertex 4
         const std::size_t v = split_edge(m, 1, 0.5, 0, 9);
         m["edges"].push_back(m["edges"][6]);
         m["edges"].back()["vertices"] = {v, 4};
       }},
      {"EdgeSplitAtAStraightVertex", "two", "maximality",
       [](Json& m) {
         split_edge(m, 1, 0.25, 0, 7);
         retrace(m);
       }},
      {"SilhouetteSplitAtAStraightVertex", "two", "maximality",
       [](Json& m) {
         split_edge(m, 3, 0.25, 0.5, 8);
         retrace(m);
       }},
      // Sides, loops, the border.
      {"SidesSwapped", "two", "loops", [](Json& m) { std::swap(m["edges"][4]["left"], m["edges"][4]["right"]); }},
      {"EdgeTurned", "two", "loops",
       [](Json& m) {
         m["edges"][4]["vertices"] = {7, 2};
       }},
      {"LoopReversed", "two", "loops", [](Json& m) { reverse_loop(m["faces"][0]["loops"][0]); }},
      {"FaceInsideOut", "two", "loops",
       [](Json& m) {
         reverse_loop(m["faces"][0]["loops"][0]);
         for (Json& e : m["edges"]) {
           if (e["left"] == 0 || e["right"] == 0) std::swap(e["left"], e["right"]);
         }
       }},
      {"LoopEntryMissing", "two", "loops", [](Json& m) { m["faces"][2]["loops"][0].erase(3); }},
      {"LoopEntryTurned", "two", "loops", [](Json& m) { m["faces"][2]["loops"][0][3] = 11; }},
      {"LoopsOfTwoFacesExchanged", "two", "loops",
       [](Json& m) { std::swap(m["faces"][0]["loops"], m["faces"][1]["loops"]); }},
      {"LoopEmpty", "two", "loops", [](Json& m) { m["faces"][0]["loops"].push_back(Json::array()); }},
      {"NoLoop", "two", "loops", [](Json& m) { m["faces"][0]["loops"] = Json::array(); }},
      {"HoleDropped", "islands", "loops", [](Json& m) { m["faces"][1]["loops"].erase(1); }},
      {"HoleFirst", "islands", "loops",
       [](Json& m) { std::swap(m["faces"][1]["loops"][0], m["faces"][1]["loops"][1]); }},
      {"HoleReversed", "islands", "loops", [](Json& m) { reverse_loop(m["faces"][1]["loops"][1]); }},
      {"HoleOfAnotherFace", "islands", "holes",
       [](Json& m) {  // the innermost triangle's hole goes from face 1 to face 3
         for (const int e : {9, 10, 11}) {
           for (const char* side : {"left", "right"}) {
             if (m["edges"][e][side] == 1) m["edges"][e][side] = 3;
           }
         }
         m["faces"][3]["loops"].push_back(m["faces"][1]["loops"][1]);
         m["faces"][1]["loops"].erase(1);
       }},
      {"TwoRegionsInOneFace", "keyhole", "loops",
       [](Json& m) {  // both faces that see nothing under one name
         std::vector<std::size_t> empty;
         for (std::size_t f = 0; f < m["faces"].size(); ++f) {
           if (m["faces"][f]["polygon"].is_null()) empty.push_back(f);
         }
         for (Json& e : m["edges"]) {
           for (const char* side : {"left", "right"}) {
             if (e[side] == empty[1]) e[side] = empty[0];
           }
         }
         for (const Json& loop : Json(m["faces"][empty[1]]["loops"])) m["faces"][empty[0]]["loops"].push_back(loop);
         m["faces"][empty[1]]["loops"] = Json::array();
         remove_face(m, empty[1]);
       }},
      {"NullInside", "two", "border", [](Json& m) { m["edges"][4]["right"] = nullptr; }},
      {"FaceOutside", "two", "border", [](Json& m) { m["edges"][0]["left"] = 2; }},
      {"BorderUncovered", "two", "border",
       [](Json& m) {
         m["edges"][1]["vertices"] = {9, 0};
       }},
      {"BorderEdgeMissing", "islands", "edges",
       [](Json& m) {
         remove_edges(m, {1});
         retrace(m);
       }},
      // What is seen.
      {"WrongPolygon", "two", "cover", [](Json& m) { std::swap(m["faces"][0]["polygon"], m["faces"][1]["polygon"]); }},
      {"WrongPolygonNearer", "islands", "depth", [](Json& m) { m["faces"][0]["polygon"] = 1; }},
      {"PolygonWhereNothingIs", "two", "cover", [](Json& m) { m["faces"][2]["polygon"] = 0; }},
      {"NothingWhereAPolygonIs", "two", "depth", [](Json& m) { m["faces"][0]["polygon"] = nullptr; }},
      {"MergedIntoItsNeighbour", "two", "depth", [](Json& m) { merge_faces(m, 0, 1); }},
      {"MergedBeyondItsPolygon", "two", "cover", [](Json& m) { merge_faces(m, 0, 2); }},
      {"SmallPolygonMissing", "islands", "depth", [](Json& m) { merge_faces(m, 1, 0); }},
      {"IslandMissing", "islands", "depth", [](Json& m) { merge_faces(m, 3, 2); }},
      {"ShownBehindWhatItPierces", "crossing", "depth",
       [](Json& m) { std::swap(m["faces"][0]["polygon"], m["faces"][1]["polygon"]); }},
      {"UnevenPolygonWrong", "bumpy", "cover", [](Json& m) { m["faces"][0]["polygon"] = 1; }},
      {"PiercedUnevenPolygonWrong", "bumpy", "depth",
       [](Json& m) {
         for (Json& f : m["faces"]) {
           if (f["polygon"] == 3) f["polygon"] = 2;
         }
       }},
      {"HoleFilled", "keyhole", "cover",
       [](Json& m) {  // what is seen through the hole is said to be the polygon around it
         for (Json& f : m["faces"]) {
           if (f["polygon"] == 1) f["polygon"] = 0;
         }
       }},
      {"BackSideShown", "one_sided", "cover", [](Json& m) { m["faces"][2]["polygon"] = 1; }},
      {"CoincidentDropped", "coplanar", "coincident", [](Json& m) { m["faces"][1]["coincident"] = {3}; }},
      {"CoincidentAdded", "coplanar", "coincident",
       [](Json& m) {
         m["faces"][1]["coincident"] = {1, 2, 3};
       }},
      {"CoincidentOfNothing", "two", "coincident", [](Json& m) { m["faces"][2]["coincident"] = {1}; }},
      {"CoplanarOwnerSwapped", "coplanar", "coincident",
       [](Json& m) {
         m["faces"][1]["polygon"] = 3;
         m["faces"][1]["coincident"] = {0};
       }},
      // Figures.
      {"WrongArea", "two", "area", [](Json& m) { m["faces"][0]["area"] = 0.1875 + 2e-12; }},
      {"AreasExchanged", "two", "area", [](Json& m) { std::swap(m["faces"][0]["area"], m["faces"][1]["area"]); }},
      {"WrongSolidAngle", "two", "solid angle",
       [](Json& m) { m["faces"][0]["solid_angle"] = m["faces"][0]["solid_angle"].get<double>() + 2e-12; }},
      // Kinds and owners.
      {"SilhouetteCalledCrease", "two", "kinds",
       [](Json& m) {
         m["edges"][4]["kind"] = "crease";
         m["edges"][4]["owner"] = nullptr;
       }},
      {"CreaseCalledIntersection", "room", "kinds", [](Json& m) { first_edge(m, "crease")["kind"] = "intersection"; }},
      {"CreaseCalledSeam", "room", "kinds", [](Json& m) { first_edge(m, "crease")["kind"] = "seam"; }},
      {"CreaseCalledSilhouette", "room", "kinds",
       [](Json& m) {
         Json& e = first_edge(m, "crease");
         e["kind"] = "silhouette";
         e["owner"] = m["faces"][e["left"].get<std::size_t>()]["polygon"];
       }},
      {"IntersectionCalledCrease", "crossing", "kinds",
       [](Json& m) { first_edge(m, "intersection")["kind"] = "crease"; }},
      {"UnevenIntersectionCalledCrease", "bumpy", "kinds",
       [](Json& m) { first_edge(m, "intersection")["kind"] = "crease"; }},
      {"SeamCalledCrease", "coplanar", "kinds", [](Json& m) { first_edge(m, "seam")["kind"] = "crease"; }},
      {"WindowCalledSilhouette", "two", "kinds", [](Json& m) { m["edges"][0]["kind"] = "silhouette"; }},
      {"InnerEdgeCalledWindow", "two", "kinds",
       [](Json& m) {
         m["edges"][4]["kind"] = "window";
         m["edges"][4]["owner"] = nullptr;
       }},
      {"WrongOwner", "two", "kinds", [](Json& m) { m["edges"][edge_between(m, 0, 1)]["owner"] = 0; }},
      {"OwnerMissing", "two", "kinds", [](Json& m) { m["edges"][4]["owner"] = nullptr; }},
      {"OwnerOfACrease", "room", "kinds", [](Json& m) { first_edge(m, "crease")["owner"] = 0; }},
      {"OwnerOfAWindowEdge", "room", "kinds", [](Json& m) { first_edge(m, "window")["owner"] = 0; }},
      // Maximality and scene vertices.
      {"SeamKeptWithinAPolygon", "two", "maximality", cut_face},
      {"SceneVertexMissing", "two", "scene vertices", [](Json& m) { m["vertices"][4]["scene_vertex"] = nullptr; }},
      {"SceneVertexWrong", "two", "scene vertices", [](Json& m) { m["vertices"][4]["scene_vertex"] = 0; }},
      {"SceneVertexInvented", "two", "scene vertices", [](Json& m) { m["vertices"][5]["scene_vertex"] = 2; }},
      {"SceneVertexNotTheLowest", "coplanar", "scene vertices",
       [](Json& m) {
         for (Json& v : m["vertices"]) {
           if (v["scene_vertex"] == 0) v["scene_vertex"] = 9;
         }
       }},
      {"SceneVertexNotDrawn", "two", "scene vertices",
       [](Json& m) {
         m["faces"][0]["polygon"] = 1;
         merge_faces(m, 0, 1);
       }},
  };
  return list;
}

class Mutation : public testing::TestWithParam<Damage> {};

TEST_P(Mutation, IsRefused) {
  Json map = load_map(GetParam().map);
  const Json right = map;
  GetParam().inflict(map);
  ASSERT_NE(map, right);
  const Report report = check_map(GetParam().map, map);
  EXPECT_TRUE(report.checks().contains(GetParam().check))
      << "expected " << GetParam().check << ", found " << checks_of(report) << "\n"
      << all_faults(report);
}

INSTANTIATE_TEST_SUITE_P(Damage, Mutation, testing::ValuesIn(all_damage()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(MutatedScene, PolygonAddedInFrontIsMissed) {
  Soup soup = read_scene(data_file("two.obj"));
  // A tiny triangle before the square, in the middle of the face that sees it.
  const auto first = static_cast<std::uint32_t>(soup.vertices.size());
  for (const auto& p : {std::array{-0.25, 1.0, -0.25}, std::array{-0.24, 1.0, -0.25}, std::array{-0.25, 1.0, -0.24}}) {
    soup.vertices.push_back(p);
  }
  for (std::uint32_t i = 0; i < 3; ++i) soup.corners.push_back(first + i);
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  Json map = load_map("two");
  map["scene"]["vertices"] = 10;
  map["scene"]["polygons"] = 3;
  Report report = Verifier(soup).check("map", map.dump());
  EXPECT_EQ(checks_of(report), "depth ") << all_faults(report);

  // Behind the square it is hidden, and the map is right.
  for (std::size_t v = first; v < soup.vertices.size(); ++v) {
    for (double& x : soup.vertices[v]) x *= 3;
  }
  report = Verifier(soup).check("map", map.dump());
  EXPECT_TRUE(report.ok()) << all_faults(report);

  // In the square it is another polygon in the same place.
  for (std::size_t v = first; v < soup.vertices.size(); ++v) {
    for (double& x : soup.vertices[v]) x *= 2;
    soup.vertices[v][1] = 2;
    for (const std::size_t axis : {0U, 2U}) soup.vertices[v][axis] /= 3;
  }
  report = Verifier(soup).check("map", map.dump());
  EXPECT_EQ(checks_of(report), "coincident ") << all_faults(report);
  map["faces"][0]["coincident"] = {2};
  report = Verifier(soup).check("map", map.dump());
  EXPECT_TRUE(report.ok()) << all_faults(report);
}

TEST(MutatedCamera, IsComparedWithTheFile) {
  const Json map = load_map("two");
  const auto check = [&](CameraLine line) {
    return checks_of(Verifier(read_scene(data_file("two.obj"))).check("map", map.dump(), &line));
  };
  const CameraLine right{{0, 0, 0}, {0, 3, 0}, {0, 0.5, 2}, 90, 1};
  EXPECT_EQ(check(right), "");
  CameraLine wrong = right;
  wrong.eye[0] = 5e-324;
  EXPECT_EQ(check(wrong), "camera ");
  wrong = right;
  wrong.fov_degrees = 90.0001;
  EXPECT_EQ(check(wrong), "camera ");
  wrong = right;
  wrong.aspect = 1.000001;
  EXPECT_EQ(check(wrong), "camera ");
  wrong = right;
  wrong.forward = {0, -1, 0};
  EXPECT_EQ(check(wrong), "camera ");
  wrong = right;
  wrong.up = {1e-6, 0, 1};
  EXPECT_EQ(check(wrong), "camera ");
}

}  // namespace
}  // namespace sightline::verify
