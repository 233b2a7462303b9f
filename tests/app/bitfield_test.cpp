// The commands `bitfield build` and `bitfield query`, and the methods of `compare`.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace sightline::test {
namespace {

std::filesystem::path folder_with_city(const std::string& test) {
  const auto folder = fresh_folder(test);
  EXPECT_EQ(run(folder, {"model", "city", "--polygons", "300", "-o", "m.obj", "-q"}).code, 0);
  write(folder / "c.cameras", first_lines(read(folder / "m.cameras"), 3));
  return folder;
}

Ended bitfield(const std::filesystem::path& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "bitfield");
  return run(folder, arguments);
}

/// Lines "camera,polygon".
std::set<std::string> lines_of(const std::string& csv) {
  std::set<std::string> out;
  std::istringstream in(csv);
  std::string line;
  EXPECT_TRUE(std::getline(in, line) && line == "camera,polygon");
  while (std::getline(in, line)) EXPECT_TRUE(out.insert(line).second);
  return out;
}

/// What `trace` lists as seen.
std::set<std::string> traced(const std::filesystem::path& folder, const std::string& cameras) {
  EXPECT_EQ(run(folder, {"trace", "m.obj", "--cameras", cameras, "-o", "maps", "--format", "csv", "-q"}).code, 0);
  std::istringstream in(read(folder / "maps/visibility.csv"));
  std::set<std::string> out;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) out.insert(line.substr(0, line.find(',', line.find(',') + 1)));
  return out;
}

