// Damaged and hostile winged-pair files: one clear line, never a crash.
#include <gtest/gtest.h>

#include <regex>

#include "scene/read.hpp"
#include "tests/oracle/scenes.hpp"
#include "tests/winged_pair/file_samples.hpp"
#include "tests/winged_pair/samples.hpp"
#include "winged_pair/file.hpp"

namespace sightline::testing {
namespace {

std::string sample() {
  const TemporaryFile file;
  const Scene scene = crossing_scene();
  write_wp(file.path(), scene, build(scene));
  return content(file.path());
}

/// What read_wp says to a text: the error's message after the file's name, or "" where it is taken.
std::string refusal(const std::string& text) {
  const TemporaryFile file;
  write_file(file.path(), text);
  try {
    read_wp(file.path());
  } catch (const InputError& error) {
    const std::string what = error.what(), name = file.path().string();
    EXPECT_EQ(what.substr(0, name.size() + 1), name + ":");
    EXPECT_EQ(what.find('\n'), std::string::npos);
    return what.substr(std::min(what.size(), name.size() + 1));
  }
  return "";
}

std::string replaced(const std::string& pattern, const std::string& by) {
  static const std::string text = sample();
  const std::string result =
      std::regex_replace(text, std::regex(pattern, std::regex::multiline), by, std::regex_constants::format_first_only);
  EXPECT_NE(result, text) << pattern;
  return result;
}

TEST(WingedPairFileDamage, IsNamed) {
  const struct {
    const char *pattern, *by, *message;
  } cases[] = {
      {"^sightline-winged-pair 1", "sightline-winged-pair 2", "1: header: not version 1"},
      {"^sightline-winged-pair", "ply", "1: header: not a winged-pair file"},
      {"^pairs .*", "pairs 4000000000", "11: pairs: count 4000000000 out of range"},
      {"^pairs .*", "pairs -1", "11: pairs: count -1 out of range"},
      {"^planes .*", "planes 5", "plane"},
      {"^cells .*", "cells 7 8", "10: cells: '8' at the end of the line"},
      {"^faces .*", "edges 8", "9: faces: 'edges' where 'faces' should stand"},
      {"^source .*", "source x", "source: not a string in quotes"},
      {"^source .*", "source \"\\q\"", "source: bad escape"},
      {"^snap none", "snap -1", "snap: "},
      {"^opaque_from both", "opaque_from back", "opaque_from: neither front nor both"},
      {"^v 0 0 2", "v 0 nan 2", "vertex of the scene 0: "},
      {"^v 0 0 2", "v 0 0", "vertex of the scene 0: coordinate is missing"},
      {"^f 0 1 2 3", "f 0 1 2 15", "polygon 0: corner 15 out of range"},
      {"^f 0 1 2 3", "f 0 1", "polygon 0"},
      {"^plane polygon 0 .*", "plane polygon 0 0 1 1", "its points do not define a plane"},
      {"^plane polygon 0 ", "plane polygon 1 ", "not the plane of its polygon"},
      {"^plane polygon 1 .*", "plane polygon 1 0 1 2", "is the same as plane"},
      {"^plane x [^\n]*", "plane x grid 1e5", "no integer after 'grid'"},
      {"^plane x [^\n]*", "plane x 0.3", "plane"},
      {"^plane x [^\n]*", "plane w 3", "is none of"},
      {"^label 0", "label 99", "surface 99 out of range"},
      {"^vertex [0-9]+ ([0-9]+) [0-9]+", "vertex $1 $1 $1", "vertex 0: its planes do not meet in one point"},
      {"^vertex .*", "vertex 1 2 3 99999", "vertex 0: edge 99999 out of range"},
      {"^edge [0-9]+", "edge x", "edge 0: 'x' is not an integer"},
      {"^edge ([0-9]+) [0-9]+", "edge $1 $1", "does not end in it"},
      {"^face [0-9-]+ [0-9-]+", "face - -", "face 0: the same cell on both sides"},
      {"^face [0-9-]+ [0-9-]+", "face -1 0", "face 0: cell out of range"},
      {"^cell .*", "cell 1000000", "cell 0: face 1000000 out of range"},
      {"^pair ([0-9]+ [0-9]+) ([0-9]+) ([0-9]+)", "pair $1 $3 $2", "does not lead back"},
      {"^(pair .*) [01]$", "$1 2", "pair 0: direction 2 out of range"},
      {"^box .*", "box 0 1 2 3 4 5", "box: plane 0 is not along the box"},
      {"^(box .*)", "$1\n$1", "end: more than the counts say"},
      {"^box .*", "", "box: missing"},
      {"^box .*\n", "", "box: the file ends before it"},
  };
  for (const auto& c : cases) {
    const std::string message = refusal(replaced(c.pattern, c.by));
    EXPECT_NE(message.find(c.message), std::string::npos) << c.pattern << " -> " << c.by << ": " << message;
  }
}

TEST(WingedPairFileDamage, ObjectsForAllPolygonsOrNone) {
  EXPECT_NE(refusal(replaced("^f 0 1 2 3", "f 0 1 2 3 / -")).find("polygon 1: object missing"), std::string::npos);
  EXPECT_NE(refusal(replaced("^f 4 5 6 7", "f 4 5 6 7 / -")).find("polygon 1: object named"), std::string::npos);
}

TEST(WingedPairFileDamage, Missing) {
  EXPECT_THROW(read_wp("no/such/file.wp"), InputError);
  EXPECT_THROW(read_wp(std::filesystem::temp_directory_path()), InputError);
  EXPECT_NE(refusal(""), "");
}

TEST(WingedPairFileDamage, TruncatedAnywhere) {
  const std::string text = sample();
  for (std::size_t length = 0; length + 1 < text.size(); length += 1 + length / 97) {
    EXPECT_NE(refusal(text.substr(0, length)), "") << length;
  }
}

TEST(WingedPairFileDamage, AnyByteChanged) {
  const std::string text = sample();
  Random random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = text;
    for (int k = random.between(1, 3); k > 0; --k) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      switch (random.below(4)) {
        case 0:
          damaged[at % damaged.size()] = static_cast<char>(random.below(256));
          break;
        case 1:
          damaged[at % damaged.size()] = static_cast<char>('0' + random.below(10));
          break;
        case 2:
          damaged.erase(at % damaged.size(), static_cast<std::size_t>(random.between(1, 40)));
          break;
        default:
          damaged.insert(at % damaged.size(), text.substr(at, static_cast<std::size_t>(random.between(1, 40))));
      }
    }
    refusal(damaged);
  }
}

TEST(WingedPairFileDamage, RandomBytes) {
  Random random(11);
  for (int round = 0; round < 200; ++round) {
    std::string bytes = round % 2 == 0 ? "" : "sightline-winged-pair 1\n";
    for (int k = random.below(400); k > 0; --k) bytes += static_cast<char>(random.below(256));
    EXPECT_NE(refusal(bytes), "");
  }
}

}  // namespace
}  // namespace sightline::testing
