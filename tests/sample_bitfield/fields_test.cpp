// Bitfields in all their forms, patches, filling in.
#include "sample/bitfield_connect.hpp"
#include "sample/bitfield_forms.hpp"
#include "sample/bitfield_patches.hpp"
#include "sample/bitfield_samples.hpp"
#include "sample/bitfield_viewpoints.hpp"
#include "tests/sample_bitfield/bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

namespace sightline {
namespace {

using testing::bumpy_ball;
using testing::within;

/// From empty to full, in single bits and in stretches.
std::vector<IdBitfield> some_fields(std::uint32_t size, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<IdBitfield> out{IdBitfield(size)};
  for (const unsigned share : {1u, 10u, 50u, 90u, 100u}) {
    IdBitfield single(size), stretches(size);
    bool set = false;
    for (std::uint32_t k = 0; k < size; ++k) {
      if (random() % 100 < share) single.set(k);
      if (random() % 300 == 0) set = random() % 100 < share;
      if (set) stretches.set(k);
    }
    out.push_back(single);
    out.push_back(stretches);
  }
  return out;
}

TEST(BitfieldForms, HoldTheSameBits) {
  for (const std::uint32_t size : {0u, 1u, 63u, 64u, 65u, 4096u, 4097u, 70000u, 300000u}) {
    const std::vector<IdBitfield> fields = some_fields(size, size);
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const IdBitfield& field = fields[i];
      const HierarchicalBitfield hierarchical(field);
      const CompressedBitfield compressed(field);
      EXPECT_EQ(hierarchical.plain(), field) << size << ' ' << i;
      EXPECT_EQ(compressed.plain(), field) << size << ' ' << i;
      EXPECT_EQ(hierarchical.size(), size);
      EXPECT_EQ(compressed.size(), size);
      EXPECT_EQ(hierarchical.count(), field.count());
      EXPECT_EQ(compressed.count(), field.count());
      const std::vector<std::uint32_t> list = field.list();
      EXPECT_EQ(list.size(), field.count());
      EXPECT_TRUE(std::ranges::is_sorted(list));
      IdBitfield again(size);
      for (const std::uint32_t id : list) again.set(id);
      EXPECT_EQ(again, field);
      for (std::uint32_t id = 0; id < size; id += 1 + id / 37) {
        ASSERT_EQ(hierarchical.test(id), field.test(id)) << size << ' ' << i << ' ' << id;
        ASSERT_EQ(compressed.test(id), field.test(id)) << size << ' ' << i << ' ' << id;
      }
      const IdBitfield& other = fields[(i + 3) % fields.size()];
      IdBitfield joined = other, by_hierarchy = other;
      joined.join(field);
      hierarchical.join_into(by_hierarchy);
      EXPECT_EQ(by_hierarchy, joined);
      CompressedBitfield by_roaring(other);
      by_roaring.join(compressed);
      EXPECT_EQ(by_roaring.plain(), joined);
      EXPECT_TRUE(within(field, joined) && within(other, joined));
      IdBitfield turned = field;
      turned.join(other);
      EXPECT_EQ(turned, joined);
    }
  }
}

TEST(BitfieldForms, WhatIsEmptyTakesNoRoom) {
  IdBitfield sparse(1 << 20);
  for (std::uint32_t k = 0; k < 64; ++k) sparse.set(500000 + k);
  EXPECT_LT(HierarchicalBitfield(sparse).bytes(), 100u);
  EXPECT_LT(CompressedBitfield(sparse).bytes(), 100u);
  EXPECT_EQ(sparse.bytes(), std::size_t{1 << 17});
}

TEST(Patches, HoldEveryPolygonOnceAndGiveSupersets) {
  for (const Scene& scene : {make_scene(bumpy_ball(20)), testing::small_model("building", 900)}) {
    for (const std::uint32_t most : {1u, 2u, 7u, 64u, 100000u}) {
      const PolygonPatches patches(scene, most);
      std::set<PolygonId> all;
      for (std::uint32_t k = 0; k < patches.size(); ++k) {
        const auto members = patches.members(k);
        EXPECT_GE(members.size(), 1u);
        EXPECT_LE(members.size(), most);
        EXPECT_TRUE(std::ranges::is_sorted(members));
        for (const PolygonId p : members) {
          EXPECT_TRUE(all.insert(p).second);
          EXPECT_EQ(patches.patch_of(p), k);
        }
      }
      EXPECT_EQ(all.size(), scene.polygon_count());
      EXPECT_LE(patches.size(), scene.polygon_count() / std::max(1u, (most + 1) / 2) + 6);
      std::vector<IdBitfield> fields = some_fields(scene.polygon_count(), most);
      for (std::size_t i = 0; i < fields.size(); ++i) {
        const IdBitfield small = patches.patches(fields[i]), large = patches.polygons(small);
        EXPECT_TRUE(within(fields[i], large));
        if (most == 1) {
          EXPECT_EQ(large, fields[i]);
        }
        EXPECT_EQ(patches.patches(large), small);
        IdBitfield both = fields[i], both_small = small;
        both.join(fields[(i + 1) % fields.size()]);
        both_small.join(patches.patches(fields[(i + 1) % fields.size()]));
        EXPECT_EQ(patches.patches(both), both_small);
      }
    }
  }
}

/// By the corners' places, all pairs.
bool share_an_edge(const Scene& scene, PolygonId p, PolygonId q) {
  const auto side = [&](PolygonId of, std::size_t k) {
    const auto c = scene.corners(of);
    const glm::dvec3 a = scene.soup().vertices[c[k]], b = scene.soup().vertices[c[(k + 1) % c.size()]];
    return std::set<std::array<double, 3>>{{a.x, a.y, a.z}, {b.x, b.y, b.z}};
  };
  for (std::size_t i = 0; i < scene.corners(p).size(); ++i) {
    for (std::size_t j = 0; j < scene.corners(q).size(); ++j) {
      if (side(p, i) == side(q, j)) return true;
    }
  }
  return false;
}

/// The soup with vertices of its own for every polygon, as an STL file has them.
PolygonSoup taken_apart(const PolygonSoup& soup) {
  PolygonSoup out = soup;
  out.vertices.clear();
  for (std::size_t k = 0; k < soup.corners.size(); ++k) {
    out.corners[k] = static_cast<std::uint32_t>(k);
    out.vertices.push_back(soup.vertices[soup.corners[k]]);
  }
  return out;
}

TEST(FillingIn, KnowsNeighboursByPlace) {
  const Scene scene = make_scene(bumpy_ball(5)), apart = make_scene(taken_apart(bumpy_ball(5)));
  const PolygonNeighbours neighbours(scene), again(apart);
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    std::set<PolygonId> found;
    for (const auto& n : neighbours.of(p)) {
      EXPECT_TRUE(n.alike);  // a closed surface, all of whose polygons run the same way round
      found.insert(n.polygon);
    }
    std::set<PolygonId> expected, by_place;
    for (PolygonId q = 0; q < scene.polygon_count(); ++q) {
      if (q != p && share_an_edge(scene, p, q)) expected.insert(q);
    }
    EXPECT_EQ(found, expected);
    for (const auto& n : again.of(p)) by_place.insert(n.polygon);
    EXPECT_EQ(by_place, expected);
  }
}

