// A conservative item buffer: what surely covers each pixel, whole. For this folder's own use.
#pragma once

#include <span>
#include <vector>

#include "scene/camera.hpp"
#include "scene/scene.hpp"

namespace sightline {

/// Of each pixel of the window, how near the nearest surface is that covers all of it. It is used for one thing: to
/// prove that a figure is hidden, because in every pixel that it may touch something that covers the pixel is nearer
/// all over it. All bounds are on the safe side, so a proof is right whatever the number of pixels; what cannot be
/// proven is decided elsewhere. (Yu's buffer holds the polygon in the middle of each pixel, and what is less than a
/// pixel wide is lost on it.) The paper's ids are not needed: not who covers a pixel matters, but that someone does.
class CoverBuffer {
 public:
  /// `size` pixels in each direction; the surfaces that may cover them.
  CoverBuffer(const Scene& scene, const Camera& camera, std::span<const SurfaceId> surfaces, int size);

  /// Is a convex figure of the plane hidden, as far as it is in the window at all? Corners in unit coordinates, each
  /// within 2^-46, counter-clockwise seen from the plane's front, or the other way round if `backwards`.
  bool hides(std::span<const glm::dvec3> corners, PlaneId plane, bool backwards) const;
  /// The same by samples, uniform on the figure, about one a pixel: the pixels in the neighbourhood of each are looked
  /// at, chosen so that the neighbourhoods hold all of the figure. What reaches behind the eye is not proven.
  bool hides_by_samples(std::span<const glm::dvec3> corners, PlaneId plane) const;
  int size() const { return size_; }

 private:
  /// c + s x + t y over the pixels: (x, y) is the corner of pixel x, y.
  struct Linear {
    double c, x, y;
  };
  /// Inverse depth over the window, and how far it may be off; false: the plane all but holds the eye.
  bool inverse_depth(PlaneId plane, Linear& w, double& error) const;
  /// The sides of a cone over a figure, inside positive, all off by `error` at most.
  void cone(std::span<const glm::dvec3> corners, double turn, std::vector<Linear>& sides, double& error) const;
  Linear over_pixels(const glm::dvec3& normal) const;
  struct Samples;
  bool hides_triangle(const Samples& samples, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const;
  void cover(std::span<const glm::dvec3> corners, PlaneId plane, std::vector<Linear>& sides);

  const Scene& scene_;
  int size_;
  glm::dvec3 eye_{0}, corner_{0}, right_{0}, up_{0};  // the window's corner (0, 0) and its sides, scaled to 1 at most
  double reach_ = 0;                                  // of the eye's coordinates
  std::vector<float> nearest_;                        // inverse depths, rounded down; 0: nothing covers it
};

/// The number of pixels along a side for a camera in whose window so many surfaces may be seen: a power of two, about
/// eight pixels to a surface's width, were all of them in view side by side, from 64 to 512 (measured: docs/clip.md);
/// all cameras' buffers together below 256 MiB, for as long as a side has 64.
int chosen_size(std::size_t surfaces, std::size_t cameras);

}  // namespace sightline
