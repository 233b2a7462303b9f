// Areas in which answers differ from the exact map.
#include "compare/overlay.hpp"
#include "compare/reference.hpp"
#include "models/random_numbers.hpp"
#include "tests/compare/views.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace sightline::comparison {
namespace {

constexpr double rounding = 1e-12;

/// The parts in which two descriptions of the window differ, by face and polygon shown.
template <class Shown>
std::map<std::pair<std::uint32_t, PolygonId>, double> parts(const Drawing& drawing, const Shown& shown) {
  std::map<std::pair<std::uint32_t, PolygonId>, double> areas;
  differences(
      drawing, shown, [&](std::uint32_t face, PolygonId p) { return drawing.polygons[face] == p; },
      [&](std::uint32_t face, PolygonId p, double area) {
        areas[{face, p}] += area;
      });
  return areas;
}

/// The window cut in two by a line from border to border; `first` is shown on the left of it.
Drawing halves(const glm::dvec2& from, const glm::dvec2& to, std::vector<glm::dvec2> left,
               std::vector<glm::dvec2> right, PolygonId first, PolygonId second) {
  Drawing d;
  d.polygons = {first, second};
  d.corners = {from, to};
  d.edges = {{0, 1, 0, 1}};
  std::uint32_t face = 0;
  for (auto* corners : {&left, &right}) {  // counter-clockwise from the line's one end to its other
    std::vector<std::uint32_t> loop{face == 0 ? 1u : 0u};
    for (const glm::dvec2& c : *corners) {
      loop.push_back(static_cast<std::uint32_t>(d.corners.size()));
      d.corners.push_back(c);
    }
    loop.push_back(face == 0 ? 0u : 1u);
    for (std::size_t k = 0; k + 1 < loop.size(); ++k) d.edges.push_back({loop[k], loop[k + 1], face, none});
    ++face;
  }
  return d;
}

TEST(Areas, OfCrossingDiagonals) {
  const Drawing rising = halves({0, 0}, {1, 1}, {{0, 1}}, {{1, 0}}, 7, 8);
  const Drawing falling = halves({1, 0}, {0, 1}, {{0, 0}}, {{1, 1}}, 7, 8);
  const auto areas = parts(rising, falling);
  ASSERT_EQ(areas.size(), 2u);
  // Four triangles meet in the middle: the upper and the lower one are wrong.
  EXPECT_NEAR((areas.at({0, 8})), 0.25, rounding);
  EXPECT_NEAR((areas.at({1, 7})), 0.25, rounding);
  EXPECT_TRUE(parts(rising, rising).empty());
}

TEST(Areas, OfPixelsCutByALine) {
  // s = t / 2 + 1/8: of the pixels of a quarter.
  const Drawing line = halves({0.125, 0}, {0.625, 1}, {{0, 1}, {0, 0}}, {{1, 0}, {1, 1}}, 1, 2);
  Pixels pixels{4, std::vector<PolygonId>(16, 1)};
  double sum = 0;
  for (const auto& [key, area] : parts(line, pixels)) {
    EXPECT_EQ(key, (std::pair<std::uint32_t, PolygonId>{1, 1}));
    sum += area;
  }
  EXPECT_NEAR(sum, 1 - 0.375, rounding);
  // One pixel at a time: in column x the line runs from t = 2 (x/4 - 1/8) to half a unit above.
  const std::map<std::uint32_t, double> left_part{{0, 0.75}, {1, 0}, {4, 1}, {5, 0.25}};
  for (const auto& [pixel, part] : left_part) {
    pixels.items.assign(16, 3);
    pixels.items[pixel] = 1;
    const auto areas = parts(line, pixels);
    EXPECT_NEAR((areas.at({0, 3})), 0.375 - part / 16, rounding) << pixel;
    if (part < 1) {
      EXPECT_NEAR((areas.at({1, 1})), (1 - part) / 16, rounding) << pixel;
    }
  }
}

/// Pixels as a drawing of squares.
Drawing squares(const Pixels& pixels) {
  Drawing d;
  const std::uint32_t n = pixels.size, row = n + 1;
  for (std::uint32_t y = 0; y <= n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x)
      d.corners.emplace_back(static_cast<double>(x) / n, static_cast<double>(y) / n);
  }
  d.polygons = pixels.items;
  const auto face = [&](std::uint32_t x, std::uint32_t y) { return x < n && y < n ? y * n + x : none; };
  for (std::uint32_t y = 0; y < n; ++y) {
    for (std::uint32_t x = 0; x <= n; ++x) {
      d.edges.push_back({y * row + x, (y + 1) * row + x, x > 0 ? face(x - 1, y) : none, face(x, y)});
    }
  }
  return d;
}

