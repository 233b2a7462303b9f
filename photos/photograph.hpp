// A photograph that knows what its pixels show.
#pragma once

#include "photos/image.hpp"
#include "photos/photo_frame.hpp"
#include "photos/pixel_owners.hpp"

namespace sightline {

/// A colour found in a photograph, or none.
struct PhotoSample {
  enum Kind : std::uint8_t {
    nothing,
    borrowed,  // no pixel around the place may be used: the nearest that may
    direct     // of the pixels around the place that may be used, by their bilinear weights
  } kind = nothing;
  glm::dvec3 colour{0};
};

class Photograph {
 public:
  /// Throws std::invalid_argument where image and owners differ in size.
  Photograph(const Scene& scene, const Camera& camera, Image image, PixelOwners owners);

  const PhotoFrame& frame() const { return frame_; }
  const Image& image() const { return image_; }
  const PixelOwners& owners() const { return owners_; }
  /// The polygon's colour at a place of the photograph, from pixels that it owns only; to borrow, up to `reach` pixels
  /// away from the pixel of the place, of equally near ones the first in the rows.
  PhotoSample sample(PolygonId polygon, const glm::dvec2& place, int reach) const;

 private:
  PhotoFrame frame_;
  Image image_;
  PixelOwners owners_;
};

/// Throws InputError, one line that begins with `name`, unless one side has the number of pixels that the camera's
/// window asks for beside the other, to within one.
void check_aspect(const Image& image, const Camera& camera, const std::string& name);

}  // namespace sightline
