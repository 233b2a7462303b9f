// The methods themselves, and how they are asked for.
#include "compare/guard.hpp"
#include "compare/reference.hpp"
#include "tests/compare/views.hpp"
#include "visibility_map/locate.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace sightline::comparison {
namespace {

std::string refusal(const std::string& list) {
  try {
    parse_methods(list);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Names, AreParsedOrRefused) {
  const auto methods = parse_methods("cells,ids:64,front-to-back,ids:1");
  ASSERT_EQ(methods.size(), 4u);
  EXPECT_EQ(methods[1].text, "ids:64");
  EXPECT_EQ(methods[1].kind->name, "ids");
  EXPECT_EQ(methods[2].kind->name, "front-to-back");
  EXPECT_NE(refusal("cells,magic").find("'magic': no such method (front-to-back, cells"), std::string::npos);
  EXPECT_NE(refusal("").find("no such method"), std::string::npos);
  EXPECT_NE(refusal("cells,").find("no such method"), std::string::npos);
  EXPECT_NE(refusal("cells,cells").find("twice"), std::string::npos);
  EXPECT_NE(refusal("cells:3").find("takes no number"), std::string::npos);
  for (const char* bad : {"ids", "ids:", "ids:0", "ids:-1", "ids:12x", "ids:16385", "ids:99999999999999999999"}) {
    EXPECT_NE(refusal(bad).find("ids:N wants a number of pixels from 1 to 16384"), std::string::npos) << bad;
  }
}

TEST(Names, SettingsAreNumbers) {
  EXPECT_EQ(setting_number("17", 1, 20), 17u);
  EXPECT_EQ(setting_number("1", 1, 20), 1u);
  EXPECT_EQ(setting_number("20", 1, 20), 20u);
  for (const char* bad : {"", "0", "21", "-1", "+1", " 1", "1 ", "1x", "0x1", "1e1", "99999999999999999999"}) {
    EXPECT_FALSE(setting_number(bad, 1, 20)) << bad;
  }
}

const std::vector<std::string> image_space{"rays", "ids"};

std::unique_ptr<Method> of_pixels(const std::string& kind, const Scene& scene, unsigned size) {
  return parse_methods(kind + ":" + std::to_string(size)).front().make(scene);
}

/// What lies in the middle of every pixel, by the exact map.
Pixels sampled(const VisibilityMap& map, const Scene& scene, std::uint32_t size) {
  const Locator locator(map, scene);
  Pixels pixels{size, {}};
  for (std::uint32_t y = 0; y < size; ++y) {
    for (std::uint32_t x = 0; x < size; ++x) {
      const std::uint32_t face = locator.face_at({(x + 0.5) / size, (y + 0.5) / size});
      pixels.items.push_back(face == none ? none : map.faces[face].polygon);
    }
  }
  return pixels;
}

TEST(ImageSpaceMethods, SeeWhatLiesInTheMiddleOfPixels) {
  const Views views("random", {.polygons = 200}, 3);
  for (const std::string& kind : image_space) {
    std::uint32_t missed_before = ~0u;
    for (const unsigned size : {5u, 16u, 50u, 150u}) {
      const auto method = of_pixels(kind, views.scene, size);
      std::uint32_t missed = 0;
      for (std::size_t k = 0; k < views.cameras.size(); ++k) {
        const VisibilityMap map = views.map(k);
        const Reference reference(map);
        const Measured measured = method->view(views.cameras[k], 1);
        ASSERT_EQ(measured.why, "");
        Answer independent{{}, sampled(map, views.scene, size)};
        independent.reported = std::get<Pixels>(independent.shown).items;
        tidy(independent.reported);
        EXPECT_EQ(measured.answer.reported, independent.reported) << kind << ' ' << size << ' ' << k;
        const Error error = reference.error_of(measured.answer), expected = reference.error_of(independent);
        EXPECT_EQ(error.missed, reference.visible() - independent.reported.size());
        EXPECT_EQ(error.falsely, 0u);
        EXPECT_NEAR(error.wrong_area, expected.wrong_area, 1e-3 / size);  // a pixel or so on an edge
        EXPECT_GT(error.wrong_area, 0);
        missed += error.missed;
      }
      EXPECT_LT(missed, missed_before) << kind << ' ' << size;
      missed_before = missed;
    }
  }
}

TEST(ImageSpaceMethods, ClosePlanesAndTheEyeAmongPolygons) {
  for (const char* name : {"maze", "rooms"}) {
    const Views views(name, {.rotate_degrees = 29}, 4);
    for (const std::string& kind : image_space) {
      const auto method = of_pixels(kind, views.scene, 64);
      for (std::size_t k = 0; k < views.cameras.size(); ++k) {
        const VisibilityMap map = views.map(k);
        const Measured measured = method->view(views.cameras[k], 1);
        const Pixels expected = sampled(map, views.scene, 64);
        const auto& items = std::get<Pixels>(measured.answer.shown).items;
        std::size_t different = 0;
        for (std::size_t i = 0; i < items.size(); ++i) different += items[i] != expected.items[i];
        EXPECT_LT(different, 20u) << name << ' ' << kind << ' ' << k;  // middles that lie on edges
      }
    }
  }
}

TEST(ImageSpaceMethods, BacksOfOneSidedPolygonsAreNotSeen) {
  PolygonSoup soup;
  soup.vertices = {{-1, 2, -1}, {1, 2, -1}, {1, 2, 1}, {-1, 2, 1}};
  soup.corners = {0, 1, 2, 3};
  soup.first = {0, 4};
  for (const bool backwards : {false, true}) {
    if (backwards) std::swap(soup.corners[1], soup.corners[3]);
    const Scene scene = make_scene(soup, {.snap = "", .one_sided = true});
    const BspTree tree(scene);
    VisibilityMap map;
    const Camera camera{{0, 0, 0}, {0, 1, 0}, {2, 0, 0}, {0, 0, 2}};
    Tracer(tree).trace(camera, map);
    const Reference reference(map);
    EXPECT_EQ(reference.visible(), backwards ? 0u : 1u);
    for (const std::string& kind : image_space) {
      const Error error = reference.error_of(of_pixels(kind, scene, 20)->view(camera, 1).answer);
      EXPECT_EQ(error.missed + error.falsely, 0u) << kind;
      EXPECT_LT(error.wrong_area, 1e-12) << kind;  // the square's sides are sides of pixels
    }
  }
}

TEST(Guard, EndsWhatDoesNotEndAndSurvivesWhatCrashes) {
  const Limits limits{1, 1};
  EXPECT_EQ(run_guarded([] { return std::string("fine"); }, limits).bytes, "fine");
  EXPECT_EQ(run_guarded([] { return std::string(); }, limits).why, "");
  EXPECT_EQ(run_guarded([]() -> std::string { throw std::runtime_error("no luck"); }, limits).why, "no luck");
  EXPECT_NE(run_guarded(
                []() -> std::string {
                  std::raise(SIGKILL);
                  return {};
                },
                limits)
                .why,
            "");
  EXPECT_NE(run_guarded(
                []() -> std::string {
                  std::signal(SIGABRT, SIG_DFL);
                  std::abort();
                },
                limits)
                .why.find("ended by signal"),
            std::string::npos);
  EXPECT_EQ(run_guarded(
                []() -> std::string {
                  for (volatile bool on = true; on;) {
                  }
                  return {};
                },
                limits)
                .why,
            "took too long");
  // What it does to memory stays there.
  int here = 1;
  EXPECT_EQ(run_guarded([&] { return std::to_string(++here); }, limits).bytes, "2");
  EXPECT_EQ(here, 1);
}

}  // namespace
}  // namespace sightline::comparison
