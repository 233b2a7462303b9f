// Right maps are found right.
#include "map_edit.hpp"

#include <gtest/gtest.h>

namespace sightline::verify {
namespace {

class RightMap : public testing::TestWithParam<const char*> {};

TEST_P(RightMap, IsFoundRight) {
  const Report report = check_map(GetParam(), load_map(GetParam()));
  EXPECT_TRUE(report.ok()) << all_faults(report);
}

TEST_P(RightMap, IsFoundRightAfterLoopsAreMadeAnew) {  // the tests' own tool is right, too
  Json map = load_map(GetParam());
  retrace(map);
  const Report report = check_map(GetParam(), map);
  EXPECT_TRUE(report.ok()) << all_faults(report);
}

TEST_P(RightMap, IsFoundRightByTwoThreads) {
  Options options;
  options.one_sided = std::string(GetParam()) == "one_sided";
  options.threads = 2;
  Verifier verifier(read_scene(data_file(std::string(GetParam()) + ".obj")), options);
  EXPECT_TRUE(verifier.check("map", load_map(GetParam()).dump()).ok());
  EXPECT_TRUE(verifier.check("map again", load_map(GetParam()).dump()).ok());
}

INSTANTIATE_TEST_SUITE_P(Maps, RightMap,
                         testing::Values("two", "crossing", "coplanar", "keyhole", "islands", "bumpy", "room",
                                         "one_sided", "snapped"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST(Maps, OneSidedSceneIsAnotherSceneTwoSided) {
  const Report report = Verifier(read_scene(data_file("one_sided.obj"))).check("map", load_map("one_sided").dump());
  EXPECT_TRUE(report.checks().contains("depth")) << all_faults(report);
}

TEST(Maps, SnapAskedForMustBeTheMaps) {
  Options options;
  options.snap = "1e-3";
  Verifier verifier(read_scene(data_file("snapped.obj")), options);
  EXPECT_TRUE(verifier.check("map", load_map("snapped").dump()).ok());
  Json map = load_map("snapped");
  map["scene"]["snap"] = "1e-6";
  EXPECT_TRUE(verifier.check("map", map.dump()).checks().contains("scene"));
  map["scene"]["snap"] = nullptr;
  EXPECT_TRUE(verifier.check("map", map.dump()).checks().contains("scene"));
}

TEST(Maps, EveryThreadCountNamesTheSameFaults) {
  Json map = load_map("room");
  std::swap(map["faces"][0]["polygon"], map["faces"][3]["polygon"]);
  std::string one;
  for (const unsigned threads : {1U, 2U, 5U}) {
    Options options;
    options.threads = threads;
    const Report report = Verifier(read_scene(data_file("room.obj")), options).check("map", map.dump());
    if (threads == 1) one = all_faults(report);
    EXPECT_FALSE(report.ok());
    EXPECT_EQ(all_faults(report), one);
  }
}

TEST(Maps, MirroredCameraIsCheckedAsWell) {
  // Seen with `right` turned round, the map is mirrored: s becomes 1 - s, left and right are exchanged.
  Json map = load_map("islands");
  map["camera"]["right"] = {-2, 0, 0};
  for (Json& line : map["lines"]) {
    if (line[1] == "left") {
      line[1] = "right";
    } else if (line[1] == "right") {
      line[1] = "left";
    }
  }
  for (Json& v : map["vertices"]) v["st"][0] = 1 - v["st"][0].get<double>();
  for (Json& e : map["edges"]) std::swap(e["left"], e["right"]);
  retrace(map);
  Report report = check_map("islands", map);
  for (const Fault& fault : report.checks().contains("st") ? report.checks().at("st").first : std::vector<Fault>()) {
    const std::size_t vertex = std::stoul(fault.item.substr(7));
    // 1 - s was rounded: set what is nearest.
    const double s = map["vertices"][vertex]["st"][0].get<double>();
    for (const double near : {std::nextafter(s, 0), std::nextafter(s, 1)}) {
      map["vertices"][vertex]["st"][0] = near;
      const Report again = check_map("islands", map);
      if (!again.checks().contains("st") || again.count() < report.count()) break;
    }
    report = check_map("islands", map);
  }
  EXPECT_TRUE(report.ok()) << all_faults(report);
}

}  // namespace
}  // namespace sightline::verify
