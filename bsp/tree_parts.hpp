// Surfaces, and pieces of them, on their way to their nodes in a polygon tree.
#pragma once

#include <algorithm>
#include <atomic>

#include "bsp/pieces.hpp"
#include "bsp/tree.hpp"
#include "bsp/tree_frame.hpp"

namespace sightline {

/// Bounds in floats that hold what they bound, with at least 2^-24 to spare: a float is within 2^-24 of a number below
/// 2, and coordinates, along a frame too, are below 1.8. Their own rounding is far below that.
struct RoundedBox {
  float low[3] = {2, 2, 2}, high[3] = {-2, -2, -2};

  void add(const glm::dvec3& least, const glm::dvec3& most) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], static_cast<float>(least[k] - 0x1p-23));
      high[k] = std::max(high[k], static_cast<float>(most[k] + 0x1p-23));
    }
  }
  void add(const RoundedBox& other) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], other.low[k]);
      high[k] = std::max(high[k], other.high[k]);
    }
  }
};

/// What is told of whole surfaces before any is cut or kept. Shared by all who divide nodes.
class TreeSurfaces {
 public:
  explicit TreeSurfaces(const Scene& scene);
  const Scene& scene() const { return scene_; }
  const TreeFrame& frame() const { return frame_; }
  const RoundedBox& box(SurfaceId s) const { return box_[s]; }
  /// Bounds along the frame.
  const RoundedBox& along(SurfaceId s) const { return turned_.empty() ? box_[s] : turned_[s]; }
  float area(SurfaceId s) const;
  /// At least the diagonal of the bounding box of the surface's polygon.
  float spread(SurfaceId s) const { return spread_[s]; }
  /// A surface may have a corner that is no point of the scene; there is nothing more about it here.
  bool has_points(SurfaceId s) const { return box_[s].low[0] <= box_[s].high[0]; }
  template <class F>
  void for_corners(SurfaceId s, F&& f) const {
    for (const SurfaceEdge& e : scene_.edges(scene_.surfaces()[s])) f(scene_.points().approx(e.corner));
  }
  std::size_t bytes() const {
    return box_.size() * (sizeof(RoundedBox) + 2 * sizeof(float)) + turned_.size() * sizeof(RoundedBox);
  }

 private:
  void find_spreads();

  const Scene& scene_;
  TreeFrame frame_;
  std::vector<RoundedBox> box_, turned_;
  std::vector<float> spread_;
  std::unique_ptr<std::atomic<float>[]> area_;  // 0: not asked for yet; whoever asks finds the same
};

/// A piece that planes have cut off.
struct CutPart {
  SurfaceId surface;
  std::uint32_t first, count;  // its corners in the arena
  float area;
  RoundedBox box, turned;
};

/// A whole surface by its id, or beyond all ids a cut part by its place in the arena.
using TreePart = std::uint32_t;

/// What waits at one node.
struct TreeLoad {
  std::vector<TreePart> parts;
  RoundedBox along;          // of all parts, along the frame
  std::vector<CutPart> cut;  // the arena that parts refer to, and their corners
  std::vector<PieceCorner> corners;

  std::size_t bytes() const {
    return parts.size() * sizeof(TreePart) + cut.size() * sizeof(CutPart) + corners.size() * sizeof(PieceCorner);
  }
};

/// Looks at parts and cuts them. Cut ones lie in an arena, which may be cut back.
class TreeParts {
 public:
  explicit TreeParts(const TreeSurfaces& wholes)
      : wholes_(wholes),
        count_(static_cast<std::uint32_t>(wholes.scene().surfaces().size())),
        pieces_(wholes.scene(), wholes.scene().planes()) {}

  bool whole(TreePart p) const { return p < count_; }
  SurfaceId surface(TreePart p) const { return whole(p) ? p : cut_[p - count_].surface; }
  PlaneId plane(TreePart p) const { return wholes_.scene().surfaces()[surface(p)].plane; }
  const RoundedBox& box(TreePart p) const { return whole(p) ? wholes_.box(p) : cut_[p - count_].box; }
  const RoundedBox& along(TreePart p) const {
    if (whole(p)) return wholes_.along(p);
    const CutPart& c = cut_[p - count_];
    return frame().turned() ? c.turned : c.box;
  }
  float spread(TreePart p) const { return wholes_.spread(surface(p)); }
  float area(TreePart p) const { return whole(p) ? wholes_.area(p) : cut_[p - count_].area; }
  /// Calls with the unit coordinates of each corner, in order.
  template <class F>
  void for_corners(TreePart p, F&& f) const {
    if (whole(p)) {
      wholes_.for_corners(p, f);
    } else {
      for (const PieceCorner& c : corners(p)) f(c.place.approx);
    }
  }
  /// Of a cut part.
  std::span<const PieceCorner> corners(TreePart p) const { return pieces_.corners(piece(p)); }
  const Pieces& pieces() const { return pieces_; }
  const TreeFrame& frame() const { return wholes_.frame(); }

  /// All surfaces of the scene.
  void take_all(TreeLoad& load);
  /// Names the plane that the next two speak of.
  void aim(PlaneId plane);
  /// Bit 0: partly behind the plane, bit 1: partly in front; 0: in the plane.
  int sides(TreePart p);
  /// Cuts the part, which lies on both sides, as found by sides() just before.
  void split(TreePart p, TreePart& behind, TreePart& front);

  /// Exchanges the arena with the load's.
  void swap_arena(TreeLoad& load);
  /// Moves the parts into a load, with what they need of the arena.
  void pack(std::vector<TreePart>& parts, TreeLoad& load) const;
  struct Mark {
    std::size_t cut = 0, corners = 0;
  };
  Mark mark() const { return {cut_.size(), pieces_.corner_count()}; }
  void truncate(const Mark& mark);

 private:
  Piece piece(TreePart p) const {
    const CutPart& c = cut_[p - count_];
    return {c.surface, wholes_.scene().surfaces()[c.surface].plane, c.first, c.count, {}, {}};
  }
  TreePart add(const Piece& piece);
  int exact_sides(TreePart p);

  const TreeSurfaces& wholes_;
  const std::uint32_t count_;
  Pieces pieces_;
  std::vector<CutPart> cut_;
  PlaneId plane_ = none;
  glm::dvec3 normal_{0};  // of the plane, along the frame
  double d_ = 0;
  int axis_ = -1;  // across which it lies, in a frame that is not turned
  float at_ = 0;   // and where
};

}  // namespace sightline
