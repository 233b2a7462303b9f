#include "bsp/tree.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <mutex>

#include "bsp/pieces.hpp"
#include "bsp/tree_choice.hpp"

namespace sightline {
namespace {

/// Objects that never move, handed out one after the other.
template <class T>
class Store {
 public:
  T* take(std::size_t count) {
    if (blocks_.empty() || used_ + count > size_) {
      size_ = std::max<std::size_t>(count, 4096);
      used_ = 0;
      blocks_.push_back(std::make_unique<T[]>(size_));
      bytes_ += size_ * sizeof(T);
    }
    used_ += count;
    return blocks_.back().get() + used_ - count;
  }
  std::size_t bytes() const { return bytes_; }

 private:
  std::vector<std::unique_ptr<T[]>> blocks_;
  std::size_t used_ = 0, size_ = 0, bytes_ = 0;
};

// Corners of pieces are within 2^-48 of their doubles (the law of ImplicitVertex and PointTable).
constexpr double slack = 0x1p-47;

TreeBox box_of(std::span<const Piece> pieces) {
  glm::dvec3 low = pieces[0].low, high = pieces[0].high;
  for (const Piece& p : pieces) {
    low = glm::min(low, p.low);
    high = glm::max(high, p.high);
  }
  return {(low + high) * 0.5, (high - low) * 0.5 + slack};
}

}  // namespace

struct BspTree::State {
  explicit State(const Scene& s) : scene(s), pieces(s, s.planes()), choice(s.planes(), pieces) {
    waiting.reserve(s.surfaces().size() * 5 / 4);
    for (SurfaceId k = 0; k < s.surfaces().size(); ++k) waiting.push_back(pieces.whole(k));
    root = node(0, waiting.size());
  }

  TreeNode* node(std::size_t first, std::size_t count) {
    if (count == 0) return nullptr;
    TreeNode* n = nodes.take(1);
    n->first = first;
    n->count = count;
    n->box = box_of(std::span(waiting).subspan(first, count));
    return n;
  }

  void divide(TreeNode& n);
  void divide_at(TreeNode& n, PlaneId plane);
  void divide_free(TreeNode& n, const TreeCut& cut);
  void keep(TreeNode& n);
  int sides(const Piece& piece, PlaneId plane);

  const Scene& scene;
  Pieces pieces;
  TreeChoice choice;
  std::vector<Piece> waiting;  // of nodes not yet divided
  std::vector<Piece> on, front;
  Store<TreeNode> nodes;
  Store<TreePiece> kept;
  Store<TreeEdge> edges;
  Store<TreeCorner> places;
  Store<TreeBox> boxes;
  TreeNode* root = nullptr;
  std::size_t node_count = 0, piece_count = 0;
  std::mutex mutex;
};

/// The pieces in the node's plane take their last form.
void BspTree::State::keep(TreeNode& n) {
  std::sort(on.begin(), on.end(), [](const Piece& a, const Piece& b) { return a.surface < b.surface; });
  TreePiece* const out = kept.take(on.size());
  for (std::size_t k = 0; k < on.size(); ++k) {
    const Piece& piece = on[k];
    const auto sides_of_surface = scene.edges(scene.surfaces()[piece.surface]);
    const auto corners = pieces.corners(piece);
    TreeEdge* const edge = edges.take(corners.size());
    TreeCorner* const place = places.take(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      place[i] = {corners[i].place.approx, corners[i].point};
      const PlaneId side = corners[i].side;
      const auto own = std::find_if(sides_of_surface.begin(), sides_of_surface.end(),
                                    [side](const SurfaceEdge& e) { return e.wall == side; });
      if (own != sides_of_surface.end()) {
        edge[i] = {own->a, own->b, none, 0};
        continue;
      }
      edge[i] = {none, none, side, 0};
      for (const PieceCorner& c : corners) {
        if (edge[i].inside == 0) edge[i].inside = pieces.side(c, side);
      }
    }
    out[k] = {piece.surface, static_cast<std::uint32_t>(corners.size()), edge, place, box_of({&piece, 1})};
  }
  n.pieces = {out, on.size()};
  if (on.size() > tree_group) {
    const std::size_t count = (on.size() + tree_group - 1) / tree_group;
    TreeBox* const group = boxes.take(count);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t first = k * tree_group;
      group[k] = box_of(std::span(on).subspan(first, std::min(tree_group, on.size() - first)));
    }
    n.groups = {group, count};
  }
  piece_count += on.size();
}

