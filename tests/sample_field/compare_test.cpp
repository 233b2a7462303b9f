// The method `field` of `compare`.
#include "compare/reference.hpp"
#include "sample/field_cells.hpp"
#include "tests/compare/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace sightline::comparison {
namespace {

TEST(FieldMethod, IsNamedOrRefused) {
  for (const char* good : {"field:16x16x32x32:5", "field:1x2x3x4:1:uv", "field:1x2x3x4:65535:uv+st:polygons"}) {
    EXPECT_EQ(parse_methods(good).front().kind->name, "field");
  }
  for (const char* bad :
       {"field", "field:", "field:5", "field:1x1x1x1", "field:1x1x1:5", "field:1x1x1x1x1:5", "field:0x1x1x1:5",
        "field:1x1x1x4097:5", "field:1x1x1x1:0", "field:1x1x1x1:65536", "field:1x1x1x1:5:vu"}) {
    try {
      parse_methods(bad);
      ADD_FAILURE() << bad;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("field:UxVxSxT:IDS wants samples"), std::string::npos) << error.what();
    }
  }
}

/// What is missed is all that is wrong in the picture: where nothing is missed it is right.
void expect_errors_of_the_set(const Views& views, std::size_t least_marked) {
  std::vector<std::vector<PolygonId>> before(views.cameras.size());
  for (const char* name : {"field:2x2x4x4:1", "field:2x2x4x4:9", "field:2x2x4x4:9:uv+st"}) {
    const auto method = parse_methods(name).front().make(views.scene);
    for (std::size_t k = 0; k < views.cameras.size(); ++k) {
      const Measured measured = method->view(views.cameras[k], 1);
      ASSERT_EQ(measured.why, "");
      const Error error = Reference(views.map(k)).error_of(measured.answer);
      EXPECT_EQ(error.missed == 0, error.wrong_area < 1e-12) << name << ' ' << k << ' ' << error.wrong_area;
      const auto& marked = measured.answer.reported;
      EXPECT_TRUE(std::ranges::includes(marked, before[k]));
      before[k] = marked;
    }
  }
  for (const auto& marked : before) EXPECT_GT(marked.size(), least_marked);
}

TEST(FieldMethod, FromWithinAScene) { expect_errors_of_the_set(Views("city", {}, 3), 20); }

TEST(FieldMethod, FromOutsideOfAScene) {
  Views views("city", {}, 2);
  const FieldBox box = box_of(views.scene);
  const glm::dvec3 middle = 0.5 * (box.low + box.high), size = box.high - box.low;
  const glm::dvec3 aside(0.9 * size.x, 0.7 * size.y, size.x);
  views.cameras = {make_camera(middle + glm::dvec3(0, 0, size.x), {0, 0.01, -1}, {0, 1, 0}, 50, 1.3),
                   make_camera(middle + aside, -aside, {0, 0, 1}, 50, 1.3)};
  expect_errors_of_the_set(views, 20);
}

}  // namespace
}  // namespace sightline::comparison
