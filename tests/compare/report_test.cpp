// Comparisons as a whole, and what is said of them.
#include "compare/report.hpp"
#include "tests/compare/views.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>

namespace sightline::comparison {
namespace {

TEST(Comparison, ExactEnginesHaveNoError) {
  const Views views("city", {}, 4);
  const auto names = parse_methods("cells,front-to-back,ids:32");
  std::size_t steps = 0;
  const auto results = compare_methods(views.scene, views.cameras, names, [&] { ++steps; });
  EXPECT_EQ(steps, 4u);
  ASSERT_EQ(results.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    const Summary s = summary_of(results[k]);
    EXPECT_EQ(results[k].views.size(), 4u);
    EXPECT_GT(s.seconds, 0);
    EXPECT_EQ(s.failed, 0u);
    EXPECT_EQ(s.missed == 0 && s.falsely == 0 && s.wrong_area == 0 && s.worst_area == 0, k < 2) << names[k].text;
  }
}

MethodResult made(const std::string& name, std::vector<ViewResult> views) { return {name, 0.5, std::move(views)}; }

TEST(Report, SaysMediansMeansAndWhatFailed) {
  const MethodResult method = made("ids:8", {{4, {1, 0, 0.25, 0.125}, ""},
                                             {1, {2, 1, 0.5, 0.375}, ""},
                                             {2, {0, 0, 0, 0}, ""},
                                             {0, {5, 0, 1, 0.5}, "fell over"},
                                             {3, {2, 4, 0.25, 0.25}, ""}});
  const Summary all = summary_of(method), done = summary_of_done(method);
  EXPECT_EQ(all.seconds, 2.5);
  EXPECT_EQ(all.missed, 2);
  EXPECT_EQ(all.falsely, 1);
  EXPECT_EQ(all.wrong_area, 0.4);
  EXPECT_EQ(all.worst_area, 0.5);
  EXPECT_EQ(all.failed, 1u);
  EXPECT_EQ(done.missed, 1.25);
  EXPECT_EQ(done.wrong_area, 0.25);
  EXPECT_EQ(done.worst_area, 0.375);

  const MethodResult never = made("double", {5, {0, {5, 0, 1, 0.5}, "no"}});
  const std::vector<MethodResult> both{method, never};
  const auto parsed = nlohmann::ordered_json::parse(json(both, 5));
  ASSERT_EQ(parsed.size(), 2u);
  EXPECT_EQ(parsed["cameras"], 5);
  ASSERT_EQ(parsed["methods"].size(), 2u);
  std::string keys;
  for (const auto& [key, value] : parsed["methods"][0].items()) keys += key + " ";
  EXPECT_EQ(keys, "name seconds missed false wrong_area worst_area ");
  EXPECT_EQ(parsed["methods"][0]["name"], "ids:8");
  EXPECT_EQ(parsed["methods"][0]["seconds"], 2.5);
  EXPECT_EQ(parsed["methods"][0]["false"], 1);
  EXPECT_TRUE(parsed["methods"][1]["seconds"].is_null());
  EXPECT_EQ(parsed["methods"][1]["wrong_area"], 1);

  const std::string text = table(both);
  EXPECT_NE(text.find("ids:8 failed in 1 of 5 views"), std::string::npos);
  EXPECT_NE(text.find("1 x fell over"), std::string::npos);
  EXPECT_NE(text.find("5 x no"), std::string::npos);
  const std::string lines = csv(both);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 11);
  EXPECT_NE(lines.find("1,ids:8,1,2,1,0.5,0.375,0\n"), std::string::npos);
  EXPECT_NE(lines.find("3,ids:8,0,5,0,1,0.5,1\n"), std::string::npos);
}

TEST(Report, PicturesOfAnyFigures) {
  const auto folder = std::filesystem::temp_directory_path() / ("sightline_compare_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::vector<std::vector<MethodResult>> some{
      {},
      {made("cells", {{1e-3, {}, ""}})},
      {made("cells", {{0, {}, ""}}), made("double", {{0, {1, 0, 1, 1}, "no"}})},
      {made("ids:8", {{1e-9, {1, 0, 1e-300, 0}, ""}}), made("ids:16", {{1e9, {1000000, 7, 1, 1}, ""}})}};
  for (const auto& methods : some) {
    write_picture(folder / "picture", methods, "a title");
    EXPECT_GT(std::filesystem::file_size(folder / "picture.svg"), 1000u);
    EXPECT_GT(std::filesystem::file_size(folder / "picture.png"), 1000u);
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sightline::comparison
