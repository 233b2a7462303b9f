// Lines and planes.
#include "scene/errors.hpp"
#include "tests/sample_field/scenes.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <random>

namespace sightline::test {
namespace {

const FieldBox box{{-1, 2, 3}, {4, 5, 4.5}};

/// Where a window looks along a direction, in the middle of which it lies.
Camera along(const FieldRay& ray, double how_far) {
  return make_camera(ray.origin + how_far * ray.direction, ray.direction, {0.3, 0.5, 0.7}, 60, 1.5);
}

void expect_own_place(const FieldSlab& slab, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(0.01, 0.99);
  for (int k = 0; k < 200; ++k) {
    const std::array<double, 4> uvst{any(random), any(random), any(random), any(random)};
    const FieldRay ray = ray_of(slab, uvst);
    for (const double how_far : {-0.7, 0.0, 0.4, 3.0}) {
      const SlabView view(slab, along(ray, how_far));
      const double uv = view.uv_denominator()(0.5, 0.5), st = view.st_denominator()(0.5, 0.5);
      ASSERT_GT(uv, 0);
      ASSERT_GT(st, 0);
      for (std::size_t axis = 0; axis < 4; ++axis) {
        EXPECT_NEAR(view.numerators()[axis](0.5, 0.5) / (axis < 2 ? uv : st), uvst[axis], 1e-5);  // cameras are rounded
      }
    }
    // The other way round there is nothing.
    const SlabView back(slab, along({ray.origin, -ray.direction}, 0.5));
    EXPECT_TRUE(back.uv_denominator()(0.5, 0.5) < 0 || back.st_denominator()(0.5, 0.5) < 0);
  }
}

TEST(Slabs, ARayOfASlabHasItsOwnPlaceInIt) {
  std::mt19937_64 random(1);
  for (const FieldSlab& slab : slabs_around(box)) expect_own_place(slab, random);
  for (const FieldSlab& slab : slabs_around(box, 2)) expect_own_place(slab, random);
  for (const FieldSlab& slab : slabs_within(box)) expect_own_place(slab, random);
  expect_own_place(slab_before(box, 1, true, 0.5), random);
}

/// In how many slabs a line is.
int holders(const std::vector<FieldSlab>& slabs, const glm::dvec3& from, const glm::dvec3& direction) {
  int count = 0;
  for (const FieldSlab& slab : slabs) {
    const SlabView view(slab, make_camera(from, direction, {0.3, 0.5, 0.7}, 60, 1.5));
    const double uv = view.uv_denominator()(0.5, 0.5), st = view.st_denominator()(0.5, 0.5);
    bool there = uv > 0 && st > 0;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const double place = view.numerators()[axis](0.5, 0.5) / (axis < 2 ? uv : st);
      there = there && place >= 0 && place <= 1;
    }
    count += there ? 1 : 0;
  }
  return count;
}

TEST(Slabs, SixOfThemHoldAllLinesThroughTheBox) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> any(0, 1);
  std::normal_distribution<double> ball;
  for (int k = 0; k < 2000; ++k) {
    const glm::dvec3 part(any(random), any(random), any(random));
    const glm::dvec3 p = box.low + part * (box.high - box.low);
    const glm::dvec3 d = glm::normalize(glm::dvec3(ball(random), ball(random), ball(random)));
    EXPECT_EQ(holders(slabs_around(box), p - 20.0 * d, d), 1);
    EXPECT_EQ(holders(slabs_within(box), p, d), 1);
    EXPECT_GE(holders(slabs_around(box, 3), p - 90.0 * d, d), 1);  // finite planes hold steeper lines, too
  }
}

TEST(Slabs, RaysAroundTheBoxBeginOutsideOfItAndThoseWithinGoThroughIt) {
  const auto outside = [](const glm::dvec3& p, int axis) {
    return p[axis] < box.low[axis] || p[axis] > box.high[axis];
  };
  for (std::size_t k = 0; k < 6; ++k) {
    const int axis = static_cast<int>(k / 2);
    for (const auto& slabs : {slabs_around(box), slabs_around(box, 1), slabs_within(box)}) {
      const FieldRay ray = ray_of(slabs[k], {0.1, 0.8, 0.4, 0.5});
      EXPECT_TRUE(outside(ray.origin, axis));
    }
    const FieldSlab within_it = slabs_within(box)[k];
    const FieldRay ray = ray_of(within_it, {0.1, 0.8, 0.4, 0.5});
    const glm::dvec3 end = ray.origin + (within_it.end - within_it.begin) * ray.direction;
    EXPECT_TRUE(outside(end, axis));
    EXPECT_LT((ray.origin[axis] - 0.5 * (box.low + box.high)[axis]) * (end[axis] - 0.5 * (box.low + box.high)[axis]),
              0);
  }
}

std::filesystem::path written(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sightline_slabs.txt";
  std::ofstream(file) << text;
  return file;
}

std::string refusal(const std::string& text) {
  try {
    read_slabs(written(text), box);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Slabs, AreReadFromTextOrRefusedWithTheLine) {
  const std::string planes = "plane 0 0 0 1 0 0 0 1 0  0 0 2 3 0 0 0 3 0\n";
  const std::string infinity = "infinity -1 -1 1 2 0 0 0 2 0  0 0 0 3 0 0 0 3 0\n";
  const auto slabs = read_slabs(written("# two\n\n" + planes + infinity), box);
  ASSERT_EQ(slabs.size(), 2u);
  EXPECT_FALSE(slabs[0].infinite);
  EXPECT_EQ(slabs[0].st.corner, glm::dvec3(0, 0, 2));
  EXPECT_EQ(slabs[0].begin, -1);
  EXPECT_TRUE(slabs[1].infinite);
  std::mt19937_64 random(3);
  expect_own_place(slabs[0], random);
  // Rays of directions begin before the box: its corners all lie ahead.
  const FieldRay ray = ray_of(slabs[1], {0.5, 0.5, 0.5, 0.5});
  EXPECT_LT(ray.origin.z, box.low.z);
  EXPECT_NE(refusal("# none\n").find("holds no slab"), std::string::npos);
  EXPECT_NE(refusal("\nplane 0 0\n").find(":2: a slab has 18 numbers"), std::string::npos);
  EXPECT_NE(refusal("sphere 1\n").find("'sphere'"), std::string::npos);
  EXPECT_NE(refusal("plane nan" + planes.substr(7)).find("'nan' is no number"), std::string::npos);
  EXPECT_NE(refusal(planes.substr(0, planes.size() - 1) + " 7").find("'7' stands after"), std::string::npos);
  EXPECT_NE(refusal("plane 0 0 0 1 0 0 2 0 0  0 0 2 3 0 0 0 3 0").find("no area"), std::string::npos);
  EXPECT_NE(refusal("plane 0 0 0 1 0 0 0 1 0  0 0 2 3 0 0 0 3 1").find("not parallel"), std::string::npos);
  EXPECT_NE(refusal("plane 0 0 2 1 0 0 0 1 0  0 0 2 3 0 0 0 3 0").find("are one"), std::string::npos);
  EXPECT_NE(refusal("infinity -1 -1 0 2 0 0 0 2 0  0 0 0 3 0 0 0 3 0").find("runs along"), std::string::npos);
}

}  // namespace
}  // namespace sightline::test
