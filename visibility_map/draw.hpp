// What all drawings of a map have in common: the frame, colours and strokes.
#pragma once

#include "visibility_map/write.hpp"

using cairo_t = struct _cairo;

namespace sightline {

/// sRGB, 8 bits a channel.
struct Colour {
  std::uint8_t r, g, b;
};

/// A line's look, in pixels of the drawing.
struct Stroke {
  double width;
  Colour colour;
  double opacity;
};

/// A flat part of a drawing: its outline in the window, and how it is filled. In SVG, `what` is its data-cameras.
struct DrawnPatch {
  std::vector<glm::dvec2> st;
  Colour colour;
  std::uint32_t what;
};

/// The frame of a drawing and the look of all that stands in it.
class Drawing {
 public:
  /// Throws std::invalid_argument as map_svg does.
  Drawing(const VisibilityMap& map, const Scene& scene, const DrawOptions& options);

  int width() const { return options_.width; }
  int height() const { return height_; }
  /// The paper's place of a point of the window: x to the right, y downwards.
  glm::dvec2 place(const glm::dvec2& st) const { return {st.x * width(), (1 - st.y) * height_}; }
  static constexpr Colour paper{250, 249, 246};
  /// The fill of what a face sees (`paper` where that is nothing).
  Colour fill(const MapFace& face) const;
  Stroke stroke(EdgeKind kind) const;
  bool drawn(EdgeKind kind) const;
  /// Width of the line in its own colour around each face: with a pixel, antialiased neighbours leave no gap.
  static constexpr double seal = 1;
  const DrawOptions& options() const { return options_; }
  /// How a polygon faces a lamp above and left behind the camera, from 0 to 1.
  double light(PolygonId polygon) const;

 private:
  const Scene& scene_;
  Camera camera_;
  DrawOptions options_;
  int height_ = 0;
  double scale_ = 1;      // of line widths
  double fineness_[5]{};  // by kind: 1 for long edges, less where edges are only a few pixels long
};

/// Colour of lightness, chroma and hue (turns) in Oklab (B. Ottosson, 2020), clamped to sRGB.
Colour oklch(double lightness, double chroma, double hue);

/// Draws a map with its frame at (0,0) of the context's user space; patches, if there are any, in place of the faces.
void paint_map(cairo_t* context, const VisibilityMap& map, const Scene& scene, const DrawOptions& options,
               std::span<const DrawnPatch> patches = {});
/// As map_svg and write_map_png, patches in place of the faces.
std::string patches_svg(std::span<const DrawnPatch> patches, const VisibilityMap& map, const Scene& scene,
                        const DrawOptions& options);
void write_patches_png(const std::filesystem::path& file, std::span<const DrawnPatch> patches, const VisibilityMap& map,
                       const Scene& scene, const DrawOptions& options);

}  // namespace sightline