/// Pieces::sides, with a look at the box first: where the plane's value over the box is beyond all rounding, so is the
/// piece. Values are of size 4 at most, with errors of some 2^-46 from the corners and 2^-50 of their own.
int BspTree::State::sides(const Piece& piece, PlaneId plane) {
  if (piece.plane == plane) return 0;
  const ApproxPlane& p = scene.planes().approx(plane);
  double middle = -p.d, reach = 0;
  for (int k = 0; k < 3; ++k) {
    middle += p.n[k] * (piece.low[k] + piece.high[k]) * 0.5;
    reach += std::abs(p.n[k]) * (piece.high[k] - piece.low[k]) * 0.5;
  }
  constexpr double doubt = 0x1p-44;
  if (middle > reach + doubt) return 2;
  if (middle < -reach - doubt) return 1;
  return pieces.sides(piece, plane);
}

void BspTree::State::divide_at(TreeNode& n, PlaneId plane) {
  n.plane = plane;
  on.clear();
  front.clear();
  std::size_t behind = n.first;
  for (std::size_t k = n.first, end = n.first + n.count; k < end; ++k) {
    const Piece piece = waiting[k];
    switch (sides(piece, plane)) {
      case 0:
        on.push_back(piece);
        break;
      case 1:
        waiting[behind++] = piece;
        break;
      case 2:
        front.push_back(piece);
        break;
      default: {
        Piece halves[2];
        pieces.split(piece, plane, halves[0], halves[1]);
        waiting[behind++] = halves[0];
        front.push_back(halves[1]);
      }
    }
  }
  keep(n);
  n.child[0] = node(n.first, behind - n.first);
  std::size_t at = behind;
  if (front.size() > n.first + n.count - behind) {  // more than fit in the node's own place
    at = waiting.size();
    waiting.resize(at + front.size());
  }
  std::copy(front.begin(), front.end(), waiting.begin() + static_cast<std::ptrdiff_t>(at));
  n.child[1] = node(at, front.size());
}

void BspTree::State::divide_free(TreeNode& n, const TreeCut& cut) {
  n.normal = cut.normal;
  n.d = cut.d;
  const auto begin = waiting.begin() + static_cast<std::ptrdiff_t>(n.first);
  const auto end = begin + static_cast<std::ptrdiff_t>(n.count);
  const auto middle = std::stable_partition(
      begin, end, [&](const Piece& p) { return glm::dot(cut.normal, pieces.corners(p)[0].place.approx) < cut.d; });
  const auto behind = static_cast<std::size_t>(middle - begin);
  n.child[0] = node(n.first, behind);
  n.child[1] = node(n.first + behind, n.count - behind);
}

void BspTree::State::divide(TreeNode& n) {
  const TreeCut cut = choice.choose(std::span(waiting).subspan(n.first, n.count), n.box);
  if (cut.plane != none) {
    divide_at(n, cut.plane);
  } else {
    divide_free(n, cut);
  }
  ++node_count;
  n.ready.store(true, std::memory_order_release);
}

BspTree::BspTree(const Scene& scene, const TreeOptions& options) : state_(std::make_unique<State>(scene)) {
  if (options.lazy || !state_->root) return;
  std::vector<TreeNode*> below{state_->root};
  while (!below.empty()) {
    TreeNode* const n = below.back();
    below.pop_back();
    state_->divide(*n);
    for (TreeNode* const child : n->child) {
      if (child) below.push_back(child);
    }
  }
  state_->waiting = {};
}
BspTree::~BspTree() = default;
BspTree::BspTree(BspTree&&) noexcept = default;
BspTree& BspTree::operator=(BspTree&&) noexcept = default;

const Scene& BspTree::scene() const { return state_->scene; }
TreeNode* BspTree::root() const { return state_->root; }

void BspTree::divide(TreeNode& node) const {
  const std::lock_guard lock(state_->mutex);
  if (!node.ready.load(std::memory_order_relaxed)) state_->divide(node);
}

BspTree::Size BspTree::size() const {
  const std::lock_guard lock(state_->mutex);
  return {state_->node_count, state_->piece_count,
          state_->nodes.bytes() + state_->kept.bytes() + state_->edges.bytes() + state_->places.bytes() +
              state_->boxes.bytes() + state_->waiting.capacity() * sizeof(Piece)};
}

}  // namespace sightline
