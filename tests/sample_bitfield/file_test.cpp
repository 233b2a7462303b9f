// The file: there and back, and what is refused.
#include "sample/bitfield_file.hpp"

#include "sample/bitfield_viewpoints.hpp"
#include "tests/sample_bitfield/bodies.hpp"

#include <gtest/gtest.h>

#include <random>

namespace sightline {
namespace {

using testing::bumpy_ball;
using testing::cameras_of;

BitfieldSamples taken(const Scene& scene, const BitfieldSampling& options) {
  return sample_bitfields(scene, cameras_of(sphere_cameras(scene, 6)), options);
}

std::string complaint(const std::string& text) {
  try {
    parse_bitfield("x.bitfield", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(BitfieldFile, GoesThereAndBack) {
  for (const Scene& scene : {make_scene(bumpy_ball(9)), make_scene(bumpy_ball(7), {"0.01", true})}) {
    for (const bool exact : {false, true}) {
      for (const std::uint32_t patch : {0u, 1u, 9u}) {
        BitfieldSampling options;
        options.exact = exact;
        options.pixels = 77;
        options.patch = patch;
        options.fill_rounds = patch;
        const BitfieldSamples samples = taken(scene, options);
        const std::string text = bitfield_text(samples);
        EXPECT_EQ(parse_bitfield("x", text), samples);
        EXPECT_EQ(bitfield_text(parse_bitfield("x", text)), text);
      }
    }
  }
}

TEST(BitfieldFile, HoldsAnyBits) {
  const Scene scene = make_scene(bumpy_ball(9));
  BitfieldSampling options;
  options.pixels = 50;
  BitfieldSamples samples = taken(scene, options);
  std::mt19937 random(1);
  for (std::size_t k = 0; k < samples.fields.size(); ++k) {
    samples.fields[k] = IdBitfield(scene.polygon_count());
    for (std::uint32_t p = 0; p < scene.polygon_count(); ++p) {
      if (random() % 5 < k) samples.fields[k].set(p);  // none, some, all
    }
  }
  const std::string text = bitfield_text(samples);
  EXPECT_NE(text.find("\nwords"), std::string::npos);
  EXPECT_NE(text.find("\nruns"), std::string::npos);
  EXPECT_EQ(parse_bitfield("x", text), samples);
}

TEST(BitfieldFile, BecomesNoMoreThanSoManyTimesItsSize) {
  const Scene scene = make_scene(bumpy_ball(5));
  BitfieldSampling options;
  options.pixels = 30;
  BitfieldSamples samples = taken(scene, options);
  samples.polygons = 5000;
  for (IdBitfield& field : samples.fields) field = IdBitfield(5000);
  samples.fields[1].set(1024);
  const std::string text = bitfield_text(samples), runs = "runs 1024 0 1024 0 1024 0 1024 0 904\n";
  EXPECT_EQ(parse_bitfield("x", text), samples);
  EXPECT_NE(complaint(replaced(text, runs, "runs 5000\n")).find("11: sample 0: run 5000 out of range"),
            std::string::npos);
  const std::string most = "4294967294", few = replaced(text, "polygons 5000", "polygons " + most);
  EXPECT_NE(complaint(replaced(replaced(few, "patch 0 5000", "patch 0 " + most), "samples 6", "samples 4"))
                .find("11: sample 0: the file ends within it"),
            std::string::npos);
}

TEST(BitfieldFile, NameOfTheSourceReadsBack) {
  BitfieldSampling options;
  options.pixels = 30;
  BitfieldSamples samples = taken(make_scene(bumpy_ball(5)), options);
  for (const auto& [name, written] : std::vector<std::pair<std::string, std::string>>{
           {"", ""}, {" ", "_"}, {" a b.obj ", "_a b.obj_"}, {"a\tb\n", "a_b_"}, {"\x01", "_"}}) {
    samples.source = name;
    EXPECT_EQ(parse_bitfield("x", bitfield_text(samples)).source, written);
  }
}

TEST(BitfieldFile, RefusesWhatIsWrongInOneLine) {
  const Scene scene = make_scene(bumpy_ball(5));
  BitfieldSampling options;
  options.pixels = 30;
  BitfieldSamples samples = taken(scene, options);
  samples.fields[0] = IdBitfield(scene.polygon_count());  // one run
  const std::string text = bitfield_text(samples), polygons = std::to_string(scene.polygon_count());
  ASSERT_EQ(complaint(text), "");
  const auto expect = [&](const std::string& bad, const std::string& says) {
    const std::string line = complaint(bad);
    EXPECT_NE(line.find(says), std::string::npos) << line;
    EXPECT_EQ(line.find("x.bitfield:"), 0u) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  };
  expect("", "1: header: not a bitfield file");
  expect("sightline-winged-pair 1\n", "1: header: not a bitfield file");
  expect(replaced(text, "bitfield 1", "bitfield 2"), "1: header: not version 1");
  expect(replaced(text, "polygons " + polygons, "polygons 7"), "8: patch: bits " + polygons + " out of range");
  expect(replaced(text, "patch 0 " + polygons, "patch 0 7"), "8: patch: without patches there is a bit a polygon");
  expect(replaced(text, "\nscene ", "\nscene 11"), "4: scene:");
  expect(replaced(text, "\nscene ", "\nscene x"), "is no hexadecimal number");
  expect(replaced(text, "taken pixels", "taken by"), "6: taken: neither exact nor pixels");
  expect(replaced(text, "pixels 30", "pixels 0"), "6: taken: pixels 0 out of range");
  expect(replaced(text, "fill 0", "fill -1"), "7: fill: fill -1 out of range");
  expect(replaced(text, "samples 6", "samples 3"), "9: samples: samples 3 out of range");
  expect(replaced(text, "samples 6", "samples 5"), "20: end: more than the samples");
  expect(replaced(text, "samples 6", "samples 7"), "sample 6: the file ends before it");
  expect(replaced(text, "\nruns " + polygons, "\nruns " + polygons + " 1"), "11: sample 0: run 1 out of range");
  expect(replaced(text, "\nruns " + polygons, "\nruns 5"), "11: sample 0: runs of 5 bits, not " + polygons);
  expect(replaced(text, "\nruns " + polygons, "\nrun " + polygons), "11: sample 0: neither runs nor words");
  expect(replaced(text, "\nruns " + polygons, "\nwords 0"), "11: sample 0: a number is missing");
  expect(replaced(text, "\nruns " + polygons, "\nwords 0 ffffffffffffffff 0"), "11: sample 0: a bit beyond the last");
  expect(replaced(text, "\nruns " + polygons, "\nwords 0 0g"), "11: sample 0: '0g' is no hexadecimal number");
  expect(replaced(text, "camera ", "camera nan "), "10: sample 0: 'nan' is not a finite number");
  expect(text + "more\n", "end: more than the samples");
  const std::string centre =
      text.substr(text.find("centre"), text.find('\n', text.find("centre")) - text.find("centre"));
  expect(replaced(text, centre, "centre 99 0 0"), "samples: the viewpoints do not surround the centre of the scene");
}

TEST(BitfieldFile, SurvivesWhateverIsCutOffOrChanged) {
  const Scene scene = make_scene(bumpy_ball(5));
  BitfieldSampling options;
  options.pixels = 30;
  const std::string text = bitfield_text(taken(scene, options));
  for (std::size_t end = 0; end + 1 < text.size(); end += 1 + end / 50) {
    EXPECT_NE(complaint(text.substr(0, end)), "") << end;
  }
  std::mt19937 random(5);
  std::size_t refused = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string bad = text;
    bad[random() % bad.size()] = static_cast<char>(random() % 256);
    refused += complaint(bad).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 100u);
}

}  // namespace
}  // namespace sightline
