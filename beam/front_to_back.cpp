#include "beam/front_to_back.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

class FrontToBack : public Engine {
 public:
  explicit FrontToBack(const BspTree& tree) : Engine(tree.scene(), tree.scene().planes()), tree_(tree) {}

  std::unique_ptr<Engine> copy() const override { return std::make_unique<FrontToBack>(tree_); }
  void begin() override;
  void fill(Regions::Region region, const glm::dvec3& ahead) override;

 private:
  /// Open regions stand on a stack; a node is given those from `first` up, and leaves there what remains of them.
  void visit(TreeNode& node, std::size_t first);
  void descend(TreeNode* child, std::size_t first);
  Sign eye_side(const TreeNode& node);
  bool may_meet(Regions::Region region, const TreeBox& box) const;
  bool behind(const TreeBox& box) const;
  void outline(const TreePiece& piece, Sign eye);
  void take_out(const TreePiece& piece, Sign eye, std::size_t first);
  void take_out_of_plane(const TreeNode& node, Sign eye, std::size_t first);

  /// What has been seen in the plane of a node that carries more than one piece.
  struct Seen {
    Regions::Region region;
    std::vector<const TreePiece*> on;
  };

  const BspTree& tree_;
  glm::dvec3 eye_{0}, ahead_{0};
  double doubt_ = 0;
  std::vector<Regions::Region> open_, parts_;
  std::vector<SightlineRef> lines_;
  std::vector<Seen> seen_;
  std::vector<SurfaceId> surfaces_;
};

void FrontToBack::begin() {
  eye_ = view.table.eye_approx();
  // Boxes hold what they bound, rounding included. Values n.(x - eye) are of size 6 S at most, S the larger of 1 and the
  // eye's reach; data carry 2^-53 of that, and three products and sums as much again: far below 2^-44 S.
  doubt_ = 0x1p-44 * std::max({1.0, std::abs(eye_.x), std::abs(eye_.y), std::abs(eye_.z)});
}

bool FrontToBack::behind(const TreeBox& box) const {
  const glm::dvec3 middle = (box.low + box.high) * 0.5 - eye_, half = (box.high - box.low) * 0.5;
  return glm::dot(ahead_, middle) + glm::dot(glm::abs(ahead_), half) < -doubt_;
}

/// Conservative: does some side of the region part it from the box?
bool FrontToBack::may_meet(Regions::Region region, const TreeBox& box) const {
  const glm::dvec3 middle = (box.low + box.high) * 0.5 - eye_, half = (box.high - box.low) * 0.5;
  for (const RegionSide& side : view.regions.sides(region)) {
    const glm::dvec3& n = view.table.approx(side.line.id);
    const double most = side.line.sign * glm::dot(n, middle) + glm::dot(glm::abs(n), half);
    if (most < -doubt_) return false;
  }
  return true;
}

Sign FrontToBack::eye_side(const TreeNode& node) {
  if (node.plane != none) return view.table.eye_side(node.plane);
  // In free space both orders are right for an eye that is so near that rounding matters.
  return eye_[node.axis] < node.at ? -1 : 1;
}

/// Lines of the piece's outline, their normals pointing inwards. Edges run counter-clockwise seen from the front of the
/// plane, and (a - eye) x (b - eye) points outwards for an eye there. With P and Q the values of the piece's plane and a
/// cutting one, P(eye) n_q - Q(eye) n_p is P(eye) Q(x) at a point x of the piece.
void FrontToBack::outline(const TreePiece& piece, Sign eye) {
  lines_.clear();
  const PlaneId plane = view.scene.surfaces()[piece.surface].plane;
  for (const TreeEdge& e : piece.edges) {
    SightlineRef line = e.a != none ? view.table.of_points(e.a, e.b) : view.table.of_planes(plane, e.cut);
    line.sign *= e.a != none ? -eye : eye * e.inside;
    lines_.push_back(line);
  }
}

