#include "scene/read.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <system_error>

namespace sightline::test {
namespace {

double finite_double() {
  const double x = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  return std::isfinite(x) ? x : 0.1;
}

glm::dvec3 finite_point() { return {finite_double(), finite_double(), finite_double()}; }

bool same_bits(const glm::dvec3& a, const glm::dvec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

RC_GTEST_PROP(WriteObj, ReadingGivesTheSameSoup, ()) {
  PolygonSoup soup;
  soup.source = "round.obj";
  const auto vertices = *rc::gen::inRange<std::uint32_t>(1, 12);
  for (std::uint32_t v = 0; v < vertices; ++v) soup.vertices.push_back(finite_point());
  const auto polygons = *rc::gen::inRange(1, 8);
  const bool named = *rc::gen::arbitrary<bool>();
  for (int p = 0; p < polygons; ++p) {
    for (int k = *rc::gen::inRange(3, 9); k > 0; --k)
      soup.corners.push_back(*rc::gen::inRange<std::uint32_t>(0, vertices));
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    if (!named) continue;
    const auto object = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(soup.objects.size()) + 2);
    if (object == soup.objects.size()) soup.objects.push_back("object " + std::to_string(object) + "#");
    soup.object_of.push_back(object < soup.objects.size() ? object : none);
  }
  if (soup.objects.empty()) soup.object_of.clear();
  const TemporaryFolder folder;
  write_obj(folder.path() / soup.source, soup);
  const PolygonSoup back = read_polygons(folder.path() / soup.source);
  RC_ASSERT(back.vertices.size() == soup.vertices.size());
  for (std::size_t v = 0; v < soup.vertices.size(); ++v) RC_ASSERT(same_bits(back.vertices[v], soup.vertices[v]));
  RC_ASSERT(back.first == soup.first);
  RC_ASSERT(back.corners == soup.corners);
  RC_ASSERT(back.objects == soup.objects);
  RC_ASSERT(back.object_of == soup.object_of);
  RC_ASSERT(back.source == soup.source);
}

RC_GTEST_PROP(WriteCameras, ReadingGivesTheSameCameras, ()) {
  std::vector<CameraLine> lines;
  for (int k = *rc::gen::inRange(1, 5); k > 0; --k) {
    const auto small = [] { return *rc::gen::inRange(-1000000, 1000000) / 1234.5; };
    lines.push_back({finite_point(), {1 + std::abs(small()), small(), small()}, {0, 0, 1}, 60.1, 1.3});
  }
  const TemporaryFolder folder;
  write_cameras(folder.path() / "a.cameras", lines);
  const std::vector<Camera> back = read_cameras(folder.path() / "a.cameras");
  RC_ASSERT(back.size() == lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const CameraLine& c = lines[k];
    const Camera direct = make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect);
    RC_ASSERT(same_bits(back[k].eye, c.eye));
    RC_ASSERT(same_bits(back[k].forward, direct.forward));
    RC_ASSERT(same_bits(back[k].right, direct.right));
    RC_ASSERT(same_bits(back[k].up, direct.up));
  }
}

TEST(WriteFile, ReplacesAndLeavesNothingBeside) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.txt";
  write_file(file, "one");
  write_file(file, std::string(100000, 'x'));
  EXPECT_EQ(TemporaryFolder::read(file), std::string(100000, 'x'));
  write_file(file, "");
  EXPECT_EQ(TemporaryFolder::read(file), "");
  EXPECT_EQ(folder.count(), 1u);
}

TEST(WriteFile, FailsWithoutLeavingAnything) {
  const TemporaryFolder folder;
  EXPECT_THROW(write_file(folder.path() / "missing" / "a.txt", "x"), std::system_error);
  std::filesystem::create_directory(folder.path() / "folder");
  try {
    write_file(folder.path() / "folder", "x");
    FAIL();
  } catch (const std::system_error& e) {
    EXPECT_EQ(e.code(), std::errc::is_a_directory);
    EXPECT_NE(std::string(e.what()).find((folder.path() / "folder").string()), std::string::npos);
  }
  EXPECT_EQ(folder.count(), 1u);
}

TEST(WriteFile, WritesToDevices) { EXPECT_NO_THROW(write_file("/dev/null", "x")); }

TEST(WriteFile, AFullDeviceIsAnError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_THROW(write_file("/dev/full", "x"), std::system_error);
}

}  // namespace
}  // namespace sightline::test
