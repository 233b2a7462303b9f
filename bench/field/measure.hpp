// A field measured over an animation.
#pragma once

#include "sample/field.hpp"
#include "sample/field_query.hpp"
#include "sample/id_buffer.hpp"

#include <optional>

namespace sightline::bench {

/// Means of a frame. Times are the thread's own processor time.
struct Frame {
  double cells = 0, triangles = 0;  // marked
  double look_up = 0, draw = 0;     // seconds: finding the marks, drawing what is marked
  double wrong = 0;                 // part of the picture's pixels that differ from the picture of everything
};

/// What does not depend on how things are marked: pictures of everything, and what they take.
class Stage {
 public:
  /// `pixels`: along both sides of the pictures.
  Stage(const Scene& scene, std::vector<Camera> cameras, std::uint32_t pixels);

  Frame look_up(const Field& field, const FieldQueryOptions& options);
  Frame trace(const RayCaster& caster, const FieldCells& cells, std::uint32_t subsample);
  double draw_all() const { return draw_all_; }  // seconds a frame
  std::uint32_t pixels() const { return buffer_.size(); }

 private:
  template <class Mark>
  Frame measured(const FieldCells& cells, const Mark& mark);

  const Scene& scene_;
  std::vector<Camera> cameras_;
  IdBuffer buffer_;
  std::vector<std::vector<PolygonId>> whole_;
  double draw_all_ = 0;
};

/// A grid for each object with a number of cells as near to the wanted one as there is.
FieldCells cells_near(const Scene& scene, std::uint32_t wanted);

}  // namespace sightline::bench
