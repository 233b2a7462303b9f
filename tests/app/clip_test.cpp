// The command `clip`.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

namespace sightline::test {
namespace {

using Arguments = std::vector<std::string>;

std::filesystem::path folder_with_model(const std::string& test, int cameras) {
  const auto folder = fresh_folder(test);
  EXPECT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  write(folder / "c.cameras", first_lines(read(folder / "m.cameras"), cameras));
  return folder;
}

Ended clip(const std::filesystem::path& folder, const Arguments& more) {
  Arguments arguments{"clip", "m.obj", "--cameras", "c.cameras", "-q"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(folder, arguments);
}

/// The faces of a PLY file: numbers, a line each.
std::vector<std::vector<int>> faces(const std::string& ply) {
  std::istringstream lines(ply);
  std::size_t vertices = 0, count = 0;
  std::string line;
  while (std::getline(lines, line) && line != "end_header") {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) count = std::stoul(line.substr(13));
  }
  for (std::size_t k = 0; k < vertices; ++k) std::getline(lines, line);
  std::vector<std::vector<int>> result;
  while (std::getline(lines, line)) {
    std::istringstream numbers(line);
    result.emplace_back();
    for (int n; numbers >> n;) result.back().push_back(n);
  }
  EXPECT_EQ(result.size(), count);
  return result;
}

TEST(ClipCommand, WritesTheSameFileWhateverBufferAndThreads) {
  const auto folder = folder_with_model("clip_same", 8);
  ASSERT_EQ(clip(folder, {"-o", "a.ply", "--report", "r.json"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "b.ply", "--buffer", "16", "--threads", "3"}).code, 0);
  const std::string ply = read(folder / "a.ply");
  EXPECT_EQ(ply, read(folder / "b.ply"));
  const auto list = faces(ply);
  const auto report = nlohmann::json::parse(read(folder / "r.json"));
  EXPECT_EQ(report["command"], "clip");
  EXPECT_EQ(report["clip"]["pieces"], list.size());
  std::size_t seen = 0;
  for (const auto& face : list) {
    const auto corners = static_cast<std::size_t>(face[0]);
    ASSERT_GE(corners, 3u);
    const int polygon = face[corners + 1], cameras = face[corners + 2];
    EXPECT_TRUE(polygon >= 0 && polygon < 20);
    ASSERT_EQ(face.size(), corners + 3 + static_cast<std::size_t>(cameras));
    for (int k = 0; k < cameras; ++k) {
      const int camera = face[corners + 3 + static_cast<std::size_t>(k)];
      EXPECT_TRUE(camera < 8 && (k == 0 || camera > face[corners + 2 + static_cast<std::size_t>(k)]));
    }
    seen += cameras > 0;
  }
  EXPECT_EQ(report["clip"]["seen"], seen);
  EXPECT_GT(seen, 0u);
  // The pieces are a scene like any other.
  EXPECT_EQ(run(folder, {"trace", "a.ply", "--cameras", "c.cameras", "-o", "maps", "-q"}).code, 0);
}

TEST(ClipCommand, ThresholdAndRegions) {
  const auto folder = folder_with_model("clip_more", 4);
  write(folder / "r",
        "# the left half of camera 0, nothing in the middle of camera 2\n"
        "0 interior 0 0 0.5 0 0.5 1 0 1\n2 exterior 0.25 0.25 0.75 0.25 0.5 0.75\n");
  ASSERT_EQ(clip(folder, {"-o", "a.ply"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "b.ply", "--regions", "r"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "c.ply", "--threshold", "1"}).code, 0);
  EXPECT_NE(read(folder / "a.ply"), read(folder / "b.ply"));
  EXPECT_LT(faces(read(folder / "c.ply")).size(), faces(read(folder / "a.ply")).size());
  EXPECT_NE(read(folder / "c.ply").find("property list uint uint partly"), std::string::npos);
}

TEST(ClipCommand, TableIsThatOfTrace) {
  const auto folder = folder_with_model("clip_csv", 6);
  ASSERT_EQ(clip(folder, {"-o", "a.ply", "--csv", "a.csv", "--threshold", "1", "--threads", "3"}).code, 0);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "maps", "--format", "csv", "-q"}).code, 0);
  EXPECT_EQ(read(folder / "a.csv"), read(folder / "maps" / "visibility.csv"));
}

