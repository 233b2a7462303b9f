// `clip --photos`: the drawings that `trace` makes serve as photographs.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace sightline::test {
namespace {

using Arguments = std::vector<std::string>;

std::filesystem::path folder_with_photos(const std::string& test, int cameras) {
  const auto folder = fresh_folder(test);
  EXPECT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  write(folder / "c.cameras", first_lines(read(folder / "m.cameras"), cameras));
  EXPECT_EQ(run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "photos", "--format", "png", "-q"}).code, 0);
  return folder;
}

Ended clip(const std::filesystem::path& folder, const Arguments& more) {
  Arguments arguments{"clip", "m.obj", "--cameras", "c.cameras", "-q", "--photos", "photos"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(folder, arguments);
}

TEST(Photos, ObjAndImagesStandBesideThePly) {
  const auto folder = folder_with_photos("photos_good", 3);
  ASSERT_EQ(clip(folder, {"-o", "a.ply", "--page", "700", "--report", "r.json", "--density", "0.5"}).code, 0);
  const auto photos = nlohmann::json::parse(read(folder / "r.json"))["photos"];
  EXPECT_EQ(photos["guard"], 1);
  std::size_t pieces = 0;
  for (const auto& [source, count] : photos["pieces"].items()) pieces += count.get<std::size_t>();
  EXPECT_EQ(nlohmann::json::parse(read(folder / "r.json"))["clip"]["pieces"], pieces);
  EXPECT_GT(photos["pieces"]["best"], 0);
  EXPECT_GT(photos["texels"]["direct"], 1000);
  const std::size_t pages = photos["pages"];
  EXPECT_GT(pages, 1u);
  const auto files = files_below(folder);
  const std::string materials = files.at("a.mtl");
  for (std::size_t k = 0; k <= pages; ++k) {
    const std::string name = "a-" + std::to_string(k) + ".png";
    EXPECT_EQ(files.contains(name), k < pages);
    EXPECT_EQ(materials.find("map_Kd " + name + "\n") != std::string::npos, k < pages);
  }
  EXPECT_NE(files.at("a.obj").find("mtllib a.mtl\n"), std::string::npos);
  EXPECT_EQ(run(folder, {"trace", "a.obj", "--cameras", "c.cameras", "-o", "maps", "-q"}).code, 0);

  const Arguments again{"-o", "b.ply", "--page", "700", "--density", "0.5", "--threads", "3", "--buffer", "16"};
  ASSERT_EQ(clip(folder, again).code, 0);
  EXPECT_EQ(read(folder / "b-0.png"), files.at("a-0.png"));
  EXPECT_EQ(read(folder / "b.ply"), files.at("a.ply"));
}

TEST(Photos, BadPhotographsAreRefusedBeforeAnythingIsWritten) {
  const auto folder = folder_with_photos("photos_bad", 2);
  const std::string photo = read(folder / "photos" / "0001.png");
  const auto before = files_below(folder);
  const auto expect = [&](int code, const Arguments& arguments, const std::string& says) {
    const Ended ended = clip(folder, arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
  };
  const Arguments output{"-o", "x.ply"};
  std::filesystem::remove(folder / "photos" / "0001.png");
  expect(3, output, "photos/0001.png");
  write(folder / "photos" / "0001.png", "");
  expect(3, output, "photos/0001.png");
  write(folder / "photos" / "0001.png", photo.substr(0, photo.size() / 2));
  expect(3, output, "photos/0001.png: no whole PNG image");
  write(folder / "photos" / "0001.png", photo);
  EXPECT_EQ(files_below(folder), before);

  const std::string cameras = read(folder / "c.cameras");
  write(folder / "c.cameras", first_lines(cameras, 1) + "2 3 1.6  0 1 0  0 0 1  60 1.5\n");
  expect(3, output, "photos/0001.png: 1024 x 768 pixels do not fit the camera's aspect of 1.5");
  write(folder / "c.cameras", cameras);

  expect(2, {"-o", "m.ply"}, "m.obj is written beside it and would replace the scene");
  expect(2, {"-o", "x.ply", "--guard", "-1"}, "--guard");
  expect(2, {"-o", "x.ply", "--density", "0"}, "--density");
  EXPECT_EQ(files_below(folder), before);
  const Ended alone = run(folder, {"clip", "m.obj", "--cameras", "c.cameras", "-o", "x.ply", "--guard", "2"});
  EXPECT_EQ(alone.code, 2);
  EXPECT_TRUE(one_complaint(alone.err)) << alone.err;
}

}  // namespace
}  // namespace sightline::test
