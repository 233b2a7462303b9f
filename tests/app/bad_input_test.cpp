// Files that are not what they should be: exit code 3, one line that names the file, nothing written.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
constexpr const char* camera = "0.5 0.5 3  0 0 -1  0 1 0  60 1.5\n";

void expect_refused(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                    const std::string& culprit) {
  SCOPED_TRACE(culprit);
  const auto before = files_below(folder);
  const Ended ended = run(folder, arguments);
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
  EXPECT_NE(ended.err.find(culprit), std::string::npos) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(files_below(folder), before);
}

TEST(BadInput, Scenes) {
  const auto folder = fresh_folder("scenes");
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"empty.obj", ""},
      {"comment.obj", "# nothing\n"},
      {"nan.obj", points + "v nan 0 0\nf 1 2 3\n"},
      {"infinite.obj", points + "v 0 inf 0\nf 1 2 3\n"},
      {"overflow.obj", points + "v 0 1e999 0\nf 1 2 3\n"},
      {"range.obj", points + "f 1 2 4\n"},
      {"zero.obj", points + "f 0 1 2\n"},
      {"negative.obj", points + "f -1 -2 -4\n"},
      {"two.obj", points + "f 1 2\n"},
      {"cut.obj", points + "v 0 0"},
      {"word.obj", points + "f 1 two 3\n"},
      {"empty.ply", ""},
      {"cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"},
      {"empty.off", ""},
      {"cut.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n"},
      {"empty.stl", ""},
      {"cut.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"},
      {"scene.xyz", square},
      {"scene", square},
      {"empty.wp", ""},
      {"random.wp", "sightline-winged-pair 1\n\xff\x01 banana\n"},
      {"other.wp", "sightline-winged-pair 2\n"},
  };
  write(folder / "good.cameras", camera);
  for (const auto& [name, text] : cases) {
    write(folder / name, text);
    if (!name.ends_with(".wp")) expect_refused(folder, {"build", name, "-o", "x.wp"}, name);
    expect_refused(folder, {"trace", name, "--cameras", "good.cameras", "-o", "maps"}, name);
  }
  expect_refused(folder, {"build", "missing.obj", "-o", "x.wp"}, "missing.obj");
  std::filesystem::create_directory(folder / "folder.obj");
  expect_refused(folder, {"build", "folder.obj", "-o", "x.wp"}, "folder.obj");
  EXPECT_FALSE(std::filesystem::exists(folder / "maps"));
}

TEST(BadInput, WingedPairCutShort) {
  const auto folder = fresh_folder("cut");
  write(folder / "good.obj", square);
  write(folder / "good.cameras", camera);
  ASSERT_EQ(run(folder, {"build", "good.obj", "-o", "good.wp"}).code, 0);
  const std::string whole = read(folder / "good.wp");
  for (int k = 1; k < 16; ++k) {
    write(folder / "cut.wp", whole.substr(0, whole.size() * static_cast<std::size_t>(k) / 16));
    expect_refused(folder, {"trace", "cut.wp", "--cameras", "good.cameras", "-o", "maps"}, "cut.wp");
  }
}

TEST(BadInput, Cameras) {
  const auto folder = fresh_folder("cameras");
  write(folder / "good.obj", square);
  const std::vector<std::pair<std::string, std::string>> cases{
      {"empty.cameras", ""},
      {"comment.cameras", "# none\n"},
      {"ten.cameras", "0 0 3  0 0 -1  0 1 0  60\n"},
      {"twelve.cameras", "0 0 3  0 0 -1  0 1 0  60 1 1\n"},
      {"word.cameras", "0 0 3  0 0 down  0 1 0  60 1\n"},
      {"nan.cameras", "0 0 nan  0 0 -1  0 1 0  60 1\n"},
      {"nowhere.cameras", "0 0 3  0 0 0  0 1 0  60 1\n"},
      {"parallel.cameras", "0 0 3  0 0 -1  0 0 1  60 1\n"},
      {"angle.cameras", "0 0 3  0 0 -1  0 1 0  180 1\n"},
      {"aspect.cameras", "0 0 3  0 0 -1  0 1 0  60 0\n"},
      {"second.cameras", std::string(camera) + "0 0 3\n"},
  };
  for (const auto& [name, text] : cases) {
    write(folder / name, text);
    expect_refused(folder, {"trace", "good.obj", "--cameras", name, "-o", "maps"}, name);
  }
  expect_refused(folder, {"trace", "good.obj", "--cameras", "missing.cameras", "-o", "maps"}, "missing.cameras");
  EXPECT_FALSE(std::filesystem::exists(folder / "maps"));
}

TEST(BadInput, PlacesWhereNothingCanBeWritten) {
  const auto folder = fresh_folder("places");
  write(folder / "good.obj", square);
  write(folder / "good.cameras", camera);
  write(folder / "file", "no folder\n");
  expect_refused(folder, {"model", "rooms", "-o", "file/x.obj"}, "file/x.obj");
  expect_refused(folder, {"build", "-q", "good.obj", "-o", "file/x.wp"}, "file/x.wp");
  expect_refused(folder, {"build", "-q", "good.obj", "-o", "none/x.wp"}, "none/x.wp");
  expect_refused(folder, {"trace", "-q", "good.obj", "--cameras", "good.cameras", "-o", "file"}, "file");
  expect_refused(folder, {"trace", "-q", "good.obj", "--cameras", "good.cameras", "-o", "file/maps"}, "file/maps");
}

}  // namespace
}  // namespace sightline::test