TEST(ClipCommand, SamplingAndTFree) {
  const auto folder = folder_with_model("clip_variants", 8);
  ASSERT_EQ(clip(folder, {"-o", "a.ply"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "b.ply", "--sampling", "--buffer", "100"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "c.ply", "--t-free"}).code, 0);
  EXPECT_EQ(read(folder / "a.ply"), read(folder / "b.ply"));
  const auto plain = faces(read(folder / "a.ply")), joined = faces(read(folder / "c.ply"));
  ASSERT_EQ(plain.size(), joined.size());
  int more = 0;
  for (std::size_t k = 0; k < plain.size(); ++k) {
    const auto n = static_cast<std::ptrdiff_t>(plain[k][0]), m = static_cast<std::ptrdiff_t>(joined[k][0]);
    EXPECT_GE(m, n);
    more += static_cast<int>(m - n);
    // What follows the corners is the same.
    EXPECT_TRUE(std::equal(plain[k].begin() + n + 1, plain[k].end(), joined[k].begin() + m + 1, joined[k].end()));
  }
  EXPECT_GT(more, 0);
  EXPECT_EQ(run(folder, {"trace", "c.ply", "--cameras", "c.cameras", "-o", "maps", "-q"}).code, 0);
}

TEST(ClipCommand, PicturesByTheNumberOfCameras) {
  const auto folder = folder_with_model("clip_pictures", 3);
  write(folder / "v.cameras", first_lines(read(folder / "m.cameras"), 1));
  ASSERT_EQ(clip(folder, {"-o", "a.ply", "--pictures", "p", "--views", "v.cameras"}).code, 0);
  ASSERT_EQ(clip(folder, {"-o", "b.ply", "--pictures", "q"}).code, 0);
  EXPECT_EQ(files_below(folder / "p").size(), 2u);
  EXPECT_EQ(files_below(folder / "q").size(), 6u);
  const std::string svg = read(folder / "q" / "0000.svg");
  EXPECT_NE(svg.find("data-cameras=\"1\""), std::string::npos);
  EXPECT_NE(svg.find("data-cameras=\"3\""), std::string::npos);
  EXPECT_EQ(svg.find("data-cameras=\"0\""), std::string::npos);  // its own camera sees it at least
  EXPECT_TRUE(read(folder / "q" / "0002.png").starts_with("\x89PNG"));
  EXPECT_EQ(read(folder / "a.ply"), read(folder / "b.ply"));  // views cut nothing
}

TEST(ClipCommand, RefusesWhatItCannotDo) {
  const auto folder = folder_with_model("clip_bad", 2);
  const auto expect = [&](int code, const Arguments& arguments, const std::string& says) {
    const Ended ended = clip(folder, arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "x.ply"));
  };
  expect(2, {"-o", "x.obj"}, "must end in .ply");
  expect(2, {"-o", "x.ply", "--threshold", "-1"}, "--threshold");
  expect(2, {"-o", "x.ply", "--buffer", "0"}, "--buffer");
  expect(2, {"-o", "x.ply", "--views", "c.cameras"}, "--views");
  expect(2, {"-o", "x.ply", "--csv", "x.csv", "--regions", "none"}, "--csv");
  expect(3, {"-o", "x.ply", "--regions", "none"}, "none");
  expect(3, {"-o", "x.ply", "--pictures", "p", "--views", "none"}, "none");
  const auto region = [&](const std::string& text, const std::string& says) {
    write(folder / "r", text);
    expect(3, {"-o", "x.ply", "--regions", "r"}, says);
  };
  region("0 interior 0 0 1 0 1 1\n2 interior 0 0 1 0 1 1\n", "r:2: region 1: there is no camera 2");
  region("0 inside 0 0 1 0 1 1\n", "r:1: region 0: 'inside' is neither interior nor exterior");
  region("0 interior 0 0 1 0\n", "not a strictly convex polygon");
  region("0 interior 0 0 1 0 1\n", "r:1: region 0");
  region("1 exterior 0 0 1 1 1 0 0 1\n", "not a strictly convex polygon");
}

}  // namespace
}  // namespace sightline::test
