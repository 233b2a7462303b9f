#include "beam/front_to_back.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "beam/frame.hpp"

namespace sightline {
namespace {

class FrontToBack : public Engine {
 public:
  explicit FrontToBack(const BspTree& tree) : Engine(tree.scene(), tree.scene().planes()), tree_(tree) {}

  std::unique_ptr<Engine> copy() const override { return std::make_unique<FrontToBack>(tree_); }
  void begin() override;
  void fill(Regions::Region region, const glm::dvec3& ahead) override;

 private:
  /// A region still open, with its bounds in the frame.
  struct Open {
    Regions::Region region;
    FrameBox bounds;
  };
  /// Open regions stand on a stack; a node is given those from `first` up, and leaves there what remains of them.
  void visit(TreeNode& node, std::size_t first);
  void descend(TreeNode* child, std::size_t first);
  Sign eye_side(const TreeNode& node);
  Sign exact_side(const TreeNode& node) const;
  bool may_meet(Regions::Region region, const TreeBox& box) const;
  void outline(const TreePiece& piece, Sign eye);
  bool apart(Regions::Region region, const TreePiece& piece, Sign eye) const;
  bool in_sight(const TreeBox& box, std::size_t first);
  bool carve(const Open& open, const TreePiece& piece, Sign eye, Regions::Region& inside);
  void open_rest(const FrameBox& within);
  void take_out(const TreeNode& node, Sign eye, std::size_t first);

  /// What has been seen in the plane of a node.
  struct Seen {
    Open open;
    std::uint32_t first, count;  // in seen_on_
  };

