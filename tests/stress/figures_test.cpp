// Scenes that are hard on numbers, each seen from where it is hardest to be.
#include <gtest/gtest.h>

#include "tests/stress/figures.hpp"
#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

struct Kind {
  const char* name;
  PolygonSoup (*make)(Random&);
};

class StressFigures : public ::testing::TestWithParam<Kind> {};

TEST_P(StressFigures, FromHardEyes) {
  for (std::uint64_t seed = 0; seed < times(7); ++seed) {
    Random random(seed);
    const PolygonSoup soup = GetParam().make(random);
    SceneOptions options;
    options.one_sided = random.once_in(5);
    Court court(soup, options);
    for (int k = 0; k < 3; ++k) {
      court.check(hard_camera(soup, random),
                  std::string(GetParam().name) + " " + std::to_string(seed) + " eye " + std::to_string(k));
    }
    // And from a distance, where all of it is in the window.
    glm::dvec3 middle{0, 0, 0};
    for (const glm::dvec3& v : soup.vertices) middle += v / static_cast<double>(soup.vertices.size());
    court.check(aimed(middle + glm::dvec3{9, -7, 13}, middle, 2),
                std::string(GetParam().name) + " " + std::to_string(seed) + " far");
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, StressFigures,
                         ::testing::Values(Kind{"all_but_coplanar", all_but_coplanar}, Kind{"slivers", slivers},
                                           Kind{"needles", needles}, Kind{"cycle", cycle},
                                           Kind{"cracked_wall", cracked_wall}, Kind{"duplicates", duplicates},
                                           Kind{"shell", shell}, Kind{"mixed_exponents", mixed_exponents}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace sightline::stress
