// Scene files in all formats, and what is refused.
#include "map_edit.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace sightline::verify {
namespace {

bool same(const Soup& a, const Soup& b) {
  return a.vertices == b.vertices && a.first == b.first && a.corners == b.corners;
}

const std::string off = R"(OFF # a comment
4 2 0

0 0.5 -1e-3
1 0 0
# another
0 1 0
0 0 1
3 0 1 2  255 0 0
4 3 2 1 0
)";
const std::string obj = R"(# a comment
mtllib x.mtl
v 0 0.5 -1e-3 0.1 0.2 0.3
v +1 0 0
v 0 1 0
v 0 0 1
o thing
f 1/1/1 2//2 3
f -1 3 \
  2 1
)";

TEST(Reading, FormatsAgree) {
  const Soup expected = read_obj("a.obj", obj);
  EXPECT_EQ(expected.vertices[0], (std::array{0.0, 0.5, -1e-3}));
  EXPECT_EQ(expected.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 2, 1, 0}));
  EXPECT_TRUE(same(expected, read_off("a.off", off)));
  const std::string ply =
      "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty double x\nproperty float y\nproperty double z\n"
      "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0.5 -1e-3 7\n1 0 0 7\n0 1 0 7\n0 0 1 7\n3 0 1 2\n4 3 2 1 0\n";
  EXPECT_TRUE(same(expected, read_ply("a.ply", ply)));
}

template <class T>
void put(std::string& out, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) out += raw[big ? sizeof(T) - 1 - i : i];
}

TEST(Reading, BinaryPlyOfBothByteOrders) {
  for (const bool big : {false, true}) {
    std::string ply = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 3\nproperty float x\nproperty double y\nproperty short z\n"
                      "element face 1\nproperty list uint8 uint vertex_index\nproperty float quality\nend_header\n";
    for (int i = 0; i < 3; ++i) {
      put(ply, static_cast<float>(i) / 4, big);
      put(ply, 0.1 * i, big);
      put(ply, static_cast<std::int16_t>(-i * i), big);
    }
    put(ply, std::uint8_t{3}, big);
    for (std::uint32_t i = 0; i < 3; ++i) put(ply, i, big);
    put(ply, 1.0F, big);
    const Soup soup = read_ply("a.ply", ply);
    ASSERT_EQ(soup.vertices.size(), 3U);
    EXPECT_EQ(soup.vertices[2], (std::array{0.5, 0.2, -4.0}));
    EXPECT_EQ(soup.corners, (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_THROW(read_ply("a.ply", std::string_view(ply).substr(0, ply.size() - 1)), InputError);
  }
}

TEST(Reading, StlKeepsEachTrianglesOwnVertices) {
  const std::string facet =
      " facet normal 0 0 1\n outer loop\n vertex 0 0 0\n vertex 1 0 0\n vertex 0 0.1 0\n endloop\n endfacet\n";
  const Soup ascii = read_stl("a.stl", "solid x\n" + facet + facet + "endsolid x\n");
  EXPECT_EQ(ascii.vertices.size(), 6U);
  EXPECT_EQ(ascii.corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(ascii.vertices[5][1], 0.1);
  EXPECT_THROW(read_stl("a.stl", "solid x\n" + facet), InputError);
  std::string binary(80, ' ');
  put(binary, std::uint32_t{1}, false);
  for (int i = 0; i < 12; ++i) put(binary, static_cast<float>(i), false);
  put(binary, std::uint16_t{0}, false);
  const Soup soup = read_stl("a.stl", binary);
  EXPECT_EQ(soup.vertices[2], (std::array{9.0, 10.0, 11.0}));
  EXPECT_THROW(read_stl("a.stl", binary + "x"), InputError);
}

TEST(Reading, BadScenesAreRefusedInOneLine) {
  const auto refused = [](const char* text) {
    try {
      check_soup("a.obj", read_obj("a.obj", text));
    } catch (const InputError& error) {
      return std::string(error.what()).find('\n') == std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_TRUE(refused(""));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\n"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -4\n"));
  EXPECT_TRUE(refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n"));
  EXPECT_TRUE(refused("v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_TRUE(refused("v 0 0 1e999\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  EXPECT_TRUE(refused("v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
  for (const std::size_t cut : {0U, 3U, 10U, 40U, 60U}) {
    EXPECT_THROW(read_off("a.off", std::string_view(off).substr(0, cut)), InputError) << cut;
  }
}

TEST(Reading, ScenesThatAreTornAnywhereNeverCrash) {
  const auto quietly = [](auto&& read) {
    try {
      read();
    } catch (const InputError&) {
    }
  };
  std::uint32_t state = 1;
  for (int round = 0; round < 6000; ++round) {
    std::string text = round % 2 == 0 ? obj : off;
    for (int k = 0; k < 3; ++k) {
      state = state * 1664525 + 1013904223;
      text[(state >> 8) % text.size()] = static_cast<char>(state >> 24);
    }
    quietly([&] { check_soup("a", read_obj("a", text)); });
    quietly([&] { check_soup("a", read_off("a", text)); });
    quietly([&] { check_soup("a", read_stl("a", "solid" + text)); });
    quietly([&] { check_soup("a", read_ply("a", "ply\nformat ascii 1.0\n" + text)); });
  }
}

}  // namespace
}  // namespace sightline::verify
