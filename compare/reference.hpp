// The exact map of a view, and how far an answer is from it.
#pragma once

#include "compare/answer.hpp"

namespace sightline::comparison {

/// Of one view. Where polygons lie in the same place, any of them is right.
struct Error {
  std::uint32_t missed = 0;   // polygons seen, and neither reported nor one in the same place as they
  std::uint32_t falsely = 0;  // polygons reported, and neither seen nor in the same place as one seen
  double wrong_area = 0;      // part of the window that shows another polygon than the exact map
  double worst_area = 0;      // of one polygon: what is wrongly its own and what wrongly is not, together
};

/// The exact map as a measure. Areas are measured, not sampled: pixels are cut out of the exact faces, drawings are
/// laid over it stretch by stretch; in doubles, from the exact vertices rounded once each. An area is right to some
/// 1e-12 for a drawing or for pixels whose boundaries are those of the map; equal drawings differ by exactly 0.
///
/// Laws. 1: an answer that is the map has no error. 2: exchanging polygon a for b everywhere in an answer that is right
/// changes the wrong area by what a occupies. 3: wrong_area is at most 1, worst_area at most 1; worst_area is at least
/// wrong_area over the number of polygons seen or shown. 4: an answer of one pixel is the polygon's part of the window.
class Reference {
 public:
  explicit Reference(const VisibilityMap& map);

  Error error_of(const Answer& answer) const;
  /// Of a method that has no answer: all that is seen is missed.
  Error error_of_nothing() const;
  std::size_t visible() const { return visible_.size(); }

 private:
  bool shows(std::uint32_t face, PolygonId polygon) const;
  void count(const Answer& answer, Error& error) const;

  Drawing drawing_;
  std::vector<PolygonId> visible_;                // ascending
  std::vector<std::vector<PolygonId>> same_;      // of each face: polygons in the same place
  std::vector<std::vector<PolygonId>> stand_in_;  // of each visible polygon: the same, ascending
  std::vector<PolygonId> excused_;                // all of them, ascending
};

}  // namespace sightline::comparison
