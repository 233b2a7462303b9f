// Exact convex parts of the window. For this folder's own use.
#pragma once

#include "exact/window.hpp"

#include <glm/vec2.hpp>
#include <vector>

namespace sightline {

/// A convex region of the window: sides with normals inwards, counter-clockwise as seen from the eye by a right-handed
/// viewer; the corner between side i and the next side j is the ray n_j x n_i. Empty: no sides.
struct ConvexView {
  std::vector<SightlineRef> sides;
  bool empty() const { return sides.empty(); }
};

/// Operations on views of one window. Laws: clip(v, k) and clip(v, -k) share no interior point and make up v; clip(v,
/// k) is v or smaller; clip(clip(v, k), k) = clip(v, k); areas of disjoint parts sum to that of the whole.
class ViewClipper {
 public:
  ViewClipper(SightlineTable& table, const Window& window) : table_(table), window_(window) {}

  ConvexView whole() const;
  /// The part on the inner side of k; empty where it has no interior.
  ConvexView clip(const ConvexView& view, SightlineRef k) const;
  /// The parts of `view` that lie outside of `other`: disjoint.
  std::vector<ConvexView> subtract(ConvexView view, const ConvexView& other) const;
  /// Corner i, the end of side i, as window coordinates, to the nearest doubles.
  std::vector<glm::dvec2> corners(const ConvexView& view) const;
  /// Part of the window.
  double area(const ConvexView& view) const;
  /// Side of k on which corner i lies.
  Sign corner_side(const ConvexView& view, std::size_t i, SightlineRef k) const {
    return table_.order(view.sides[(i + 1) % view.sides.size()], view.sides[i], k);
  }

 private:
  SightlineTable& table_;
  const Window& window_;
};

}  // namespace sightline