TEST(Areas, TheTwoWaysAgreeOnPixels) {
  models::RandomNumbers random(5);
  double most = 0;
  for (const char* name : {"maze", "city", "random"}) {
    const Views views(name, {.polygons = std::string(name) == "random" ? 60u : 0u}, 2);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      Drawing exact;
      draw(views.map(camera), exact);
      for (const std::uint32_t size : {1u, 2u, 7u, 33u}) {
        Pixels pixels{size, {}};
        for (std::uint32_t k = 0; k < size * size; ++k) {
          pixels.items.push_back(
              exact.polygons[static_cast<std::size_t>(random.below(static_cast<int>(exact.polygons.size())))]);
        }
        const auto one = parts(exact, pixels), other = parts(exact, squares(pixels));
        double sum = 0;
        for (const auto& [key, area] : one) {
          const auto found = other.find(key);
          EXPECT_NEAR(area, found == other.end() ? 0 : found->second, rounding) << name << camera << ' ' << size;
          sum += area;
        }
        for (const auto& [key, area] : other) EXPECT_TRUE(area < rounding || one.contains(key));
        most = std::max(most, sum);
      }
    }
  }
  EXPECT_GT(most, 0.5);
}

TEST(Errors, OfTheMapItselfAreNone) {
  for (const char* name : {"rooms", "maze", "city"}) {
    const Views views(name, {.rotate_degrees = 17});
    for (std::size_t k = 0; k < views.cameras.size(); ++k) {
      const VisibilityMap map = views.map(k);
      const Error error = Reference(map).error_of(answer_of(map));
      EXPECT_EQ(error.missed, 0u);
      EXPECT_EQ(error.falsely, 0u);
      EXPECT_EQ(error.wrong_area, 0);
      EXPECT_EQ(error.worst_area, 0);
    }
  }
}

double area_of(const VisibilityMap& map, PolygonId polygon) {
  double area = 0;
  for (const MapFace& f : map.faces) area += f.polygon == polygon ? f.area : 0;
  return area;
}

TEST(Errors, OfAPolygonThatIsHiddenOrTakenForAnother) {
  const Views views("maze");
  const VisibilityMap map = views.map(1);
  const Reference reference(map);
  const Answer right = answer_of(map);
  ASSERT_GT(right.reported.size(), 5u);
  for (const PolygonId p : right.reported) {
    const double area = area_of(map, p);
    for (const PolygonId instead : {none, PolygonId{100000}}) {
      Answer wrong = right;
      auto& shown = std::get<Drawing>(wrong.shown);
      std::ranges::replace(shown.polygons, p, instead);
      std::ranges::replace(wrong.reported, p, instead);
      tidy(wrong.reported);
      const Error error = reference.error_of(wrong);
      EXPECT_EQ(error.missed, 1u);
      EXPECT_EQ(error.falsely, instead == none ? 0u : 1u);
      EXPECT_NEAR(error.wrong_area, area, rounding);
      EXPECT_NEAR(error.worst_area, area, rounding);
    }
    // A single pixel.
    const Error error = reference.error_of({{p}, Pixels{1, {p}}});
    EXPECT_EQ(error.missed, right.reported.size() - 1);
    EXPECT_EQ(error.falsely, 0u);
    EXPECT_NEAR(error.wrong_area, 1 - area, rounding);
  }
}

TEST(Errors, PolygonsInOnePlaceStandForEachOther) {
  // Two equal squares, the second with a margin around it.
  PolygonSoup soup;
  soup.vertices = {{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}};
  soup.corners = {0, 1, 2, 3, 0, 1, 2, 3};
  soup.first = {0, 4, 8};
  const Scene scene = make_scene(soup);
  const BspTree tree(scene);
  VisibilityMap map;
  Tracer(tree).trace({{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 2}}, map);
  const Reference reference(map);
  Answer answer = answer_of(map);
  ASSERT_EQ(answer.reported, std::vector<PolygonId>{0});
  std::ranges::replace(std::get<Drawing>(answer.shown).polygons, PolygonId{0}, PolygonId{1});
  answer.reported = {1};
  const Error error = reference.error_of(answer);
  EXPECT_EQ(error.missed + error.falsely, 0u);
  EXPECT_EQ(error.wrong_area, 0);
  const Error nothing = reference.error_of_nothing();
  EXPECT_EQ(nothing.missed, 1u);
  EXPECT_NEAR(nothing.wrong_area, 0.25, rounding);
}

}  // namespace
}  // namespace sightline::comparison
