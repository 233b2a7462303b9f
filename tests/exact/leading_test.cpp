// What the leading bits tell of long normals is so, from far apart to a hair beside each other.
#include "exact/leading.hpp"
#include "exact/sightline_table.hpp"
#include "tables.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

using Normal = std::array<Integer, 3>;

Integer determinant(const Normal& a, const Normal& b, const Normal& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

bool parallel(const Normal& a, const Normal& b) {
  return a[0] * b[1] == a[1] * b[0] && a[1] * b[2] == a[2] * b[1] && a[2] * b[0] == a[0] * b[2];
}

std::uint32_t bits_of(const Normal& n) {
  return std::max({magnitude_bits(n[0]), magnitude_bits(n[1]), magnitude_bits(n[2])});
}

LeadingBits leading(const Normal& n) {
  const std::uint32_t bits = bits_of(n), stride = words_for(bits);
  std::vector<std::uint64_t> all(std::size_t{3} * stride);
  for (std::uint32_t k = 0; k < 3; ++k) store_words(n[k], all.data() + k * stride, stride);
  return LeadingBits(all.data(), bits);
}

Integer random_bits(Random& random, int bits) {
  Integer r = 0;
  for (int i = 0; i < bits; i += 32) r = (r << 32) + static_cast<unsigned long>(random() >> 32);
  return r >> static_cast<unsigned>((32 - bits % 32) % 32);
}

Normal random_normal(Random& random, int bits) {
  Normal n;
  for (Integer& c : n) {
    c = random_bits(random, below(random, 4) == 0 ? below(random, bits) + 1 : bits);
    if (below(random, 3) == 0) c = (Integer(1) << static_cast<unsigned>(bits)) - 1;  // as long as it gets
    if (below(random, 2) == 0) c = -c;
  }
  return n;
}

// A multiple of a and b's sum, then a hair beside it: from none at all to half of it.
Normal beside(Random& random, const Normal& a, const Normal& b, int length) {
  const Integer i = random_bits(random, below(random, length) + 1), j = random_bits(random, below(random, length) + 1);
  Normal c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = i * a[k] - j * b[k];
  const auto bits = static_cast<int>(bits_of(c));
  const int away = below(random, 160);
  if (away > 0 && away < bits)
    c[static_cast<std::size_t>(below(random, 3))] += Integer(1) << static_cast<unsigned>(bits - away);
  return c;
}

TEST(LeadingBitsTest, AreRightWhereTheyTell) {
  Random random(1);
  int told = 0, told_by_more = 0, zeros = 0, apart = 0;
  for (int k = 0; k < 60'000; ++k) {
    const Normal a = random_normal(random, 1 + below(random, 300)), b = random_normal(random, 1 + below(random, 300));
    const Normal c = below(random, 4) == 0 ? random_normal(random, 1 + below(random, 300)) : beside(random, a, b, 100);
    if (bits_of(a) == 0 || bits_of(b) == 0 || bits_of(c) == 0) continue;
    const LeadingBits x = leading(a), y = leading(b), z = leading(c);
    const Sign expected = sgn(determinant(a, b, c));
    zeros += expected == 0;
    const Sign word = leading_order_short(x, y, z);
    if (word != uncertain) {
      ASSERT_EQ(word, expected) << a[0] << ' ' << b[0] << ' ' << c[0];
      ++told;
    }
    const Sign words = leading_order(x, y, z);
    if (words != uncertain) {
      ASSERT_EQ(words, expected) << a[0] << ' ' << b[0] << ' ' << c[0];
      told_by_more += word == uncertain;
    }
    const Normal d = beside(random, a, Normal{}, 100);
    if (bits_of(d) != 0 && leading_apart(x, leading(d))) {
      ASSERT_FALSE(parallel(a, d));
      ++apart;
    }
  }
  EXPECT_GT(told, 10'000);
  EXPECT_GT(told_by_more, 5'000);
  EXPECT_GT(zeros, 200);
  EXPECT_GT(apart, 5'000);
}

// A vector that a second one is at right angles to, or a hair off.
TEST(LeadingBitsTest, ProductsAreRightWhereTheyTell) {
  Random random(3);
  int told = 0, zeros = 0;
  for (int k = 0; k < 60'000; ++k) {
    const Normal a = random_normal(random, 1 + below(random, 300)), r = random_normal(random, 1 + below(random, 120));
    Normal b{a[1] * r[2] - a[2] * r[1], a[2] * r[0] - a[0] * r[2], a[0] * r[1] - a[1] * r[0]};
    const auto bits = static_cast<int>(bits_of(b));
    const int away = below(random, 90);
    if (away > 0 && away < bits)
      b[static_cast<std::size_t>(below(random, 3))] += Integer(1) << static_cast<unsigned>(bits - away);
    if (bits_of(a) == 0 || bits_of(b) == 0) continue;
    const Sign expected = sgn(Integer(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]));
    zeros += expected == 0;
    const Sign sign = leading_dot(leading(a).high, leading(b).high);
    if (sign == uncertain) continue;
    ASSERT_EQ(sign, expected) << a[0] << ' ' << b[0];
    ++told;
  }
  EXPECT_GT(told, 20'000);
  EXPECT_GT(zeros, 200);
}

// The same through the table, all stages: lines of points, whose normals are short, and of any normals.
TEST(LeadingBitsTest, OrderOfHairs) {
  Random random(2);
  const std::vector<glm::dvec3> world{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Grid grid = Grid::covering(world);
  const PointTable points(grid, world);
  const PlaneTable planes(points);
  for (int k = 0; k < 20'000; ++k) {
    const Normal a = random_normal(random, 1 + below(random, 300)), b = random_normal(random, 1 + below(random, 300));
    const Normal c = beside(random, a, b, 100);
    if (parallel(a, b) || bits_of(c) == 0) continue;
    SightlineTable table(planes);
    const SightlineRef x = table.of_normal(a), y = table.of_normal(b), z = table.of_normal(c);
    ASSERT_EQ(table.order(x, y, z), sgn(determinant(a, b, c)));
    ASSERT_EQ(table.order(z, x, y), sgn(determinant(a, b, c)));
    const Normal d = beside(random, a, Normal{}, 100);
    if (bits_of(d) != 0) {
      ASSERT_EQ(table.of_normal(d).id == x.id, parallel(a, d));
    }
  }
}

}  // namespace
}  // namespace sightline::test
