#include "tests/visibility_map/sketch.hpp"
#include "visibility_map/read.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

namespace sightline {
namespace {

const MapScene about{"a \"b\"\n\\.obj", 8, 2, ""};

const std::string expected = R"({"format": "sightline-map", "version": 1,
"scene": {"source": "a \"b\"\u000a\\.obj", "vertices": 8, "polygons": 2, "snap": null},
"camera": {"eye": [0, 0, 0], "forward": [0, 1, 0], "right": [1, 0, 0], "up": [0, 0, 1]},
"lines": [
["window", "left"],
["window", "right"],
["window", "bottom"],
["window", "top"],
["edge", 4, 5],
["edge", 5, 6],
["edge", 6, 7],
["edge", 4, 7]
],
"vertices": [
{"st": [0, 0], "lines": [0, 2], "scene_vertex": null},
{"st": [1, 0], "lines": [1, 2], "scene_vertex": null},
{"st": [1, 1], "lines": [1, 3], "scene_vertex": null},
{"st": [0, 1], "lines": [0, 3], "scene_vertex": null},
{"st": [0.25, 0.25], "lines": [4, 7], "scene_vertex": 4},
{"st": [0.75, 0.25], "lines": [4, 5], "scene_vertex": 5},
{"st": [0.75, 0.75], "lines": [5, 6], "scene_vertex": 6},
{"st": [0.25, 0.75], "lines": [6, 7], "scene_vertex": 7}
],
"edges": [
{"vertices": [0, 1], "line": 2, "left": 0, "right": null, "kind": "window", "owner": null},
{"vertices": [1, 2], "line": 1, "left": 0, "right": null, "kind": "window", "owner": null},
{"vertices": [2, 3], "line": 3, "left": 0, "right": null, "kind": "window", "owner": null},
{"vertices": [3, 0], "line": 0, "left": 0, "right": null, "kind": "window", "owner": null},
{"vertices": [4, 5], "line": 4, "left": 1, "right": 0, "kind": "silhouette", "owner": 1},
{"vertices": [5, 6], "line": 5, "left": 1, "right": 0, "kind": "silhouette", "owner": 1},
{"vertices": [6, 7], "line": 6, "left": 1, "right": 0, "kind": "silhouette", "owner": 1},
{"vertices": [7, 4], "line": 7, "left": 1, "right": 0, "kind": "silhouette", "owner": 1}
],
"faces": [
{"polygon": 0, "coincident": [], "loops": [[0, 1, 2, 3], [-8, -7, -6, -5]], "area": 0.75, "solid_angle": 0.55000000000000004},
{"polygon": 1, "coincident": [], "loops": [[4, 5, 6, 7]], "area": 0.25, "solid_angle": 0.23499999999999999}
]}
)";

TEST(MapJson, HasTheBytesOfTheContract) { EXPECT_EQ(map_json(SquareBeforeWall::map(), about), expected); }

TEST(MapJson, TellsOfTheScene) {
  const Scene scene = make_scene(SquareBeforeWall::polygons(), {.snap = "0.25"});
  const std::string json = map_json(SquareBeforeWall::map(), scene);
  EXPECT_NE(json.find(R"("scene": {"source": "sketch.obj", "vertices": 8, "polygons": 2, "snap": "0.25"})"),
            std::string::npos);
}

TEST(MapJson, EveryKindOfLineAndValue) {
  VisibilityMap map = SquareBeforeWall::map();
  map.lines[4] = {MapLine::planes, {0, 1, 2, 4, 5, 6}};
  map.edges[4].kind = EdgeKind::crease;
  map.edges[5].kind = EdgeKind::seam;
  map.edges[6].kind = EdgeKind::intersection;
  map.edges[6].owner = none;
  map.faces[1].polygon = none;
  map.coincident = {0, 1};
  map.faces[0].coincident_count = 2;
  map.vertices[4].st.x = -0.0;
  map.camera.eye = {1e-300, -123456789.125, 1e22};
  const std::string json = map_json(map, about);
  for (const char* text :
       {R"(["planes", [0, 1, 2], [4, 5, 6]])", R"("kind": "crease")", R"("kind": "seam")",
        R"("kind": "intersection", "owner": null)", R"({"polygon": null, "coincident": [],)",
        R"({"polygon": 0, "coincident": [0, 1],)", R"("st": [0, 0.25])", R"("eye": [1e-300, -123456789.125, 1e+22])"}) {
    EXPECT_NE(json.find(text), std::string::npos) << text;
  }
  const MapFile read = parse_map(json, "m.json");
  EXPECT_EQ(map_json(read.map, read.scene), json);
  EXPECT_EQ(read.map.camera.eye, map.camera.eye);
  EXPECT_EQ(read.map.lines[4], map.lines[4]);
}

