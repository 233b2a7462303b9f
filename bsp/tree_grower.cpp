#include "bsp/tree_grower.hpp"

#include <cassert>
#include <cmath>
#include <glm/common.hpp>

namespace sightline {
namespace {

// Corners of pieces are within 2^-48 of their doubles (the law of ImplicitVertex and PointTable).
constexpr double slack = 0x1p-47;

TreeBox box_between(const glm::dvec3& low, const glm::dvec3& high) {
  return {(low + high) * 0.5, (high - low) * 0.5 + slack};
}

TreeBox box_of(std::span<const TreePiece> pieces) {
  glm::dvec3 low = pieces[0].box.middle - pieces[0].box.half, high = pieces[0].box.middle + pieces[0].box.half;
  for (const TreePiece& p : pieces) {
    low = glm::min(low, p.box.middle - p.box.half);
    high = glm::max(high, p.box.middle + p.box.half);
  }
  return box_between(low, high);
}

}  // namespace

TreeNode* TreeGrower::plant(TreeLoad& load) {
  TreeExtent extent;
  parts_.take_all(load, extent);
  TreeNode* const root = node_of(load.parts.size(), extent);
  load.along = extent.along;
  return root;
}

/// A node for so many parts within these bounds.
TreeNode* TreeGrower::node_of(std::size_t count, TreeExtent& extent) {
  if (count == 0) return nullptr;
  const RoundedBox& box = extent.box;
  if (!parts_.frame().turned()) extent.along = box;
  TreeNode* const n = nodes_.take(1);
  n->spread = extent.spread;
  n->box = box_between({box.low[0], box.low[1], box.low[2]}, {box.high[0], box.high[1], box.high[2]});
  return n;
}

/// Sides and corners. Vertices in one place go by one name, so that what meets there is known to. The corner before a
/// side of a whole surface is where the side before it ends.
void TreeGrower::keep_edges(TreePart part, TreePiece& out) {
  const auto sides = scene_.edges(scene_.surfaces()[out.surface]);
  const auto twin = [this](PointId p) { return p == none ? none : scene_.lowest_twin(p); };
  const bool whole = parts_.whole(part);
  const auto corners = whole ? std::span<const PieceCorner>{} : parts_.corners(part);
  out.count = static_cast<std::uint32_t>(whole ? sides.size() : corners.size());
  TreeEdge* const edge = edges_.take(out.count);
  TreeCorner* const corner = corners_.take(out.count);
  out.edge = edge;
  out.corner = corner;
  for (std::size_t i = 0; whole && i < sides.size(); ++i) {
    edge[i] = {twin(sides[i].a), twin(sides[i].b), none, 0};
    corner[i].point = twin(sides[i == 0 ? sides.size() - 1 : i - 1].corner);
  }
  if (whole) {
    std::size_t next = 0;
    parts_.for_corners(part, [&](const glm::dvec3& p) { corner[next = next + 1 == out.count ? 0 : next + 1].at = p; });
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const PieceCorner& c = corners[i];
    const auto own = std::find_if(sides.begin(), sides.end(), [&c](const SurfaceEdge& e) { return e.wall == c.side; });
    edge[i] =
        own != sides.end() ? TreeEdge{twin(own->a), twin(own->b), none, 0} : TreeEdge{none, none, c.side, c.inside};
    corner[i] = {c.place.approx, twin(c.point)};
  }
}

/// Neighbours in the plane become neighbours in the list, as far as that goes, so that a group is a small region:
/// halves along the longest side of what holds the parts' middles, and so on; the first half is made of whole groups.
void TreeGrower::order(std::span<TreePart> parts) {
  if (parts.size() <= tree_group) return;
  const auto middle = [this](TreePart p, int axis) { return parts_.along(p).low[axis] + parts_.along(p).high[axis]; };
  int axis = 0;
  float longest = -1;
  for (int k = 0; k < 3; ++k) {
    float low = INFINITY, high = -INFINITY;
    for (const TreePart p : parts) {
      low = std::min(low, middle(p, k));
      high = std::max(high, middle(p, k));
    }
    if (high - low <= longest) continue;
    longest = high - low;
    axis = k;
  }
  const std::size_t unit = parts.size() > 16 * tree_group ? 16 * tree_group : tree_group;
  const std::size_t half = (parts.size() / 2 + unit - 1) / unit * unit;
  std::nth_element(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(half), parts.end(),
                   [&](TreePart a, TreePart b) {
                     const float at_a = middle(a, axis), at_b = middle(b, axis);
                     return at_a != at_b ? at_a < at_b : parts_.surface(a) < parts_.surface(b);
                   });
  order(parts.first(half));
  order(parts.subspan(half));
}

/// The parts in the node's plane take their last form.
void TreeGrower::keep(TreeNode& node) {
  order(on_);
  TreePiece* const out = kept_.take(on_.size());
  for (std::size_t k = 0; k < on_.size(); ++k) {
    out[k].surface = parts_.surface(on_[k]);
    keep_edges(on_[k], out[k]);
    glm::dvec3 low{INFINITY}, high{-INFINITY};
    for (const TreeCorner& c : out[k].corners()) {
      low = glm::min(low, c.at);
      high = glm::max(high, c.at);
    }
    out[k].box = box_between(low, high);
  }
  node.pieces = {out, on_.size()};
  pieces_kept_ += on_.size();
  if (on_.size() <= tree_group) return;
  const std::size_t count = (on_.size() + tree_group - 1) / tree_group;
  TreeBox* const group = boxes_.take(count);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t first = k * tree_group;
    group[k] = box_of(node.pieces.subspan(first, std::min(tree_group, on_.size() - first)));
  }
  node.groups = {group, count};
}

