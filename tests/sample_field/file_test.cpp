// Field files.
#include "sample/field_file.hpp"
#include "scene/errors.hpp"
#include "tests/sample_field/scenes.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace sightline::test {
namespace {

std::filesystem::path file_of(const std::string& bytes) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sightline_test.field";
  std::ofstream(file, std::ios::binary) << bytes;
  return file;
}

Field made() {
  const Scene scene = model_scene("city");
  Field field =
      build_field(scene, slabs_within(FieldBox{{-4, -4, 1}, {4, 4, 6}}), grid_of(scene), {{3, 3, 6, 6}, 3, 3, true, 1});
  field.cells = "object:6";
  return field;
}

/// With the right checksum, so that what is said inside is looked at.
std::string signed_again(std::string bytes) {
  bytes.resize(bytes.size() - 8);
  const std::uint64_t sum = field_checksum(bytes);
  for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<char>(sum >> (8 * k) & 0xff));
  return bytes;
}

std::string refusal(const std::string& bytes) {
  try {
    read_field(file_of(bytes));
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FieldFile, ReadsBackWhatWasWritten) {
  const Field field = made();
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sightline_round.field";
  write_field(file, field);
  const Field back = read_field(file);
  EXPECT_EQ(back.source, field.source);
  EXPECT_EQ(back.cells, "object:6");
  EXPECT_EQ(back.ids, 3u);
  EXPECT_EQ(back.rays, 3u);
  EXPECT_EQ(back.slabs, field.slabs);
  EXPECT_EQ(back.partition.of, field.partition.of);
  EXPECT_EQ(back.partition.count, field.partition.count);
  EXPECT_EQ(back.first, field.first);
  EXPECT_EQ(back.members, field.members);
  EXPECT_EQ(back.levels, field.levels);
  EXPECT_EQ(field_bytes(back), field_bytes(field));
}

TEST(FieldFile, IsSmallerThanTheArray) {
  const Scene scene = model_scene("city");
  const Field field =
      build_field(scene, slabs_around(box_of(scene)), grid_of(scene, 2), {{6, 6, 24, 24}, 5, 3, false, 2});
  EXPECT_EQ(field_array_bytes(field), 4u * 5 * 6 * 6 * 6 * 24 * 24);
  EXPECT_LT(field_bytes(field).size(), field_array_bytes(field) / 5);
  EXPECT_LT(field_memory_bytes(field), field_array_bytes(field));
}

TEST(FieldFile, NothingButAFieldIsRead) {
  const std::string good = field_bytes(made());
  EXPECT_EQ(refusal(good), "");
  EXPECT_NE(refusal("").find("is no field file"), std::string::npos);
  EXPECT_NE(refusal("sightline-field 2\n" + good.substr(18)).find("is no field file"), std::string::npos);
  EXPECT_NE(refusal("sightline-field 1\n").find("cut short"), std::string::npos);
  EXPECT_NE(refusal(good.substr(0, good.size() - 1)).find("damaged or cut short"), std::string::npos);
  EXPECT_NE(refusal(good + "x").find("damaged"), std::string::npos);
  EXPECT_NE(refusal(signed_again(good.substr(0, good.size() - 8) + "x" + good.substr(good.size() - 8)))
                .find("after the field's end"),
            std::string::npos);
  EXPECT_THROW(read_field("/nonexistent/x.field"), InputError);
  EXPECT_THROW(read_field(::testing::TempDir()), InputError);
}

TEST(FieldFile, BecomesNoMoreThanSoManyTimesItsSize) {
  Field field;  // in which nothing is seen
  field.slabs = slabs_around({{0, 0, 0}, {1, 1, 1}});
  field.slabs.resize(1);
  field.first = {0, 0};
  field.levels.push_back({{1, 1, 64, 64}, std::vector<std::uint32_t>(4096)});
  const std::string good = field_bytes(field), run("\0\x80\x08", 3), runs = run + run + run + run;
  ASSERT_EQ(good.substr(good.size() - 8 - runs.size(), runs.size()), runs);
  EXPECT_EQ(read_field(file_of(good)).levels, field.levels);
  const std::string one_run("\0\x80\x20", 3);
  EXPECT_NE(refusal(signed_again(good.substr(0, good.size() - 8 - runs.size()) + one_run + "12345678"))
                .find("length of a run: 4096, at most 1024"),
            std::string::npos);
}

TEST(FieldFile, EveryPrefixAndEveryByteMayLie) {
  const std::string good = field_bytes(made());
  std::mt19937_64 random(7);
  std::size_t refused = 0;
  for (std::size_t length = 18; length < good.size() - 8; length += 1 + length / 40) {
    EXPECT_NE(refusal(signed_again(good.substr(0, length) + "12345678")), "") << length;
  }
  for (std::size_t k = 18; k < good.size() - 8; k += k < 900 ? 1 : 97) {
    std::string bad = good;
    bad[k] = static_cast<char>(bad[k] ^ static_cast<char>(1 + random() % 255));
    EXPECT_NE(refusal(bad), "") << k;  // the checksum
    // With a checksum that fits it is refused, or it is a field: then it is written as one that reads the same.
    const std::filesystem::path file = file_of(signed_again(bad));
    try {
      const Field field = read_field(file);
      EXPECT_EQ(read_field(file_of(field_bytes(field))).levels, field.levels);
      FieldQuery(field, {.pixels = 8, .filter = FieldFilter::uvst, .mipmap = true}).mark(Camera{{0, 0, 2}});
    } catch (const InputError& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    }
  }
  EXPECT_GT(refused, 20u);
}

}  // namespace
}  // namespace sightline::test