TEST(MapJson, SphereMapsHaveNoFile) {
  VisibilityMap map = SquareBeforeWall::map();
  map.sphere = true;
  EXPECT_THROW(map_json(map, about), std::invalid_argument);
}

TEST(MapJson, DoublesSurviveTheRoundTrip) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    VisibilityMap map = SquareBeforeWall::map();
    for (MapVertex& v : map.vertices) {
      v.st = {std::generate_canonical<double, 53>(random), std::generate_canonical<double, 53>(random)};
    }
    map.faces[0].area = std::ldexp(std::generate_canonical<double, 53>(random), -static_cast<int>(random() % 300));
    const std::string json = map_json(map, about);
    const MapFile read = parse_map(json, "m.json");
    EXPECT_EQ(map_json(read.map, read.scene), json);
    for (std::size_t v = 0; v < map.vertices.size(); ++v) EXPECT_EQ(read.map.vertices[v].st, map.vertices[v].st);
    EXPECT_EQ(read.map.faces[0].area, map.faces[0].area);
  }
}

TEST(ReadMap, GivesBackWhatWasWritten) {
  const VisibilityMap map = SquareBeforeWall::map();
  const MapFile read = parse_map(expected, "m.json");
  EXPECT_EQ(read.scene.source, about.source);
  EXPECT_EQ(read.scene.vertices, 8u);
  EXPECT_EQ(read.scene.polygons, 2u);
  EXPECT_EQ(read.map.lines, map.lines);
  EXPECT_EQ(read.map.first_edge, map.first_edge);
  EXPECT_EQ(read.map.loop_edges, map.loop_edges);
  ASSERT_EQ(read.map.vertices.size(), map.vertices.size());
  for (std::size_t v = 0; v < map.vertices.size(); ++v) {
    EXPECT_EQ(read.map.vertices[v].scene_vertex, map.vertices[v].scene_vertex);
    EXPECT_LT(glm::distance(read.map.vertices[v].direction, map.vertices[v].direction), 1e-15);
  }
  EXPECT_EQ(map_json(read.map, read.scene), expected);
}