/// Hands every part to `place`, but whole blocks on one side of the cut, as `side` says, straight to that side.
template <class Side, class Place>
void TreeGrower::part_blocks(std::span<TreePart> here, std::size_t& behind, Side&& side, Place&& place) {
  for (std::size_t k = 0; k < here.size();) {
    const std::size_t count = parts_.block_at(here.subspan(k));
    const auto block = here.subspan(k, std::max<std::size_t>(count, 1));
    k += block.size();
    const int found = count > 0 ? side(parts_.block(block[0])) : 0;
    if (found == 0) {
      for (const TreePart p : block) place(p);
      continue;
    }
    extent_[found == 2].add(parts_.block(block[0]));
    if (found == 2) {
      front_.insert(front_.end(), block.begin(), block.end());
    } else {
      std::copy(block.begin(), block.end(), here.begin() + static_cast<std::ptrdiff_t>(behind));
      behind += count;
    }
  }
}

std::size_t TreeGrower::part_by_plane(std::span<TreePart> here, PlaneId plane) {
  parts_.aim(plane);
  std::size_t behind = 0;
  const auto place = [&](TreePart p) {
    switch (parts_.sides(p)) {
      case 0:
        on_.push_back(p);
        break;
      case 1:
        here[behind++] = p;
        parts_.extend(extent_[0], p);
        break;
      case 2:
        front_.push_back(p);
        parts_.extend(extent_[1], p);
        break;
      default: {
        TreePart halves[2];
        parts_.split(p, halves[0], halves[1]);
        for (const int k : {0, 1}) parts_.extend(extent_[k], halves[k]);
        here[behind++] = halves[0];
        front_.push_back(halves[1]);
      }
    }
  };
  part_blocks(
      here, behind, [this](const TreeExtent& block) { return parts_.clear_side(block); }, place);
  return behind;
}

std::size_t TreeGrower::part_in_gap(std::span<TreePart> here, int axis, double d) {
  std::size_t behind = 0;
  const bool turned = parts_.frame().turned();
  const auto side = [&](const TreeExtent& block) {
    const RoundedBox& along = turned ? block.along : block.box;
    return along.low[axis] > d ? 2 : along.high[axis] < d ? 1 : 0;
  };
  part_blocks(here, behind, side, [&](TreePart p) {
    const bool front = parts_.along(p).low[axis] > d;
    assert(front || parts_.along(p).high[axis] < d);
    parts_.extend(extent_[front], p);
    if (front) {
      front_.push_back(p);
    } else {
      here[behind++] = p;
    }
  });
  return behind;
}

/// Those behind come to stand first, the others in front_.
std::size_t TreeGrower::part(TreeNode& node, std::span<TreePart> here, const RoundedBox& along) {
  const TreeCut cut = choice_.choose(here, along);
  on_.clear();
  front_.clear();
  for (TreeExtent& extent : extent_) extent = {};
  std::size_t behind = 0;
  if (cut.plane != none) {
    node.plane = cut.plane;
    behind = part_by_plane(here, cut.plane);
    keep(node);
  } else {
    node.normal = parts_.frame().direction(cut.axis);
    node.d = cut.d;
    behind = part_in_gap(here, cut.axis, cut.d);
  }
  node.child[0] = node_of(behind, extent_[0]);
  node.child[1] = node_of(front_.size(), extent_[1]);
  ++nodes_divided_;
  return behind;
}

void TreeGrower::divide(TreeNode& node, TreeLoad& load, TreeLoad below[2]) {
  parts_.swap_arena(load);
  front_.reserve(load.parts.size());  // what is not written to costs nothing
  load.parts.resize(part(node, load.parts, load.along));
  parts_.pack(load.parts, below[0]);
  parts_.pack(front_, below[1]);
  for (const int k : {0, 1}) below[k].along = extent_[k].along;
  parts_.truncate({});
}

void TreeGrower::grow(TreeNode& node, TreeLoad& load) {
  struct Task {
    TreeNode* node;
    std::size_t first;     // its parts are waiting_[first ..] when its turn comes
    TreeParts::Mark mark;  // and the arena then ends there
    RoundedBox along;
  };
  waiting_ = std::move(load.parts);
  parts_.swap_arena(load);
  std::vector<Task> tasks{{&node, 0, parts_.mark(), load.along}};
  while (!tasks.empty()) {
    const Task task = tasks.back();
    tasks.pop_back();
    parts_.truncate(task.mark);
    const std::size_t behind = part(*task.node, std::span(waiting_).subspan(task.first), task.along);
    task.node->ready.store(true, std::memory_order_release);
    waiting_.resize(task.first + behind);
    waiting_.insert(waiting_.end(), front_.begin(), front_.end());
    const std::size_t first[2] = {task.first, task.first + behind};
    for (const std::size_t k : {0u, 1u}) {
      if (task.node->child[k]) tasks.push_back({task.node->child[k], first[k], parts_.mark(), extent_[k].along});
    }
  }
  parts_.truncate({});
}

}  // namespace sightline
