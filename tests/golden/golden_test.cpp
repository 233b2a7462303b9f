// The maps of the built-in models are the bytes that they were. With SIGHTLINE_GOLDEN=write in the environment the kept
// ones are written anew instead.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "models/model.hpp"
#include "tests/golden/kept.hpp"
#include "visibility_map/write.hpp"

namespace sightline::golden {
namespace {

namespace fs = std::filesystem;

/// A model and the cameras whose maps are kept whole: two of small maps, where it has any.
struct Case {
  const char* model;
  std::set<std::size_t> whole;
};

bool writing() {
  const char* value = std::getenv("SIGHTLINE_GOLDEN");
  if (value == nullptr || *value == 0) return false;
  if (std::string(value) != "write") throw std::runtime_error("SIGHTLINE_GOLDEN can only be \"write\"");
  return true;
}

fs::path whole_file(const std::string& model, std::size_t camera) {
  return fs::path(GOLDEN_FOLDER) / (model + "-" + std::to_string(camera) + ".map.json");
}

class Golden : public testing::TestWithParam<Case> {};

TEST_P(Golden, MapsAreTheKeptOnes) {
  const std::string name = GetParam().model;
  const bool write = writing();
  const fs::path table = fs::path(GOLDEN_FOLDER) / (name + ".txt");
  const std::vector<Row> kept = write ? std::vector<Row>() : read_rows(table);
  const Model model = make_model(name);
  ASSERT_TRUE(write || kept.size() == model.cameras.size()) << name << " has other cameras than those kept";
  const Scene scene = make_scene(model.soup);
  const Complex complex = build(scene);
  Tracer tracer(scene, complex);
  VisibilityMap map;
  std::vector<Row> rows;
  std::size_t different = 0;
  for (std::size_t k = 0; k < model.cameras.size(); ++k) {
    const CameraLine& c = model.cameras[k];
    tracer.trace(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect), map);
    const std::string json = map_json(map, scene);
    rows.push_back(row_of(k, map, json));
    const bool whole = GetParam().whole.contains(k);
    if (write) {
      if (whole) write_text(whole_file(name, k), json);
      continue;
    }
    ASSERT_EQ(kept[k].camera, k) << table;
    std::string fault = whole ? difference(read_text(whole_file(name, k)), json) : std::string();
    if (fault.empty()) fault = difference(kept[k], rows.back());
    if (!fault.empty() && ++different <= 5) ADD_FAILURE() << name << ", camera " << k << ": " << fault;
  }
  if (write) {
    write_text(table, text_of(name, rows));
    GTEST_SKIP() << "written anew, nothing compared";
  }
  EXPECT_EQ(different, 0u) << name << ": so many of " << rows.size() << " maps differ; the first five are shown";
}

INSTANTIATE_TEST_SUITE_P(Models, Golden,
                         testing::Values(Case{"rooms", {0, 37}}, Case{"maze", {10, 63}}, Case{"arena", {4, 80}},
                                         Case{"city", {20, 47}}, Case{"floor", {15, 66}}, Case{"building", {5, 60}},
                                         Case{"tower", {}}, Case{"campus", {7, 8}}, Case{"random", {12, 14}}),
                         [](const auto& test) { return std::string(test.param.model); });

TEST(GoldenComparison, SeesEveryByteAndTheAnglesToATolerance) {
  const std::string map = "{\"a\": 1,\n{\"area\": 0.5, \"solid_angle\": 0.25},\n{\"b\": 2}\n";
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = map;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(difference(map, map), "");
  EXPECT_EQ(difference(map, with("0.25", "0.25000000000000006")), "");
  EXPECT_NE(difference(map, with("0.25", "0.25000000001")), "");
  EXPECT_NE(difference(map, with("0.25", "nan")), "");
  EXPECT_NE(difference(map, with("0.5", "0.50000000000000011")), "");
  EXPECT_NE(difference(map, with("},", "}")), "");
  EXPECT_NE(difference(map, with("{\"b\": 2}\n", "")), "");
  EXPECT_NE(difference(map, map + "x"), "");
  const auto fingerprint = [](const std::string& text) { return row_of(0, VisibilityMap{}, text).fingerprint; };
  EXPECT_EQ(fingerprint(map), fingerprint(with("0.25", "0.25000000000000006")));
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (map.compare(k, 1, "\n") == 0 || (k >= map.find("0.25") && k < map.find("0.25") + 4)) continue;
    std::string changed = map;
    changed[k] ^= 1;
    EXPECT_NE(fingerprint(map), fingerprint(changed)) << k;
    EXPECT_NE(difference(map, changed), "") << k;
  }
  const Row row{3, 4, 5, 6, 7, 8, 0.5};
  for (const Row& other : {Row{3, 9, 5, 6, 7, 8, 0.5}, Row{3, 4, 9, 6, 7, 8, 0.5}, Row{3, 4, 5, 9, 7, 8, 0.5},
                           Row{3, 4, 5, 6, 9, 8, 0.5}, Row{3, 4, 5, 6, 7, 9, 0.5}, Row{3, 4, 5, 6, 7, 8, 0.6}}) {
    EXPECT_NE(difference(row, other), "");
  }
  EXPECT_EQ(difference(row, row), "");
}

}  // namespace
}  // namespace sightline::golden
