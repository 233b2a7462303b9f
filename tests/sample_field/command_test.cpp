// The command `field`.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace sightline::test {
namespace {

std::filesystem::path folder_with_model(const std::string& test) {
  const auto folder = fresh_folder(test);
  EXPECT_EQ(run(folder, {"model", "city", "-o", "m.obj", "-q"}).code, 0);
  // One camera above the city, one before it.
  write(folder / "c.cameras", "0 0 400  0 0 -1  0 1 0  60 1.5\n0 -600 60  0 1 -0.1  0 0 1  40 1.5\n");
  return folder;
}

Ended field(const std::filesystem::path& folder, std::vector<std::string> words) {
  words.insert(words.begin(), "field");
  return run(folder, words);
}

std::size_t lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

TEST(FieldCommand, BuildsAndIsAsked) {
  const auto folder = folder_with_model("field_all");
  const std::vector<std::string> build{"build", "m.obj", "--samples", "4x4x12x12", "--ids", "3", "--mipmap"};
  auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), build.begin(), build.end());
    return field(folder, more);
  };
  const Ended built = with({"-o", "a.field", "--threads", "1", "--report", "a.json"});
  ASSERT_EQ(built.code, 0) << built.err;
  ASSERT_EQ(with({"-o", "b.field", "--threads", "3", "-q"}).code, 0);
  EXPECT_TRUE(read(folder / "a.field") == read(folder / "b.field"));
  const auto figures = nlohmann::json::parse(read(folder / "a.json"))["field"];
  EXPECT_EQ(figures["slabs"], 6);
  EXPECT_EQ(figures["samples"], 6 * 4 * 4 * 12 * 12);
  EXPECT_EQ(figures["array_bytes"], 4 * 3 * 6 * 4 * 4 * 12 * 12);
  EXPECT_EQ(figures["file_bytes"], std::filesystem::file_size(folder / "a.field"));
  EXPECT_EQ(figures["rays"], 81 * 6 * 4 * 4 * 12 * 12);
  EXPECT_GT(figures["compression"].get<double>(), 1);

  const Ended asked = field(folder, {"query", "a.field", "--cameras", "c.cameras", "-o", "q.csv", "--json"});
  ASSERT_EQ(asked.code, 0) << asked.err;
  const std::string csv = read(folder / "q.csv");
  EXPECT_EQ(csv.substr(0, 20), "camera,cell,polygon\n");
  const auto report = nlohmann::json::parse(asked.out);
  EXPECT_EQ(report["command"], "field query");
  ASSERT_EQ(report["cameras"].size(), 2u);
  EXPECT_EQ(lines(csv) - 1,
            report["cameras"][0]["polygons"].get<std::size_t>() + report["cameras"][1]["polygons"].get<std::size_t>());
  for (const auto& camera : report["cameras"]) EXPECT_GT(camera["cells"], 10);

  const auto count = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words{"query", "a.field", "--cameras", "c.cameras", "-o", "o.csv", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = field(folder, words);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return lines(read(folder / "o.csv"));
  };
  EXPECT_GE(count({"--filter", "uv+st"}), lines(csv));
  EXPECT_GE(count({"--mipmap"}), lines(csv));
  EXPECT_GE(count({"--keep", "1"}), lines(csv));
  EXPECT_LE(count({"--pixels", "256", "--subsample", "16"}), lines(csv));
  EXPECT_GT(count({"--trace", "m.obj"}), 10u);
  count({"--threads", "2"});
  EXPECT_EQ(read(folder / "o.csv"), csv);
}

TEST(FieldCommand, KnowsItsSlabsAndCells) {
  const auto folder = folder_with_model("field_kinds");
  write(folder / "s.txt", "infinity -1 -1 -1 2 0 0 0 2 0  -200 -200 0 400 0 0 0 400 0\n");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--slabs", "s.txt"},
                                             {"--view", "-4", "-4", "1", "4", "4", "6"},
                                             {"--before", "top"},
                                             {"--distance", "2"},
                                             {"--cells", "polygon"},
                                             {"--cells", "scene:9"},
                                             {"--cells", "octree:1"},
                                             {"--objects", "connected"},
                                             {"--rays", "1"}}) {
    std::vector<std::string> words{"build", "m.obj", "-o", "x.field", "--samples", "2x2x6x6", "-q"};
    words.insert(words.end(), more.begin(), more.end());
    const Ended ended = field(folder, words);
    EXPECT_EQ(ended.code, 0) << more[0] << ended.err;
    EXPECT_EQ(field(folder, {"query", "x.field", "--cameras", "c.cameras", "-o", "x.csv", "-q"}).code, 0);
  }
}

TEST(FieldCommand, RefusesWhatItCannotDo) {
  const auto folder = folder_with_model("field_bad");
  ASSERT_EQ(field(folder, {"build", "m.obj", "-o", "good.field", "--samples", "2x2x4x4", "-q"}).code, 0);
  ASSERT_EQ(run(folder, {"model", "rooms", "-o", "rooms.obj", "-q"}).code, 0);
  write(folder / "bad.field", read(folder / "good.field").substr(0, 500));
  write(folder / "text.field", "sightline-map\n");
  write(folder / "none.txt", "# nothing\n");
  const auto expect = [&](int code, const std::vector<std::string>& words, const std::string& says) {
    const Ended ended = field(folder, words);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
  };
  expect(2, {"build", "m.obj", "-o", "x.txt"}, "must end in .field");
  expect(2, {"build", "m.obj", "-o", "x.field", "--samples", "3x3x3"}, "--samples 3x3x3: wants UxVxSxT");
  expect(2, {"build", "m.obj", "-o", "x.field", "--samples", "3x3x3x5000"}, "--samples");
  expect(2, {"build", "m.obj", "-o", "x.field", "--samples", "3x3x3x5x7"}, "--samples");
  expect(2, {"build", "m.obj", "-o", "x.field", "--cells", "cube:3"}, "--cells cube:3: wants polygon");
  expect(2, {"build", "m.obj", "-o", "x.field", "--rays", "2"}, "--rays");
  expect(2, {"build", "m.obj", "-o", "x.field", "--before", "top", "--distance", "3"}, "one of them at most");
  expect(2, {"build", "m.obj", "-o", "x.field", "--view", "0", "0", "0", "1", "0", "1"}, "--view");
  expect(3, {"build", "m.obj", "-o", "x.field", "--slabs", "none.txt", "-q"}, "none.txt: holds no slab");
  EXPECT_FALSE(std::filesystem::exists(folder / "x.field"));
  const auto query = [&](const std::string& file, std::vector<std::string> more = {}) {
    std::vector<std::string> words{"query", file, "--cameras", "c.cameras", "-o", "x.csv"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect(3, query("bad.field"), "bad.field: the file is damaged or cut short");
  expect(3, query("text.field"), "text.field:1: is no field file");
  expect(3, query("missing.field"), "missing.field");
  expect(3, query("good.field", {"--trace", "rooms.obj"}), "good.field: is of a scene of 1125 polygons");
  expect(2, query("good.field", {"--subsample", "300"}), "--subsample");
  expect(2, query("good.field", {"--filter", "all"}), "--filter");
  expect(2, query("good.field", {"--snap", "1"}), "--snap");
  expect(2, {}, "subcommand");
  EXPECT_FALSE(std::filesystem::exists(folder / "x.csv"));
}

}  // namespace
}  // namespace sightline::test