/// Does the polygon, a triangle, show the eye the side from which it runs counter-clockwise? (The eye is far off, and
/// no triangle is seen edge on.)
bool shows_front(const Scene& scene, PolygonId p, const glm::dvec3& eye) {
  const auto c = scene.corners(p);
  const auto& v = scene.soup().vertices;
  return glm::dot(glm::cross(v[c[1]] - v[c[0]], v[c[2]] - v[c[0]]), eye - v[c[0]]) > 0;
}

TEST(FillingIn, AddsWhatFacesTheEyeAndHangsTogether) {
  PolygonSoup soup = bumpy_ball(16);
  const Camera camera = testing::camera_of({{5.25, 3.5, 2.125}, {-5.25, -3.5, -2.125}, {0, 0, 1}, 30, 1});
  const glm::dvec3& eye = camera.eye;
  const Scene scene = make_scene(soup);
  const PolygonNeighbours neighbours(scene);
  BitfieldSampling coarse;
  coarse.pixels = 40;
  const IdBitfield start = sample_bitfields(scene, std::span(&camera, 1), coarse).fields[0];
  ASSERT_GT(start.count(), 20u);
  IdBitfield before = start;
  for (unsigned rounds = 1; rounds < 60; ++rounds) {
    IdBitfield field = start;
    fill_in(scene, neighbours, eye, rounds, field);
    EXPECT_TRUE(within(before, field));
    // A round adds just the neighbours of what was there that face the eye.
    for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
      bool touches = before.test(p);
      for (const auto& n : neighbours.of(p))
        touches = touches || (before.test(n.polygon) && shows_front(scene, p, eye));
      EXPECT_EQ(field.test(p), touches) << p;
    }
    if (field == before) break;
    before = field;
  }
  IdBitfield all = start;
  fill_in(scene, neighbours, eye, all_rounds, all);
  EXPECT_EQ(all, before);
  EXPECT_GT(all.count(), start.count());
  EXPECT_LT(all.count(), scene.polygon_count());
  // Polygons that run the other way round, some or all, change nothing: both sides are opaque.
  for (const std::uint32_t every : {1u, 3u}) {
    PolygonSoup turned = soup;
    for (std::uint32_t p = 0; p < scene.polygon_count(); p += every) {
      std::swap(turned.corners[turned.first[p]], turned.corners[turned.first[p] + 1]);
    }
    const Scene other = make_scene(turned);
    IdBitfield field = start;
    fill_in(other, PolygonNeighbours(other), eye, all_rounds, field);
    EXPECT_EQ(field, all);
    // But where only one side is.
    const Scene closed = make_scene(turned, {.snap = "", .one_sided = true});
    IdBitfield inner(scene.polygon_count());
    for (const PolygonId p : start.list()) {
      if (p % every != 0) inner.set(p);
    }
    const IdBitfield seen = inner;
    fill_in(closed, PolygonNeighbours(closed), eye, all_rounds, inner);
    for (const PolygonId p : inner.list()) EXPECT_TRUE(p % every != 0 || seen.test(p));
  }
}

}  // namespace
}  // namespace sightline