void FrontToBack::take_out(const TreePiece& piece, Sign eye, std::size_t first) {
  if (!view.opaque(piece.surface, eye)) return;
  lines_.clear();
  parts_.clear();
  std::size_t kept = first;
  for (std::size_t k = first; k < open_.size(); ++k) {
    const Regions::Region region = open_[k];
    Regions::Region inside;
    if (may_meet(region, piece.box)) {
      if (lines_.empty()) outline(piece, eye);
      if (view.regions.carve(view.table, region, lines_, inside, parts_)) {
        view.see(inside, {&piece.surface, 1}, eye);
        continue;
      }
    }
    open_[kept++] = region;
  }
  open_.resize(kept);
  open_.insert(open_.end(), parts_.begin(), parts_.end());
}

/// Pieces that share a plane may cover one another: what was seen of one is cut by those that come after it.
void FrontToBack::take_out_of_plane(const TreeNode& node, Sign eye, std::size_t first) {
  seen_.clear();
  for (const TreePiece& piece : node.pieces) {
    if (!view.opaque(piece.surface, eye)) continue;
    lines_.clear();
    const auto carve = [&](Regions::Region region, Regions::Region& inside) {
      if (!may_meet(region, piece.box)) return false;
      if (lines_.empty()) outline(piece, eye);
      return view.regions.carve(view.table, region, lines_, inside, parts_);
    };
    Regions::Region inside;
    for (std::size_t k = 0, n = seen_.size(); k < n; ++k) {
      parts_.clear();
      if (!carve(seen_[k].region, inside)) continue;
      for (const Regions::Region part : parts_) seen_.push_back({part, seen_[k].on});
      seen_[k].region = inside;
      seen_[k].on.push_back(&piece);
    }
    parts_.clear();
    std::size_t kept = first;
    for (std::size_t k = first; k < open_.size(); ++k) {
      if (carve(open_[k], inside)) {
        seen_.push_back({inside, {&piece}});
      } else {
        open_[kept++] = open_[k];
      }
    }
    open_.resize(kept);
    open_.insert(open_.end(), parts_.begin(), parts_.end());
  }
  for (const Seen& seen : seen_) {
    surfaces_.clear();
    for (const TreePiece* piece : seen.on) surfaces_.push_back(piece->surface);
    view.see(seen.region, surfaces_, eye);
  }
}

void FrontToBack::descend(TreeNode* child, std::size_t first) {
  if (!child || first == open_.size() || behind(child->box)) return;
  // Regions that the box cannot be seen in go first, out of the way.
  const auto begin = open_.begin() + static_cast<std::ptrdiff_t>(first);
  const auto reached =
      std::partition(begin, open_.end(), [&](Regions::Region r) { return !may_meet(r, child->box); });
  if (reached != open_.end()) visit(*child, static_cast<std::size_t>(reached - open_.begin()));
}

void FrontToBack::visit(TreeNode& node, std::size_t first) {
  ++view.cells;
  tree_.open(node);
  const Sign eye = eye_side(node);
  descend(node.child[eye > 0], first);
  if (eye != 0 && !node.pieces.empty()) {
    if (node.pieces.size() == 1) {
      take_out(node.pieces[0], eye, first);
    } else {
      take_out_of_plane(node, eye, first);
    }
  }
  descend(node.child[eye <= 0], first);
}

void FrontToBack::fill(Regions::Region region, const glm::dvec3& ahead) {
  ahead_ = ahead;
  open_.assign(1, region);
  const std::size_t before = view.fragments.fragments.size();
  descend(tree_.root(), 0);
  for (const Regions::Region left : open_) view.see(left, {}, 0);
  view.beams += static_cast<std::uint32_t>(view.fragments.fragments.size() - before);
}

}  // namespace

std::unique_ptr<Engine> front_to_back_engine(const BspTree& tree) { return std::make_unique<FrontToBack>(tree); }

}  // namespace sightline
