#include "visibility_map/draw.hpp"

#include "tests/visibility_map/sketch.hpp"

#include <cairo.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace sightline {
namespace {

Scene scene() { return make_scene(SquareBeforeWall::polygons()); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Tags in pairs, attributes in quotes, no stray markup: enough for what map_svg writes.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  std::size_t roots = 0;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] != '<') {
      const std::size_t next = std::min(xml.find('<', at), xml.size());
      const std::string text = xml.substr(at, next - at);
      if (text.find('>') != std::string::npos) return false;
      if (open.empty() && text.find_first_not_of("\n ") != std::string::npos) return false;
      at = next;
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (end == std::string::npos) return false;
    std::string tag = xml.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.find('<') != std::string::npos || count(tag, "\"") % 2 != 0) return false;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else {
      roots += open.empty();
      if (tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
    }
  }
  return open.empty() && roots == 1;
}

TEST(Svg, OnePathAFaceAndAnEdge) {
  const std::string svg = map_svg(SquareBeforeWall::map(), scene(), 200);
  EXPECT_TRUE(well_formed(svg)) << svg;
  EXPECT_EQ(count(svg, "<path class=\"face\""), 2u);
  EXPECT_EQ(count(svg, "data-polygon=\"0\""), 1u);
  EXPECT_EQ(count(svg, "data-polygon=\"1\""), 1u);
  EXPECT_EQ(count(svg, "<path class=\"silhouette\" data-owner=\"1\""), 4u);
  EXPECT_EQ(count(svg, "<path class=\"window\""), 4u);
  EXPECT_EQ(count(svg, "<title>sketch.obj</title>"), 1u);
  EXPECT_EQ(count(svg, "width=\"200\" height=\"200\" viewBox=\"0 0 200 200\""), 1u);
  // t runs upwards, y downwards: the outer loop begins at s = t = 0, which is the lower left corner.
  EXPECT_EQ(count(svg, "d=\"M0 200L200 200L200 0L0 0ZM50 150L50 50L150 50L150 150Z\""), 1u) << svg;
}

TEST(Svg, NothingIsAFaceToo) {
  VisibilityMap map = SquareBeforeWall::map();
  map.faces[0].polygon = none;
  PolygonSoup named = SquareBeforeWall::polygons();
  named.source = "<a&b>.obj";
  const std::string svg = map_svg(map, make_scene(named));
  EXPECT_TRUE(well_formed(svg));
  EXPECT_EQ(count(svg, "data-polygon=\"none\""), 1u);
  EXPECT_EQ(count(svg, "<title>&lt;a&amp;b&gt;.obj</title>"), 1u);
}

TEST(Svg, OptionsLeaveOut) {
  const VisibilityMap map = SquareBeforeWall::map();
  EXPECT_EQ(count(map_svg(map, scene(), {.silhouettes = false}), "<path class=\"silhouette\""), 0u);
  const std::string lines = map_svg(map, scene(), {.fill = DrawOptions::Fill::empty});
  EXPECT_EQ(count(lines, "<path class=\"face\""), 2u);
  EXPECT_EQ(count(lines, "fill=\"none\""), 2u);
}

TEST(Svg, HeightFollowsTheCamera) {
  VisibilityMap map = SquareBeforeWall::map();
  map.camera.right = {2, 0, 0};
  EXPECT_EQ(count(map_svg(map, scene(), 300), "height=\"150\""), 2u);
  map.camera.right = {1e-6, 0, 0};
  EXPECT_THROW(map_svg(map, scene(), 300), std::invalid_argument);
  EXPECT_THROW(map_svg(map, scene(), 0), std::invalid_argument);
  map.sphere = true;
  EXPECT_THROW(map_svg(map, scene()), std::invalid_argument);
}

/// A picture in memory.
struct Picture {
  Picture(const VisibilityMap& map, const DrawOptions& options)
      : surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, options.width, options.width)) {
    cairo_t* context = cairo_create(surface);
    paint_map(context, map, scene(), options);
    cairo_destroy(context);
    cairo_surface_flush(surface);
  }
  explicit Picture(const std::filesystem::path& png)
      : surface(cairo_image_surface_create_from_png(png.string().c_str())) {}
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  ~Picture() { cairo_surface_destroy(surface); }

  int width() const { return cairo_image_surface_get_width(surface); }
  int height() const { return cairo_image_surface_get_height(surface); }
  Colour at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface);
    const auto pixel = reinterpret_cast<const std::uint32_t*>(row)[x];
    return {static_cast<std::uint8_t>(pixel >> 16), static_cast<std::uint8_t>(pixel >> 8),
            static_cast<std::uint8_t>(pixel)};
  }
  cairo_surface_t* surface;
};