/// What reading says of a text; empty if it is taken.
std::string refusal(const std::string& text) {
  try {
    parse_map(text, "m.json");
    return "";
  } catch (const InputError& e) {
    return e.what();
  }
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = expected;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(ReadMap, NamesWhatIsWrong) {
  EXPECT_EQ(refusal(expected), "");
  const std::pair<std::string, std::string> cases[] = {
      {"", "m.json:1: not JSON: the file is empty"},
      {"{\n\"format\": ]", "m.json:2: not JSON"},
      {"[1]", "m.json: the file: is no JSON object"},
      {with("sightline-map", "map"), "m.json: format: is not \"sightline-map\""},
      {with("\"version\": 1", "\"version\": 2"), "m.json: version: is not 1"},
      {with("\"edges\"", "\"edgy\""), "m.json: the file: has no \"edges\""},
      {with("\"vertices\": 8", "\"vertices\": -8"), "m.json: scene.vertices: is no count"},
      {with("\"eye\": [0, 0, 0]", "\"eye\": [0, 0]"), "m.json: camera.eye: has not 3 elements"},
      {with("\"eye\": [0, 0, 0]", "\"eye\": [0, 0, 1e999]"), "m.json: a number is out of range"},
      {with("\"up\": [0, 0, 1]", "\"up\": [1, 1, 0]"), "m.json: camera: "},
      {with("[\"window\", \"left\"]", "[\"window\", \"inside\"]"), "m.json: lines[0]: names no side of the window"},
      {with("[\"edge\", 4, 5]", "[\"edge\", 4, 8]"), "m.json: lines[4]: index 8 is out of range"},
      {with("[\"edge\", 4, 5]", "[\"edge\", 4]"), "m.json: lines[4]: has not 3 elements"},
      {with("[\"edge\", 4, 5]", "[\"edges\", 4, 5]"), "m.json: lines[4]: is no line"},
      {with("[\"edge\", 4, 5]", "[]"), "m.json: lines[4]: is empty"},
      {with("\"lines\": [0, 2]", "\"lines\": [0, 12]"), "m.json: vertices[0].lines: index 12 is out of range"},
      {with("\"scene_vertex\": 4", "\"scene_vertex\": 4.5"), "m.json: vertices[4].scene_vertex: is no index"},
      {with("\"vertices\": [0, 1], \"line\": 2", "\"vertices\": [0, 9], \"line\": 2"),
       "m.json: edges[0].vertices: index 9 is out of range"},
      {with("\"right\": null", "\"right\": 2"), "m.json: edges[0].right: index 2 is out of range"},
      {with("\"kind\": \"silhouette\"", "\"kind\": \"shadow\""), "m.json: edges[4].kind: is no kind of edge"},
      {with("\"owner\": 1", "\"owner\": \"x\""), "m.json: edges[4].owner: is no index"},
      {with("[0, 1, 2, 3]", "[0, 2, 1, 3]"), "m.json: faces[0].loops: edge 2 does not begin where the one before ends"},
      {with("[0, 1, 2, 3]", "[0, 1, 2, 8]"), "m.json: faces[0].loops: edge 8 is out of range"},
      {with("[0, 1, 2, 3]", "[]"), "m.json: faces[0].loops: an empty loop"},
      {with("[[4, 5, 6, 7]]", "[[4, 5, 6, 7], [4, 5, 6, 7]]"), "m.json: faces[1].loops: edge 4 stands twice"},
      {with("[-8, -7, -6, -5]", "[4, 5, 6, 7]"), "m.json: faces[0].loops: edge 4 names another face"},
      {with("[[0, 1, 2, 3], [-8, -7, -6, -5]]", "[[0, 1, 2, 3]]"),
       "m.json: edges[4]: stands in no loop of a face that it names"},
      {with("\"area\": 0.25", "\"area\": null"), "m.json: faces[1].area: is no number"},
  };
  for (const auto& [text, message] : cases) {
    const std::string said = refusal(text);
    EXPECT_EQ(said.substr(0, message.size()), message);
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

/// Cut or changed anywhere, a file is either refused in one line or still a whole map.
TEST(ReadMap, DamagedFilesAreRefusedOrWhole) {
  const std::string& whole = expected;
  for (std::size_t length = 0; length + 2 < whole.size(); ++length) {
    ASSERT_NE(refusal(whole.substr(0, length)), "") << length;
  }
  std::mt19937_64 random(2);
  const std::string bytes = "0123456789-.,:[]{}\" eE\n\\nultrx";
  for (int round = 0; round < 5000; ++round) {
    std::string text = whole;
    for (std::uint64_t k = random() % 3 + 1; k-- > 0;) {
      const std::size_t at = random() % text.size();
      if (random() % 2 == 0) {
        text[at] = random() % 8 == 0 ? static_cast<char>(random() % 256) : bytes[random() % bytes.size()];
      } else {
        text.erase(at, random() % 20);
      }
    }
    const std::string said = refusal(text);
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
}

TEST(ReadMap, FilesThatCannotBeRead) {
  const auto folder = std::filesystem::temp_directory_path();
  EXPECT_THROW(read_map(folder / "there-is-no-such.map.json"), InputError);
  EXPECT_THROW(read_map(folder), InputError);
  const auto file = folder / "sightline-read-map-test.map.json";
  std::ofstream(file) << expected;
  EXPECT_EQ(map_json(read_map(file).map, about), expected);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace sightline
