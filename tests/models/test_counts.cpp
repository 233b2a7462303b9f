#include "models/model.hpp"

#include <gtest/gtest.h>

#include <map>

namespace sightline {
namespace {

TEST(ModelCounts, ThePapersNumbers) {
  const std::map<std::string, std::pair<std::size_t, std::size_t>> expected{
      {"rooms", {20, 100}},  {"maze", {310, 100}},   {"arena", {665, 100}},
      {"city", {1125, 100}}, {"floor", {1772, 100}}, {"building", {10057, 100}},
      {"tower", {2409, 24}}, {"campus", {660, 10}},  {"random", {1000, 16}}};
  EXPECT_EQ(model_names().size(), expected.size());
  for (const std::string& name : model_names()) {
    const Model model = make_model(name);
    ASSERT_TRUE(expected.contains(name)) << name;
    EXPECT_EQ(model.soup.first.size() - 1, expected.at(name).first) << name;
    EXPECT_EQ(model.cameras.size(), expected.at(name).second) << name;
  }
}

TEST(ModelCounts, AnyWantedNumber) {
  const std::map<std::string, std::vector<std::uint32_t>> wanted{
      {"maze", {24, 25, 26, 99, 1000, 20001}},
      {"city", {11, 12, 13, 14, 15, 99, 1000, 20001, 100000}},
      {"floor", {24, 100, 199, 200, 350, 777, 5000, 20001}},
      {"building", {24, 50, 199, 200, 201, 250, 330, 444, 777, 1500, 3001, 5000, 20001, 100000}},
      {"random", {1, 100, 5000}}};
  for (const auto& [name, numbers] : wanted) {
    for (const std::uint32_t n : numbers) {
      const Model model = make_model(name, {.polygons = n});
      EXPECT_EQ(model.soup.first.size() - 1, n) << name;
      EXPECT_EQ(model.cameras.size(), name == "random" ? 16u : 100u) << name << ' ' << n;
    }
  }
}

TEST(ModelCounts, EveryNumberOfPolygonsOfASmallBuilding) {
  for (std::uint32_t n = 24; n < 900; n += 7) {
    EXPECT_EQ(make_model("building", {.polygons = n}).soup.first.size() - 1, n);
  }
}

/// A storey of a larger building is a larger storey too: it grows in both ways.
TEST(ModelCounts, BuildingsGrowByFloorsAndByArea) {
  const auto extent = [](std::uint32_t polygons) {
    glm::dvec3 most(0);
    for (const glm::dvec3& v : make_model("building", {.polygons = polygons}).soup.vertices) {
      for (int k = 0; k < 3; ++k) most[k] = std::max(most[k], v[k]);
    }
    return most;
  };
  const glm::dvec3 paper = extent(0), large = extent(100000);
  EXPECT_GE(paper.z, 5 * 3.5);
  for (int k = 0; k < 3; ++k) EXPECT_GT(large[k], 1.3 * paper[k]);
}

}  // namespace
}  // namespace sightline