bool same(Colour a, Colour b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

TEST(Picture, EachFaceHasItsColour) {
  const VisibilityMap map = SquareBeforeWall::map();
  for (const auto fill : {DrawOptions::Fill::polygon, DrawOptions::Fill::shaded}) {
    const DrawOptions options{.width = 1000, .fill = fill};
    const Scene polygons = scene();
    const Drawing drawing(map, polygons, options);
    const Picture picture(map, options);
    EXPECT_TRUE(same(picture.at(500, 500), drawing.fill(map.faces[1])));
    for (const int k : {100, 900}) {
      EXPECT_TRUE(same(picture.at(k, k), drawing.fill(map.faces[0])));
      EXPECT_TRUE(same(picture.at(k, 1000 - k), drawing.fill(map.faces[0])));
    }
    EXPECT_LT(picture.at(250, 500).r, 60);  // a silhouette
  }
}

TEST(Picture, OrientationShadesAndIndicesTellApart) {
  const VisibilityMap map = SquareBeforeWall::map();
  const Scene polygons = scene();
  const Drawing colours(map, polygons, {});
  EXPECT_FALSE(same(colours.fill(map.faces[0]), colours.fill(map.faces[1])));
  const Drawing grey(map, polygons, {.fill = DrawOptions::Fill::shaded});
  EXPECT_TRUE(same(grey.fill(map.faces[0]), grey.fill(map.faces[1])));
  MapFace nothing = map.faces[0];
  nothing.polygon = none;
  EXPECT_TRUE(same(colours.fill(nothing), Drawing::paper));
}

TEST(Picture, NoGapsBetweenFacesWithoutLines) {
  VisibilityMap map = SquareBeforeWall::map();
  for (std::uint32_t v = 4; v < 8; ++v) map.vertices[v].st += glm::dvec2(0.0013, 0.0029);  // off the pixels' borders
  const Picture picture(map, {.width = 200, .edges = false, .silhouettes = false});
  const Scene polygons = scene();
  const Drawing drawing(map, polygons, {});
  const Colour a = drawing.fill(map.faces[0]), b = drawing.fill(map.faces[1]);
  for (int x = 0; x < 200; ++x) {  // every pixel is a mixture of the two colours, none shows paper
    const Colour c = picture.at(x, 100);
    EXPECT_TRUE(c.r >= std::min(a.r, b.r) - 1 && c.r <= std::max(a.r, b.r) + 1 && c.g >= std::min(a.g, b.g) - 1 &&
                c.g <= std::max(a.g, b.g) + 1 && c.b >= std::min(a.b, b.b) - 1 && c.b <= std::max(a.b, b.b) + 1)
        << x;
  }
}

TEST(Files, PngAndPdf) {
  const VisibilityMap map = SquareBeforeWall::map();
  const auto folder = std::filesystem::temp_directory_path() / "sightline-draw-test";
  std::filesystem::create_directories(folder);
  const auto content = [](const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  write_map_png(folder / "a.png", map, scene(), 120);
  EXPECT_EQ(content(folder / "a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
  const Picture png(folder / "a.png"), memory(map, {.width = 120});
  ASSERT_EQ(png.width(), 120);
  ASSERT_EQ(png.height(), 120);
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 120; ++x) ASSERT_TRUE(same(png.at(x, y), memory.at(x, y)));
  }
  write_map_pdf(folder / "a.pdf", map, scene(), 120);
  write_map_pdf(folder / "b.pdf", map, scene(), {.width = 120});
  const std::string pdf = content(folder / "a.pdf");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("%%EOF"), std::string::npos);
  EXPECT_EQ(pdf, content(folder / "b.pdf"));
  EXPECT_THROW(write_map_png(folder / "missing" / "a.png", map, scene()), std::system_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace sightline
