#include "beam/front_to_back.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "beam/box_groups.hpp"
#include "beam/patches.hpp"

namespace sightline {
namespace {

/// An open patch with more sides than this is split in two.
constexpr std::uint32_t most_sides = 96;

class FrontToBack : public Engine {
 public:
  FrontToBack(const BspTree& tree, double min_angle, double max_distance)
      : Engine(tree.scene(), tree.scene().planes(), max_distance), tree_(tree), min_angle_(min_angle) {}

  std::unique_ptr<Engine> copy() const override {
    return std::make_unique<FrontToBack>(tree_, min_angle_, view.reach.distance());
  }
  void fill(std::span<const SightlineRef> window, const glm::dvec3& ahead) override;

 private:
  void begin() override;
  /// Open patches stand on a stack; a node is given those from `first` up, and leaves there what remains of them.
  void visit(TreeNode& node, std::size_t first);
  void descend(TreeNode* child, std::size_t first);
  Sign eye_side(const TreeNode& node);
  Sign exact_side(const TreeNode& node) const;
  void outline(const TreePiece& piece, Sign eye);
  bool in_window(const TreeBox& box, FrameBox& bounds) const;
  bool in_sight(const TreeBox& box, std::size_t first);
  bool carve(const Patch& patch, const TreePiece& piece, Sign eye, Patch& inside, Patch& outside);
  void keep_open(Patch patch);
  bool halve(const Patch& patch, Patch& a, Patch& b);
  void take_out(const TreeNode& node, Sign eye, std::size_t first);
  void see(const Patch& patch, std::span<const SurfaceId> on);

  /// What has been seen in the plane of a node.
  struct Seen {
    Patch patch;
    std::uint32_t last;  // in seen_on_
  };
  /// Surfaces that share a place, linked from the last one on. Patches that are cut share what comes before: of n
  /// copies of a polygon there are n links, where lists of their own would hold n^2 / 2 surfaces.
  struct SeenOn {
    SurfaceId surface;
    std::uint32_t before;  // in seen_on_; none: it is the first
  };

  void add_seen(const Seen& seen) {
    seen_.push_back(seen);
    seen_boxes_.push(seen.patch.bounds);
  }

