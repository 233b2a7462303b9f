// Lines by two planes, (u,v) and (s,t): the parameterisation of light fields, as many pairs of planes as are wanted.
// (Blais and Poulin, Sampling visibility in three-space, sections 2.2 and 3.)
#pragma once

#include "scene/camera.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

namespace sightline {

/// corner + a across + b upwards, a and b in [0,1], in world coordinates.
struct FieldPlane {
  glm::dvec3 corner{0}, across{0}, upwards{0};
  bool operator==(const FieldPlane&) const = default;
};

/// A box along the axes, in world coordinates.
struct FieldBox {
  glm::dvec3 low{0}, high{0};
};

/// A slab: the lines that run from a point of one plane to a point of another, parallel one, or, with `infinite`, along
/// one of the directions uv through a point of st. A line is st + k d, where d is the direction or st - uv; its ray
/// begins at k = begin, and the viewers for whom the slab is made look out from somewhere in begin <= k <= end: with
/// end > begin all that the ray meets until `end` is seen by one of them, and the first that it meets after that.
struct FieldSlab {
  bool infinite = true;
  FieldPlane uv, st;
  double begin = 0, end = 0;
  bool operator==(const FieldSlab&) const = default;
};

/// Six slabs for viewers outside of the box: all lines that meet it, each in the slab of the axis and direction that it
/// runs along most. The plane st lies in the middle of the box; uv at infinity, or, for a distance > 0, so many times
/// the box's longest side before st.
std::vector<FieldSlab> slabs_around(const FieldBox& box, double distance = 0);
/// Six slabs for viewers in the box `view`, looking out in all directions.
std::vector<FieldSlab> slabs_within(const FieldBox& view);
/// One slab for viewers before the side `axis` (0, 1, 2) of the box, on its lower (`upper` false) or upper end, as in
/// the paper's examples: uv at infinity, directions up to `slope` off the axis, st on that side of the box.
FieldSlab slab_before(const FieldBox& box, int axis, bool upper, double slope);
/// Slabs from a text file: `#` comments, a slab a line, `plane` or `infinity` and 18 numbers: corner, across and
/// upwards of uv and of st. Rays begin at uv, or before the box. Throws InputError: no slab, numbers missing or not
/// finite, planes without area or not parallel, directions along the plane st.
std::vector<FieldSlab> read_slabs(const std::filesystem::path& file, const FieldBox& box);

/// The ray of a slab through (u,v,s,t), each in [0,1].
struct FieldRay {
  glm::dvec3 origin, direction;
};
FieldRay ray_of(const FieldSlab& slab, const std::array<double, 4>& uvst);

/// Where the rays of a camera meet the planes of a slab: u, v, s and t are quotients of linear functions of the window.
///
/// Laws. 1: a ray of the slab, seen from a point of it in the window, has its own (u,v,s,t) there. 2: nothing is told
/// of lines that run the other way.
class SlabView {
 public:
  SlabView(const FieldSlab& slab, const Camera& camera);

  /// A linear function of the window's (s,t).
  struct Linear {
    double at = 0, s = 0, t = 0;
    double operator()(double x, double y) const { return at + s * x + t * y; }
  };
  /// Of u, v, s, t in turn: its value is numerator / denominator, in the slab where 0 <= numerator <= denominator and
  /// the denominator is positive.
  const std::array<Linear, 4>& numerators() const { return numerators_; }
  const Linear& uv_denominator() const { return uv_; }
  const Linear& st_denominator() const { return st_; }

 private:
  std::array<Linear, 4> numerators_;
  Linear uv_, st_;
};

}  // namespace sightline
