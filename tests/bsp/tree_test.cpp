// The tree of polygons: the same whoever makes it and when, every piece on its side of every node above it.
#include "bsp/tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <thread>

#include "exact/predicates.hpp"
#include "models/model.hpp"

namespace sightline {
namespace {

Scene scene_of(const char* name, std::uint32_t polygons, double degrees) {
  return make_scene(make_model(name, {.polygons = polygons, .rotate_degrees = degrees}).soup);
}

bool same_box(const TreeBox& a, const TreeBox& b) { return a.middle == b.middle && a.half == b.half; }

bool same_piece(const TreePiece& a, const TreePiece& b) {
  return a.surface == b.surface && same_box(a.box, b.box) &&
         std::equal(a.edges().begin(), a.edges().end(), b.edges().begin(), b.edges().end(),
                    [](const TreeEdge& x, const TreeEdge& y) {
                      return x.a == y.a && x.b == y.b && x.cut == y.cut && x.inside == y.inside;
                    }) &&
         std::equal(a.corners().begin(), a.corners().end(), b.corners().begin(), b.corners().end(),
                    [](const TreeCorner& x, const TreeCorner& y) { return x.at == y.at && x.point == y.point; });
}

/// Nodes that are alike, from the top on; the first two that are not end it with a failure.
std::size_t expect_same(const BspTree& a, const BspTree& b) {
  std::vector<std::pair<TreeNode*, TreeNode*>> below{{a.root(), b.root()}};
  std::size_t nodes = 0;
  while (!below.empty()) {
    const auto [x, y] = below.back();
    below.pop_back();
    EXPECT_EQ(x == nullptr, y == nullptr) << "after " << nodes;
    if (!x || !y) {
      if (x || y) return nodes;
      continue;
    }
    a.open(*x);
    b.open(*y);
    const bool same = x->plane == y->plane && x->normal == y->normal && x->d == y->d && same_box(x->box, y->box) &&
                      std::equal(x->pieces.begin(), x->pieces.end(), y->pieces.begin(), y->pieces.end(), same_piece) &&
                      std::equal(x->groups.begin(), x->groups.end(), y->groups.begin(), y->groups.end(), same_box);
    EXPECT_TRUE(same) << "after " << nodes;
    if (!same) return nodes;
    ++nodes;
    for (const int k : {0, 1}) below.push_back({x->child[k], y->child[k]});
  }
  return nodes;
}

void open_all(const BspTree& tree, bool front_first) {
  std::vector<TreeNode*> below{tree.root()};
  while (!below.empty()) {
    TreeNode* const n = below.back();
    below.pop_back();
    if (!n) continue;
    tree.open(*n);
    for (const int k : {0, 1}) below.push_back(n->child[front_first ? k : 1 - k]);
  }
}

TEST(Tree, IsTheSameAtAnyNumberOfThreads) {
  for (const double degrees : {0.0, 17.0}) {
    const Scene scene = scene_of("building", degrees == 0 ? 20'000 : 4'000, degrees);
    const BspTree alone(scene);
    for (const unsigned threads : {0u, 2u, 5u}) {
      const BspTree shared(scene, {.threads = threads});
      EXPECT_EQ(expect_same(alone, shared), alone.size().nodes) << threads << " threads, " << degrees << " degrees";
      EXPECT_EQ(shared.size().nodes, alone.size().nodes);
      EXPECT_EQ(shared.size().pieces, alone.size().pieces);
    }
  }
}

TEST(Tree, IsTheSameWhenManyDivideIt) {
  for (const char* name : {"city", "maze", "random"}) {
    const Scene scene = scene_of(name, name[0] == 'r' ? 200 : 0, name[0] == 'm' ? 17 : 0);
    const BspTree eager(scene), lazy(scene, {.lazy = true});
    EXPECT_EQ(lazy.size().nodes, 0u);
    {
      std::vector<std::jthread> readers;
      for (int k = 0; k < 4; ++k) readers.emplace_back([&lazy, k] { open_all(lazy, k % 2 == 0); });
    }
    EXPECT_EQ(lazy.size().nodes, eager.size().nodes) << name;
    EXPECT_EQ(lazy.size().pieces, eager.size().pieces) << name;
    EXPECT_EQ(expect_same(eager, lazy), eager.size().nodes) << name;
  }
}

/// The plane of a piece's side.
PlaneId side_of(const Scene& scene, const TreePiece& piece, const TreeEdge& edge) {
  if (edge.a == none) return edge.cut;
  for (const SurfaceEdge& e : scene.edges(scene.surfaces()[piece.surface])) {
    if (e.a == edge.a && e.b == edge.b) return e.wall;
  }
  return none;
}

std::vector<ImplicitVertex> corners_of(const Scene& scene, const TreePiece& piece) {
  std::vector<ImplicitVertex> corners;
  const PlaneId plane = scene.surfaces()[piece.surface].plane;
  for (std::size_t k = 0; k < piece.count; ++k) {
    const TreeEdge& before = piece.edge[k == 0 ? piece.count - 1 : k - 1];
    corners.push_back(
        make_vertex(scene.planes(), plane, side_of(scene, piece, before), side_of(scene, piece, piece.edge[k])));
  }
  return corners;
}

double area_of(const std::vector<ImplicitVertex>& corners) {
  glm::dvec3 sum{0};
  for (std::size_t k = 2; k < corners.size(); ++k) {
    sum += glm::cross(corners[k - 1].approx - corners[0].approx, corners[k].approx - corners[0].approx);
  }
  return glm::length(sum) / 2;
}

void expect_in(const TreeBox& box, const glm::dvec3& p) {
  for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(p[k] - box.middle[k]), box.half[k]);
}

struct Above {
  const TreeNode* node;
  Sign side;  // 0: in its plane
};

/// Every corner, as its sides name it, lies on the right side of all nodes above it: exactly of planes of the scene,
/// clearly of those in free space. And of its own cuts.
void expect_in_place(const Scene& scene, const TreePiece& piece, const std::vector<ImplicitVertex>& corners,
                     const std::vector<Above>& above) {
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ImplicitVertex& c = corners[k];
    expect_in(piece.box, c.approx);
    EXPECT_LT(glm::distance(c.approx, piece.corner[k].at), 0x1p-46);
    if (const PointId p = piece.corner[k].point; p != none) {
      EXPECT_EQ(piece.corner[k].at, scene.points().approx(p));
    }
    for (const auto& [node, side] : above) {
      expect_in(node->box, c.approx);
      if (side == 0) {
        EXPECT_EQ(vertex_side(scene.planes(), c, node->plane), 0);
      } else if (node->plane != none) {
        EXPECT_NE(vertex_side(scene.planes(), c, node->plane), -side);
      } else {
        EXPECT_GT((glm::dot(node->normal, c.approx) - node->d) * side, 0x1p-40);
      }
    }
    for (const TreeEdge& e : piece.edges()) {
      if (e.a == none) {
        EXPECT_NE(vertex_side(scene.planes(), c, e.cut), -e.inside);
      }
    }
  }
}

