// The hull of directions: its laws by brute force, in integers of any length. A closed surface of triangles between
// directions that has none of them outside is their hull.
#include "sample/bitfield_hull.hpp"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>

namespace sightline {
namespace {

using Vector = std::array<mpz_class, 3>;

Vector vector(const ViewDirection& d) { return {mpz_class(d[0]), mpz_class(d[1]), mpz_class(d[2])}; }
Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
mpz_class dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
/// Sign of det(a, b, c).
int turn(const Vector& a, const Vector& b, const Vector& c) {
  const Vector n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return sgn(dot(n, c));
}

/// With some directions twice, some nearly so, and whole circles of them.
std::vector<ViewDirection> some_directions(std::uint32_t seed, std::size_t count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<ViewDirection> out;
  for (const double way : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 v(0);
      v[axis] = way;
      out.push_back(view_direction(v));
    }
  }
  while (out.size() < count) {
    switch (random() % 4) {
      case 0:
        out.push_back(out[random() % out.size()]);
        break;
      case 1: {
        ViewDirection near = out[random() % out.size()];
        near[random() % 3] += 1;
        out.push_back(near);
        break;
      }
      case 2:  // on a circle, but for rounding
        out.push_back(view_direction(
            {3, 4 * std::cos(static_cast<double>(out.size())), 4 * std::sin(static_cast<double>(out.size()))}));
        break;
      default:
        out.push_back(view_direction({normal(random), normal(random), normal(random)}));
    }
  }
  std::shuffle(out.begin(), out.end(), random);
  return out;
}

/// +1: outside of the face.
int side(const ViewHull& hull, const ViewHull::Face& f, const ViewDirection& p) {
  const auto d = hull.directions();
  const Vector a = vector(d[f.corner[0]]);
  return turn(minus(vector(d[f.corner[1]]), a), minus(vector(d[f.corner[2]]), a), minus(vector(p), a));
}

/// Law 1 and 2.
void check(const ViewHull& hull) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> edges;
  std::set<std::uint32_t> corners;
  const auto faces = hull.faces();
  for (std::uint32_t k = 0; k < faces.size(); ++k) {
    const auto& f = faces[k];
    EXPECT_EQ(side(hull, f, {0, 0, 0}), -1);
    for (const ViewDirection& d : hull.directions()) ASSERT_LE(side(hull, f, d), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      corners.insert(f.corner[i]);
      EXPECT_TRUE(edges.emplace(std::pair(f.corner[i], f.corner[(i + 1) % 3]), k).second);
    }
  }
  for (const auto& [edge, k] : edges) {
    const auto beyond = edges.find({edge.second, edge.first});
    ASSERT_NE(beyond, edges.end());
    const auto& f = faces[k];
    const auto place = std::ranges::find(f.corner, edge.first) - f.corner.begin();
    EXPECT_EQ(f.neighbour[static_cast<std::size_t>(place)], beyond->second);
  }
  EXPECT_EQ(faces.size() - edges.size() / 2 + corners.size(), 2u);
}

TEST(ViewHullLaws, OfRandomAndDegenerateDirections) {
  for (std::uint32_t seed = 0; seed < 40; ++seed) {
    const ViewHull hull(some_directions(seed, 6 + seed));
    check(hull);
    // Law 3 and 4, by the same signs.
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 50; ++k) {
      const ViewDirection v = k % 2 == 0 ? hull.directions()[random() % hull.directions().size()]
                                         : view_direction({normal(random), normal(random), normal(random)});
      const std::uint32_t held = hull.face_holding(v);
      for (std::uint32_t f = 0; f < hull.faces().size(); ++f) {
        const auto& c = hull.faces()[f].corner;
        const auto d = hull.directions();
        bool inside = true, strictly = true;
        for (std::size_t i = 0; i < 3; ++i) {
          const int s = turn(vector(d[c[i]]), vector(d[c[(i + 1) % 3]]), vector(v));
          inside = inside && s >= 0;
          strictly = strictly && s > 0;
        }
        if (f == held) {
          EXPECT_TRUE(inside);
        }
        if (f < held) {
          EXPECT_FALSE(inside);  // the first one
        }
        if (strictly) {
          EXPECT_EQ(f, held);
        }
      }
    }
  }
}

TEST(ViewHullLaws, EveryDirectionBelongsToTheNearestCorner) {
  const ViewHull hull(some_directions(7, 60));
  std::set<std::uint32_t> corners;
  for (const auto& f : hull.faces()) corners.insert(f.corner.begin(), f.corner.end());
  ASSERT_LT(corners.size(), hull.directions().size());  // some are there twice
  const std::vector<std::uint32_t> nearest = hull.nearest_corners();
  const auto d = hull.directions();
  for (std::uint32_t k = 0; k < nearest.size(); ++k) {
    if (corners.contains(k)) {
      EXPECT_EQ(nearest[k], k);
      continue;
    }
    // Directions are equally long but for rounding.
    for (const std::uint32_t c : corners) {
      EXPECT_GE(dot(vector(d[nearest[k]]), vector(d[k])), dot(vector(d[c]), vector(d[k])));
    }
  }
}

TEST(ViewHullLaws, AroundAFaceAreItsCornersAndThoseAcross) {
  const ViewHull hull(some_directions(3, 40));
  for (std::uint32_t f = 0; f < hull.faces().size(); ++f) {
    const auto six = hull.around(f);
    const auto& face = hull.faces()[f];
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(six[k], face.corner[k]);
      const auto& other = hull.faces()[face.neighbour[k]].corner;
      EXPECT_EQ(std::ranges::count(other, six[3 + k]), 1);
      EXPECT_EQ(std::ranges::count(face.corner, six[3 + k]), 0);
    }
  }
}

TEST(ViewHull, RefusesWhatDoesNotSurroundTheOrigin) {
  std::vector<ViewDirection> none, one{view_direction({1, 0, 0})}, plane, half;
  for (int k = 0; k < 12; ++k) {
    plane.push_back(view_direction({std::cos(k), std::sin(k), 0}));
    half.push_back(view_direction({std::cos(k), std::sin(k), 0.1 + 0.05 * k}));
  }
  for (const auto& bad : {none, one, plane, half}) EXPECT_THROW(ViewHull{bad}, std::invalid_argument);
}

TEST(ViewDirection, IsRoundedOnceWhateverTheLength) {
  EXPECT_EQ(view_direction({0, 0, 5e300}), (ViewDirection{0, 0, 1 << 26}));
  EXPECT_EQ(view_direction({-5e-320, 0, 0}), (ViewDirection{-(1 << 26), 0, 0}));
  EXPECT_EQ(view_direction({1e200, 1e200, 0}), view_direction({1, 1, 0}));
  EXPECT_EQ(view_direction({0, 0, 0}), (ViewDirection{0, 0, 0}));
  EXPECT_EQ(view_direction({std::nan(""), 1, 0}), (ViewDirection{0, 0, 0}));
}

}  // namespace
}  // namespace sightline
