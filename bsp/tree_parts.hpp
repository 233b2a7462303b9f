// Surfaces, and pieces of them, on their way to their nodes in a polygon tree.
#pragma once

#include "bsp/pieces.hpp"
#include "bsp/tree_surfaces.hpp"

namespace sightline {

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
  void extend(TreeExtent& extent, TreePart p) const {
    extent.box.add(box(p));
    extent.spread = std::max(extent.spread, wholes_.spread(surface(p)));
    if (frame().turned()) extent.along.add(along(p));
  }
  /// How many parts from this one on are a whole block of surfaces, 0 or all of `surface_block`.
  std::size_t block_at(std::span<const TreePart> parts) const {
    if (parts.size() < surface_block || parts[0] % surface_block != 0) return 0;
    if (parts[surface_block - 1] != parts[0] + surface_block - 1 || !whole(parts[surface_block - 1])) return 0;
    std::uint32_t other = 0;
    for (std::uint32_t k = 0; k < surface_block; ++k) other |= parts[k] ^ (parts[0] + k);
    return other == 0 ? surface_block : 0;
  }
  const TreeExtent& block(TreePart first) const { return wholes_.block(first); }
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
  void take_all(TreeLoad& load, TreeExtent& extent) const;
  /// Names the plane that the next two speak of.
  void aim(PlaneId plane);
  /// Bit 0: partly behind the plane, bit 1: partly in front; 0: in the plane.
  int sides(TreePart p) {
    const int clear = clear_side(along(p));
    return clear ? clear : exact_sides(p);
  }
  /// Where a whole block lies, as above; 0: the plane may pass through it.
  int clear_side(const TreeExtent& block) const { return clear_side(frame().turned() ? block.along : block.box); }
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
  /// The box has 2^-24 to spare on every side. A plane across an axis loses at most 2^-25 as a float; the sum for any
  /// other, of a normal of at least 1/2, is far less off than what a box has to spare along it.
  int clear_side(const RoundedBox& box) const {
    if (axis_ >= 0) return box.low[axis_] > at_ ? 2 : box.high[axis_] < at_ ? 1 : 0;
    double middle = -d_, reach = 0;
    for (int k = 0; k < 3; ++k) {
      middle += normal_[k] * (static_cast<double>(box.low[k]) + box.high[k]) * 0.5;
      reach += std::abs(normal_[k]) * (static_cast<double>(box.high[k]) - box.low[k]) * 0.5;
    }
    return middle > reach ? 2 : middle < -reach ? 1 : 0;
  }
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