/// Corners of a whole surface, of which some may be no points of the scene.
std::vector<ImplicitVertex> corners_of(const Scene& scene, const Surface& surface) {
  std::vector<ImplicitVertex> corners;
  const auto edges = scene.edges(surface);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const SurfaceEdge &e = edges[k], &next = edges[(k + 1) % edges.size()];
    corners.push_back(e.corner != none ? ImplicitVertex{{}, 0, scene.points().approx(e.corner)}
                                       : make_vertex(scene.planes(), surface.plane, e.wall, next.wall));
  }
  return corners;
}

// `building` has surfaces that end amid an edge of another, where the scene has no point.
TEST(Tree, PutsEveryPartOfEverySurfaceInItsPlace) {
  for (const double degrees : {0.0, 17.0}) {
    for (const char* name : {"maze", "city", "random", "arena", "building"}) {
      const Scene scene = scene_of(name, name[0] == 'r' ? 100 : name[0] == 'b' ? 1'000 : 0, degrees);
      const BspTree tree(scene);
      std::map<SurfaceId, double> covered;
      std::vector<Above> above;
      const auto visit = [&](const auto& self, const TreeNode* node) -> void {
        if (!node) return;
        above.push_back({node, 0});
        for (const TreePiece& piece : node->pieces) {
          EXPECT_EQ(scene.surfaces()[piece.surface].plane, node->plane);
          const auto corners = corners_of(scene, piece);
          expect_in_place(scene, piece, corners, above);
          covered[piece.surface] += area_of(corners);
        }
        for (const int k : {0, 1}) {
          above.back().side = k == 0 ? -1 : 1;
          self(self, node->child[k]);
        }
        above.pop_back();
      };
      visit(visit, tree.root());
      ASSERT_EQ(covered.size(), scene.surfaces().size()) << name;
      for (const auto& [s, area] : covered) {
        EXPECT_NEAR(area, area_of(corners_of(scene, scene.surfaces()[s])), 0x1p-40) << name << " surface " << s;
      }
    }
  }
}

// Nothing about a turned scene lies along the axes; a tree that sees that cuts about as much as any (3.2 pieces a
// surface), and divides free space along the scene's own directions.
TEST(Tree, FindsTheDirectionsOfATurnedScene) {
  const Scene scene = scene_of("building", 2'000, 17);
  const BspTree tree(scene);
  std::size_t along_axes = 0, others = 0;
  std::vector<const TreeNode*> below{tree.root()};
  while (!below.empty()) {
    const TreeNode* const n = below.back();
    below.pop_back();
    if (!n) continue;
    if (n->plane == none) {
      const glm::dvec3 a = glm::abs(n->normal);
      ++(a.x == 1 || a.y == 1 || a.z == 1 ? along_axes : others);
    }
    for (const TreeNode* child : n->child) below.push_back(child);
  }
  EXPECT_EQ(along_axes, 0u);
  EXPECT_GT(others, 100u);
}

}  // namespace
}  // namespace sightline
