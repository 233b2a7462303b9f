// The command `compare`.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace sightline::test {
namespace {

std::filesystem::path folder_with_model(const std::string& test, const std::vector<std::string>& more = {}) {
  const auto folder = fresh_folder(test);
  std::vector<std::string> arguments{"model", "maze", "-o", "m.obj", "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  EXPECT_EQ(run(folder, arguments).code, 0);
  write(folder / "c.cameras", first_lines(read(folder / "m.cameras"), 3));
  return folder;
}

Ended compare(const std::filesystem::path& folder, const std::string& methods, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"compare", "m.obj", "--cameras", "c.cameras", "--methods", methods, "-o", "out"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(folder, arguments);
}

TEST(CompareCommand, WritesTableJsonLinesAndPictures) {
  const auto folder = folder_with_model("compare_all");
  const Ended ended = compare(folder, "front-to-back,cells,hybrid,ids:32,ids:64");
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("ids:64"), std::string::npos);
  const auto json = nlohmann::json::parse(read(folder / "out/compare.json"));
  EXPECT_EQ(json["cameras"], 3);
  ASSERT_EQ(json["methods"].size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {
    const auto& method = json["methods"][k];
    EXPECT_GT(method["seconds"].get<double>(), 0);
    EXPECT_EQ(method["missed"].get<double>() == 0, k < 3);
    EXPECT_EQ(method["false"], 0);
    EXPECT_EQ(method["wrong_area"].get<double>() == 0, k < 3);
    EXPECT_EQ(method["worst_area"].get<double>() == 0, k < 3);
  }
  EXPECT_LT(json["methods"][4]["wrong_area"], json["methods"][3]["wrong_area"]);
  for (const char* file : {"out/compare.csv", "out/compare.svg", "out/compare.png"}) {
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  }
  // Standard output is the report's, or nobody's.
  EXPECT_EQ(nlohmann::json::parse(compare(folder, "ids:8", {"--json"}).out)["command"], "compare");
  EXPECT_EQ(compare(folder, "ids:8", {"-q"}).out, "");
}

TEST(CompareCommand, TheEngineOnPlainDoublesAnswersOrSaysWhyNot) {
  // Small integers: doubles are exact here, but for where vertices are written.
  const auto axes = folder_with_model("compare_axes");
  ASSERT_EQ(compare(axes, "double").code, 0);
  const auto json = nlohmann::json::parse(read(axes / "out/compare.json"));
  EXPECT_GT(json["methods"][0]["seconds"].get<double>(), 0);
  EXPECT_EQ(json["methods"][0]["missed"], 0);
  EXPECT_LT(json["methods"][0]["wrong_area"].get<double>(), 1e-12);
  // Turned by rounded numbers no view survives, and that is said and counted.
  const auto turned = folder_with_model("compare_turned", {"--rotate", "17"});
  const Ended ended = compare(turned, "double,front-to-back");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto figures = nlohmann::json::parse(read(turned / "out/compare.json"));
  const bool failed = ended.out.find("double failed in ") != std::string::npos;
  EXPECT_EQ(failed, figures["methods"][0]["wrong_area"].get<double>() > 0.01) << ended.out;
  EXPECT_EQ(figures["methods"][1]["wrong_area"], 0);
}

TEST(CompareCommand, RefusesWhatItCannotDo) {
  const auto folder = folder_with_model("compare_bad");
  const auto expect = [&](int code, const std::string& methods, const std::string& says) {
    const Ended ended = compare(folder, methods);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  };
  expect(2, "front-to-back,magic", "--methods: 'magic': no such method");
  expect(2, "ids:0", "--methods: 'ids:0'");
  expect(2, "cells,cells", "twice");
  const Ended engine = run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "x", "--engine", "double"});
  EXPECT_EQ(engine.code, 2);  // never for maps
  write(folder / "c.cameras", "# none\n");
  expect(3, "cells", "holds no camera");
}

}  // namespace
}  // namespace sightline::test