TEST(BitfieldCommand, ExactSamplesGiveTheMapsPolygonsAtTheirOwnViewpoints) {
  const auto folder = folder_with_city("bitfield_exact");
  Ended ended = bitfield(folder, {"build", "m.obj", "-o", "e.bitfield", "--exact", "--samples", "8", "--viewpoints",
                                  "v.cameras", "--report", "b.json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto built = nlohmann::json::parse(read(folder / "b.json"));
  EXPECT_EQ(built["bitfield"]["samples"], 8);
  EXPECT_EQ(built["bitfield"]["bits"], built["scene"]["polygons"]);
  EXPECT_EQ(built["bitfield"]["faces"], 12);
  EXPECT_LT(built["bitfield"]["compressed_bytes"], 8 * 1000);
  ended =
      bitfield(folder, {"query", "e.bitfield", "--cameras", "v.cameras", "-o", "q.csv", "--scene", "m.obj", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto asked = nlohmann::json::parse(ended.out);
  ASSERT_EQ(asked["cameras"].size(), 8u);
  EXPECT_EQ(asked["cameras"][3]["samples"], nlohmann::json({3}));
  EXPECT_TRUE(asked["cameras"][3]["face"].is_null());
  EXPECT_GT(asked["cameras"][3]["polygons"], 50);
  EXPECT_EQ(lines_of(read(folder / "q.csv")), traced(folder, "v.cameras"));
  // The same viewpoints given by the user make the same file.
  ASSERT_EQ(bitfield(folder, {"build", "m.obj", "-o", "u.bitfield", "--exact", "--cameras", "v.cameras"}).code, 0);
  EXPECT_EQ(read(folder / "u.bitfield"), read(folder / "e.bitfield"));
}

TEST(BitfieldCommand, TheSameBytesInAnyNumberOfThreadsAndForm) {
  const auto folder = folder_with_city("bitfield_threads");
  for (const char* threads : {"1", "4"}) {
    const std::string name = std::string("x") + threads;
    ASSERT_EQ(bitfield(folder, {"build", "m.obj", "-o", name, "--samples", "14", "--pixels", "100", "--fill", "1",
                                "--threads", threads, "-q"})
                  .code,
              0);
    ASSERT_EQ(
        bitfield(folder, {"query", name, "--cameras", "c.cameras", "-o", name + ".csv", "--threads", threads, "-q"})
            .code,
        0);
  }
  EXPECT_EQ(read(folder / "x1"), read(folder / "x4"));
  const std::string csv = read(folder / "x1.csv");
  EXPECT_EQ(csv, read(folder / "x4.csv"));
  EXPECT_GT(lines_of(csv).size(), 100u);
  for (const char* form : {"plain", "hierarchical", "compressed"}) {
    ASSERT_EQ(bitfield(folder, {"query", "x1", "--cameras", "c.cameras", "-o", "f.csv", "--form", form}).code, 0);
    EXPECT_EQ(read(folder / "f.csv"), csv) << form;
  }
  std::set<std::string> before;
  for (const char* neighbours : {"1", "3", "6"}) {
    ASSERT_EQ(bitfield(folder, {"query", "x1", "--cameras", "c.cameras", "-o", "n.csv", "--form", "plain",
                                "--neighbours", neighbours})
                  .code,
              0);
    const std::set<std::string> lines = lines_of(read(folder / "n.csv"));
    EXPECT_TRUE(std::ranges::includes(lines, before));
    before = lines;
  }
}

TEST(BitfieldCommand, PatchesAndTransparentPolygons) {
  const auto folder = folder_with_city("bitfield_patches");
  const std::vector<std::string> common{"--samples", "6", "--pixels", "80", "-q"};
  const auto build = [&](const std::string& name, std::vector<std::string> more) {
    more.insert(more.begin(), {"build", "m.obj", "-o", name});
    more.insert(more.end(), common.begin(), common.end());
    const Ended ended = bitfield(folder, more);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(bitfield(folder, {"query", name, "--cameras", "c.cameras", "-o", name + ".csv", "--scene", "m.obj"}).code,
              0);
    return lines_of(read(folder / (name + ".csv")));
  };
  const auto plain = build("plain", {});
  EXPECT_TRUE(std::ranges::includes(build("patched", {"--patch", "8"}), plain));
  EXPECT_LT(read(folder / "patched").size(), read(folder / "plain").size());
  write(folder / "list.txt", "0 1 2 # some\n299\n");
  const auto listed = build("listed", {"--transparent-list", "list.txt"});
  for (const char* line : {"0,0", "1,1", "2,2", "0,299"}) EXPECT_TRUE(listed.contains(line)) << line;
  // By the name of an object or of a material.
  std::string text = read(folder / "m.obj"), dyed;
  std::istringstream in(text);
  std::size_t faces = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("f ")) {
      if (faces == 10) dyed += "usemtl clear glass\n";
      if (faces == 13) dyed += "usemtl brick\n";
      ++faces;
    }
    dyed += line + "\n";
  }
  write(folder / "m.obj", dyed);
  const auto glass = build("glass", {"--transparent", "clear glass"});
  for (const char* line : {"0,10", "0,11", "0,12", "2,12"}) EXPECT_TRUE(glass.contains(line)) << line;
  EXPECT_GE(glass.size(), plain.size());
  const std::size_t at = text.find("\no ") == std::string::npos ? text.find("\ng ") : text.find("\no ");
  const std::string object = text.substr(at + 3, text.find('\n', at + 1) - at - 3);
  EXPECT_GE(build("object", {"--transparent", object}).size(), plain.size());
}

TEST(BitfieldCommand, RefusesWhatItCannotDo) {
  const auto folder = folder_with_city("bitfield_bad");
  const auto expect = [&](int code, const std::vector<std::string>& arguments, const std::string& says) {
    const Ended ended = bitfield(folder, arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_NE(ended.err.find(says), std::string::npos) << ended.err;
  };
  ASSERT_EQ(bitfield(folder, {"build", "m.obj", "-o", "x", "--samples", "6", "--pixels", "20", "-q"}).code, 0);
  ASSERT_EQ(
      bitfield(folder, {"build", "m.obj", "-o", "p", "--samples", "6", "--pixels", "20", "--patch", "3", "-q"}).code,
      0);
  const std::vector<std::string> build{"build", "m.obj", "-o", "y", "-q"};
  const auto with = [](std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  expect(2, {}, "subcommand");
  expect(2, with(build, {"--samples", "3"}), "--samples");
  expect(2, with(build, {"--exact", "--pixels", "9"}), "--pixels");
  expect(2, with(build, {"--fill", "some"}), "--fill some: a number of rounds, or all");
  expect(2, with(build, {"--cameras", "c.cameras", "--samples", "9"}), "--samples");
  expect(3, with(build, {"--cameras", "c.cameras"}), "c.cameras: the viewpoints do not surround the centre");
  expect(3, with(build, {"--transparent", "unicorn"}), "no polygon has an object or material 'unicorn'");
  write(folder / "list.txt", "1\n300\n");
  expect(3, with(build, {"--transparent-list", "list.txt"}), "list.txt:2: polygon: 300 is out of range");
  EXPECT_FALSE(std::filesystem::exists(folder / "y"));
  const std::vector<std::string> query{"--cameras", "c.cameras", "-o", "q.csv", "-q"};
  expect(3, with({"query", "missing"}, query), "missing");
  expect(3, with({"query", "m.obj"}, query), "m.obj:1: header: not a bitfield file");
  expect(2, with({"query", "p"}, query), "--scene: needed");
  expect(2, with({"query", "x", "--neighbours", "1"}, query), "--neighbours 1");
  expect(2, with({"query", "x", "--neighbours", "4"}, query), "--neighbours");
  expect(3, with({"query", "x", "--scene", "m.obj", "--one-sided"}, query), "x: samples of another scene than m.obj");
  std::string text = read(folder / "x");
  write(folder / "x", text.substr(0, text.size() / 2));
  expect(3, with({"query", "x"}, query), "x:");
  EXPECT_FALSE(std::filesystem::exists(folder / "q.csv"));
}

TEST(BitfieldCommand, IsAMethodOfCompare) {
  const auto folder = folder_with_city("bitfield_compare");
  ASSERT_EQ(
      bitfield(folder, {"build", "m.obj", "-o", "x", "--samples", "6", "--viewpoints", "v.cameras", "--pixels", "9"})
          .code,
      0);
  const Ended ended = run(folder, {"compare", "m.obj", "--cameras", "v.cameras", "--methods",
                                   "bitfield:6,bitfield-exact:6,bitfield-exact:25", "-o", "out"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  const auto json = nlohmann::json::parse(read(folder / "out/compare.json"));
  // From the viewpoints themselves nothing is missed, and with exact samples nothing more is given.
  EXPECT_LT(json["methods"][0]["wrong_area"], 1e-3);
  EXPECT_GT(json["methods"][0]["false"], 0);
  EXPECT_EQ(json["methods"][1]["missed"], 0);
  EXPECT_EQ(json["methods"][1]["false"], 0);
  EXPECT_EQ(json["methods"][1]["wrong_area"], 0);
  for (const char* bad : {"bitfield", "bitfield:3", "bitfield:25:4", "bitfield-exact:", "bitfield:25:"}) {
    const Ended refused = run(folder, {"compare", "m.obj", "--cameras", "v.cameras", "--methods", bad, "-o", "no"});
    EXPECT_EQ(refused.code, 2) << bad;
    EXPECT_NE(refused.err.find("wants a number of samples from 4 to 16384"), std::string::npos) << refused.err;
  }
}

}  // namespace
}  // namespace sightline::test