  const BspTree& tree_;
  const double min_angle_;
  Frame frame_;
  Patches patches_;
  ViewScale scale_;
  std::vector<glm::dvec3> window_;  // the normals of its sides
  std::vector<Patch> open_, slivers_, parts_;
  FrameBox piece_bounds_;            // of the piece looked at
  Cone cone_;                        // what is seen of it, once it is needed
  std::vector<SightlineRef> lines_;  // its outline, once it is needed
  std::vector<Seen> seen_;
  BoxGroups seen_boxes_;
  std::vector<SeenOn> seen_on_;
  std::vector<SurfaceId> on_;
  std::vector<float> middles_;
};

void FrontToBack::begin() {
  scale_.set(view.table.eye_approx());
  cone_.piece = nullptr;
}

Sign FrontToBack::eye_side(const TreeNode& node) {
  if (node.plane != none) return view.table.eye_side(node.plane);
  // The normal's components are at most 1, the eye's S: three products and their sum are within 2^-50 S.
  const double value = glm::dot(node.normal, scale_.eye) - node.d;
  if (std::abs(value) > scale_.point) return value > 0 ? 1 : -1;
  return exact_side(node);
}

/// By rationals: where an eye is so near a plane in free space.
Sign FrontToBack::exact_side(const TreeNode& node) const {
  const GridPoint& eye = view.table.eye();
  mpq_class value = -mpq_class(node.d), unit = 1;
  const int bits = view.scene.grid().unit_bits() + eye.shift;
  mpq_div_2exp(unit.get_mpq_t(), unit.get_mpq_t(), static_cast<mp_bitcnt_t>(std::max(bits, 0)));
  mpq_mul_2exp(unit.get_mpq_t(), unit.get_mpq_t(), static_cast<mp_bitcnt_t>(std::max(-bits, 0)));
  for (int k = 0; k < 3; ++k) value += mpq_class(node.normal[k]) * eye.c[static_cast<std::size_t>(k)] * unit;
  return sgn(value);
}

/// Lines of the piece's outline, their normals pointing inwards, counter-clockwise as the eye sees it. Edges run
/// counter-clockwise seen from the front of the plane, and (a - eye) x (b - eye) points outwards for an eye there. With
/// P and Q the values of the piece's plane and a cutting one, P(eye) n_q - Q(eye) n_p is P(eye) Q(x) at a point x of
/// the piece.
void FrontToBack::outline(const TreePiece& piece, Sign eye) {
  lines_.clear();
  const PlaneId plane = view.scene.surfaces()[piece.surface].plane;
  for (std::uint32_t k = 0; k < piece.count; ++k) {
    const TreeEdge& e = piece.edge[k];
    SightlineRef line = e.a != none ? view.table.of_points(e.a, e.b) : view.table.of_planes(plane, e.cut);
    line.sign *= e.a != none ? -eye : eye * e.inside;
    patches_.name_line(line.id, line_name(piece, k));
    if (min_angle_ > 0) {
      view.fragments.origins.push_back({line.id, e.a != none, {e.a != none ? e.a : plane, e.a != none ? e.b : e.cut}});
    }
    lines_.push_back(line);
  }
  if (eye < 0) std::reverse(lines_.begin(), lines_.end());
}

/// May the box meet the window? Gives its bounds in the frame.
bool FrontToBack::in_window(const TreeBox& box, FrameBox& bounds) const {
  if (!frame_.bounds(box, bounds)) return false;
  if (bounds.bounded()) return true;
  const glm::dvec3 at = box.middle - scale_.eye;  // around the eye
  return std::none_of(window_.begin(), window_.end(), [&](const glm::dvec3& n) {
    return glm::dot(n, at) + glm::dot(glm::abs(n), box.half) < -scale_.point;
  });
}

/// May the box meet an open patch, or one in which a piece of this node has been seen? Leaves its bounds behind.
bool FrontToBack::in_sight(const TreeBox& box, std::size_t first) {
  if (!in_window(box, piece_bounds_)) return false;
  for (std::size_t k = first; k < open_.size(); ++k) {
    if (open_[k].bounds.meets(piece_bounds_)) return true;
  }
  const std::size_t end = seen_.size();
  for (std::size_t k = seen_boxes_.next(0, end, piece_bounds_); k < end;
       k = seen_boxes_.next(k + 1, end, piece_bounds_)) {
    if (seen_[k].patch.bounds.meets(piece_bounds_)) return true;
  }
  return false;
}

bool FrontToBack::carve(const Patch& patch, const TreePiece& piece, Sign eye, Patch& inside, Patch& outside) {
  if (!patch.bounds.meets(piece_bounds_)) return false;
  if (cone_.piece != &piece) cone_.set(scale_, piece, eye);
  const Patches::Place place = patches_.look(patch, piece_bounds_, cone_);
  if (place == Patches::Place::outside) return false;
  if (lines_.empty()) outline(piece, eye);
  if (place == Patches::Place::touched) return patches_.carve(patch, lines_, inside, outside);
  patches_.carve_within(patch, lines_, inside, outside);
  return true;
}

/// Halves of about as many sides each, by a line along that axis of the frame which fewer sides cross; false where
/// either is crossed by so many that the halves would not be much smaller, as with long strips. Any line would do, but
/// where not all beams are followed the border between what is and what is not may run along it, and it needs a name:
/// then it is one of the patch's own.
bool FrontToBack::halve(const Patch& patch, Patch& a, Patch& b) {
  if (min_angle_ > 0) return patches_.split(patch, patches_.middle_line(patch), a, b);
  if (!patch.bounds.bounded()) return false;
  int axis = -1;
  float at = 0;
  std::ptrdiff_t least = patch.count / 4;
  for (const int k : {0, 1}) {
    middles_.clear();
    for (std::uint32_t side = patch.first; side < patch.first + patch.count; ++side) {
      middles_.push_back((patches_.box(side).side[k] - patches_.box(side).side[k + 2]) / 2);
    }
    const auto middle = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
    std::nth_element(middles_.begin(), middle, middles_.end());
    std::ptrdiff_t crossing = 0;
    for (std::uint32_t side = patch.first; side < patch.first + patch.count; ++side) {
      const float* const box = patches_.box(side).side;
      crossing += box[k] < *middle && *middle < -box[k + 2];
    }
    if (crossing > least || (crossing == least && axis >= 0)) continue;
    least = crossing;
    axis = k;
    at = *middle;
  }
  if (axis < 0) return false;
  glm::dvec3 n = (axis == 0 ? frame_.across() : frame_.upwards()) - double{at} * frame_.ahead();
  n *= 0x1p20 / std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  std::uint64_t words[3];
  for (int k = 0; k < 3; ++k) words[k] = static_cast<std::uint64_t>(std::llround(n[k]));
  const SightlineRef line = view.table.of_normal(words, 1);
  return patches_.split(patch, line, a, b);
}

void FrontToBack::keep_open(Patch patch) {
  if (min_angle_ > 0) view.left_out += patches_.part_slivers(patch, min_angle_, slivers_);
  if (patch.empty()) return;
  Patch a, b;
  if (patch.count > most_sides && halve(patch, a, b)) {
    keep_open(a);
    keep_open(b);
  } else {
    open_.push_back(patch);
  }
}

/// Pieces that share a plane may cover one another: what was seen of one is cut by those that come after it.
void FrontToBack::take_out(const TreeNode& node, Sign eye, std::size_t first) {
  for (std::size_t i = 0; i < node.pieces.size(); ++i) {
    if (i % tree_group == 0 && !node.groups.empty() && !in_sight(node.groups[i / tree_group], first)) {
      i += tree_group - 1;
      continue;
    }
    const TreePiece& piece = node.pieces[i];
    if (!view.opaque(piece.surface, eye) || !in_sight(piece.box, first) || !view.in_reach(piece.surface)) continue;
    lines_.clear();
    Patch inside, outside;
    const std::size_t before = seen_.size();
    for (std::size_t k = seen_boxes_.next(0, before, piece_bounds_); k < before;
         k = seen_boxes_.next(k + 1, before, piece_bounds_)) {
      if (!seen_[k].patch.bounds.meets(piece_bounds_)) continue;
      const Seen whole = seen_[k];
      if (!carve(whole.patch, piece, eye, inside, outside)) continue;
      if (!outside.empty()) add_seen({outside, whole.last});
      seen_[k] = {inside, static_cast<std::uint32_t>(seen_on_.size())};
      seen_on_.push_back({piece.surface, whole.last});
    }
    std::size_t kept = first;
    const std::size_t end = open_.size();
    for (std::size_t k = first; k < end; ++k) {
      const Patch open = open_[k];
      if (carve(open, piece, eye, inside, outside)) {
        add_seen({inside, static_cast<std::uint32_t>(seen_on_.size())});
        seen_on_.push_back({piece.surface, none});
        keep_open(outside);
      } else {
        open_[kept++] = open;
      }
    }
    const auto begin = open_.begin();
    open_.erase(begin + static_cast<std::ptrdiff_t>(kept), begin + static_cast<std::ptrdiff_t>(end));
  }
  for (const Seen& seen : seen_) {
    on_.clear();
    for (std::uint32_t k = seen.last; k != none; k = seen_on_[k].before) on_.push_back(seen_on_[k].surface);
    std::sort(on_.begin(), on_.end());
    see(seen.patch, on_);
  }
  seen_.clear();
  seen_boxes_.clear();
  seen_on_.clear();
}

/// Fragments are connected. A patch that is not is taken apart by its loops, or where these touch, or doubles do not
/// tell which lies in which, split along one of its lines until its parts are single loops; one that no line of its own
/// splits is convex.
void FrontToBack::see(const Patch& patch, std::span<const SurfaceId> on) {
  std::uint32_t other = 0;
  if (!patches_.simple(patch, other)) {
    if (patches_.connected_parts(patch, parts_)) {
      for (const Patch& part : parts_) patches_.see(part, on, view.fragments);
      return;
    }
    Patch a, b;
    for (std::uint32_t k = 0; k < patch.count; ++k) {
      const SightlineRef line = patches_.sides(patch)[(other + k) % patch.count].line;
      if (!patches_.split(patch, line, a, b)) continue;
      see(a, on);
      see(b, on);
      return;
    }
  }
  patches_.see(patch, on, view.fragments);
}

void FrontToBack::descend(TreeNode* child, std::size_t first) {
  FrameBox bounds;
  if (!child || first == open_.size() || !in_window(child->box, bounds) || !view.reach.may_hold(*child)) return;
  // Patches that the box cannot be seen in go first, out of the way.
  const auto begin = open_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto reached = std::partition(begin, open_.end(), [&](const Patch& o) {
    return !o.bounds.meets(bounds) || patches_.look(o, bounds, child->box) == Patches::Place::outside;
  });
  if (reached != open_.end()) visit(*child, static_cast<std::size_t>(reached - open_.begin()));
}

void FrontToBack::visit(TreeNode& node, std::size_t first) {
  ++view.cells;
  tree_.open(node);
  const Sign eye = eye_side(node);
  descend(node.child[eye > 0], first);
  if (eye != 0) take_out(node, eye, first);
  descend(node.child[eye <= 0], first);
}

void FrontToBack::fill(std::span<const SightlineRef> window, const glm::dvec3& ahead) {
  frame_.set(scale_.eye, ahead, scale_.point);
  patches_.begin(view.scene, view.table, frame_, scale_);
  window_.clear();
  for (const SightlineRef side : window) {
    window_.push_back(view.table.approx(side.id) * static_cast<double>(side.sign));
  }
  open_.assign(1, patches_.convex(window));
  const std::size_t before = view.fragments.fragments.size();
  descend(tree_.root(), 0);
  for (const Patch& left : open_) see(left, {});
  for (const Patch& sliver : slivers_) see(sliver, {});
  slivers_.clear();
  patches_.tell_same(view.fragments);
  view.beams += static_cast<std::uint32_t>(view.fragments.fragments.size() - before);
}

}  // namespace

std::unique_ptr<Engine> front_to_back_engine(const BspTree& tree, double min_angle, double max_distance) {
  return std::make_unique<FrontToBack>(tree, min_angle, max_distance);
}

}  // namespace sightline