  const BspTree& tree_;
  Frame frame_;
  glm::dvec3 eye_{0};
  double scale_ = 1, doubt_ = 0;
  std::vector<Open> open_;
  std::vector<Regions::Region> parts_;
  FrameBox piece_bounds_;            // of the piece looked at
  std::vector<SightlineRef> lines_;  // its outline, once it is needed
  std::vector<Seen> seen_;
  std::vector<SurfaceId> seen_on_;
};

void FrontToBack::begin() {
  eye_ = view.table.eye_approx();
  // Boxes hold what they bound, rounding included. Values n.(x - eye) are of size 6 S at most, S the larger of 1 and
  // the eye's reach; data carry 2^-53 of that, and three products and sums as much again: far below 2^-44 S.
  scale_ = std::max({1.0, std::abs(eye_.x), std::abs(eye_.y), std::abs(eye_.z)});
  doubt_ = 0x1p-44 * scale_;
}

/// Conservative: does some side of the region part it from the box?
bool FrontToBack::may_meet(Regions::Region region, const TreeBox& box) const {
  const glm::dvec3 at = box.middle - eye_;
  for (const RegionSide& side : view.regions.sides(region)) {
    const glm::dvec3& n = side.normal;
    const double most = n.x * at.x + n.y * at.y + n.z * at.z + std::abs(n.x) * box.half.x + std::abs(n.y) * box.half.y +
                        std::abs(n.z) * box.half.z;
    if (most < -doubt_) return false;
  }
  return true;
}

Sign FrontToBack::eye_side(const TreeNode& node) {
  if (node.plane != none) return view.table.eye_side(node.plane);
  // The normal's components are at most 1, the eye's S: three products and their sum are within 2^-50 S.
  const double value = glm::dot(node.normal, eye_) - node.d;
  if (std::abs(value) > doubt_) return value > 0 ? 1 : -1;
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

/// Lines of the piece's outline, their normals pointing inwards. Edges run counter-clockwise seen from the front of the
/// plane, and (a - eye) x (b - eye) points outwards for an eye there. With P and Q the values of the piece's plane and
/// a cutting one, P(eye) n_q - Q(eye) n_p is P(eye) Q(x) at a point x of the piece.
void FrontToBack::outline(const TreePiece& piece, Sign eye) {
  lines_.clear();
  const PlaneId plane = view.scene.surfaces()[piece.surface].plane;
  for (const TreeEdge& e : piece.edges) {
    SightlineRef line = e.a != none ? view.table.of_points(e.a, e.b) : view.table.of_planes(plane, e.cut);
    line.sign *= e.a != none ? -eye : eye * e.inside;
    lines_.push_back(line);
  }
}

/// Does an edge of the piece clearly part it from the region? Told by doubles, so that lines of pieces that are not
/// seen need not be made. With S as in begin(), (a - eye) x (b - eye) is at most 24 S^2 and within 2^-47 S^2, corners
/// are at most 2 and within 2^-49: their product is within 2^-42 S^2.
bool FrontToBack::apart(Regions::Region region, const TreePiece& piece, Sign eye) const {
  const double doubt = 0x1p-42 * scale_ * scale_;
  const auto sides = view.regions.sides(region);
  const PointTable& points = view.scene.points();
  for (const TreeEdge& e : piece.edges) {
    if (e.a == none) continue;
    const glm::dvec3 out = glm::cross(points.approx(e.a) - eye_, points.approx(e.b) - eye_) * static_cast<double>(eye);
    const auto outside = [&](const RegionSide& side) { return glm::dot(out, side.corner) > doubt; };
    if (std::all_of(sides.begin(), sides.end(), outside)) return true;
  }
  return false;
}

/// May the box meet an open region, or one in which a piece of this node has been seen? Leaves its bounds behind.
bool FrontToBack::in_sight(const TreeBox& box, std::size_t first) {
  if (!frame_.bounds(box, piece_bounds_)) return false;
  for (std::size_t k = first; k < open_.size(); ++k) {
    if (open_[k].bounds.meets(piece_bounds_)) return true;
  }
  for (const Seen& seen : seen_) {
    if (seen.open.bounds.meets(piece_bounds_)) return true;
  }
  return false;
}

bool FrontToBack::carve(const Open& open, const TreePiece& piece, Sign eye, Regions::Region& inside) {
  parts_.clear();
  if (!open.bounds.meets(piece_bounds_) || !may_meet(open.region, piece.box)) return false;
  if (lines_.empty()) {
    if (apart(open.region, piece, eye)) return false;
    outline(piece, eye);
  }
  return view.regions.carve(view.table, open.region, lines_, inside, parts_);
}

/// What a carved region leaves stays open.
void FrontToBack::open_rest(const FrameBox& within) {
  for (const Regions::Region part : parts_) {
    open_.push_back({part, frame_.bounds(view.regions.sides(part)).common(within)});
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
    if (!view.opaque(piece.surface, eye) || !in_sight(piece.box, first)) continue;
    lines_.clear();
    Regions::Region inside;
    for (std::size_t k = 0, n = seen_.size(); k < n; ++k) {
      const Seen whole = seen_[k];
      if (!carve(whole.open, piece, eye, inside)) continue;
      for (const Regions::Region part : parts_) seen_.push_back({{part, whole.open.bounds}, whole.first, whole.count});
      const auto on = static_cast<std::uint32_t>(seen_on_.size());
      for (std::uint32_t j = 0; j < whole.count; ++j) seen_on_.push_back(seen_on_[whole.first + j]);
      seen_on_.push_back(piece.surface);
      seen_[k] = {{inside, whole.open.bounds}, on, whole.count + 1};
    }
    std::size_t kept = first;
    const std::size_t end = open_.size();
    for (std::size_t k = first; k < end; ++k) {
      const Open open = open_[k];
      if (carve(open, piece, eye, inside)) {
        seen_.push_back({{inside, open.bounds}, static_cast<std::uint32_t>(seen_on_.size()), 1});
        seen_on_.push_back(piece.surface);
        open_rest(open.bounds);
      } else {
        open_[kept++] = open;
      }
    }
    const auto begin = open_.begin();
    open_.erase(begin + static_cast<std::ptrdiff_t>(kept), begin + static_cast<std::ptrdiff_t>(end));
  }
  for (const Seen& seen : seen_) {
    view.see(seen.open.region, std::span(seen_on_).subspan(seen.first, seen.count), eye);
  }
  seen_.clear();
  seen_on_.clear();
}

void FrontToBack::descend(TreeNode* child, std::size_t first) {
  FrameBox bounds;
  if (!child || first == open_.size() || !frame_.bounds(child->box, bounds)) return;
  // Regions that the box cannot be seen in go first, out of the way.
  const auto begin = open_.begin() + static_cast<std::ptrdiff_t>(first);
  const bool around = !bounds.bounded();  // a box around the eye: only the regions' sides tell
  const auto reached = std::partition(begin, open_.end(), [&](const Open& o) {
    return !o.bounds.meets(bounds) || (around && !may_meet(o.region, child->box));
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

void FrontToBack::fill(Regions::Region region, const glm::dvec3& ahead) {
  frame_.set(eye_, ahead, doubt_);
  open_.assign(1, {region, frame_.bounds(view.regions.sides(region))});
  const std::size_t before = view.fragments.fragments.size();
  descend(tree_.root(), 0);
  for (const Open& left : open_) view.see(left.region, {}, 0);
  view.beams += static_cast<std::uint32_t>(view.fragments.fragments.size() - before);
}

}  // namespace

std::unique_ptr<Engine> front_to_back_engine(const BspTree& tree) { return std::make_unique<FrontToBack>(tree); }

}  // namespace sightline
