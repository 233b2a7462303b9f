// Every traversal against what a look at all records finds.
#include "winged_pair/traverse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/oracle/scenes.hpp"
#include "tests/winged_pair/samples.hpp"

namespace sightline::testing {
namespace {

template <class Ids>
std::set<std::uint32_t> set_of(const Ids& ids) {
  return {ids.begin(), ids.end()};
}

class Traverse : public ::testing::TestWithParam<int> {
 protected:
  Traverse()
      : scene_(GetParam() == 0 ? crossing_scene() : make_scene(make_case(static_cast<std::uint64_t>(GetParam())).soup)),
        c_(build(scene_)) {}
  bool bounds(FaceId f, CellId cell) const { return c_.faces[f].cell[0] == cell || c_.faces[f].cell[1] == cell; }
  Scene scene_;
  Complex c_;
};

TEST_P(Traverse, FacesOfCell) {
  Marks marks;
  std::vector<FaceId> faces;
  for (CellId cell = 0; cell < c_.cells.size(); ++cell) {
    faces_of_cell(c_, cell, marks, faces);
    std::set<FaceId> truth;
    for (FaceId f = 0; f < c_.faces.size(); ++f) {
      if (bounds(f, cell)) truth.insert(f);
    }
    EXPECT_EQ(set_of(faces), truth);
    EXPECT_EQ(faces.size(), truth.size());
    EXPECT_EQ(faces.front(), c_.cells[cell].face);
  }
}

TEST_P(Traverse, CellsOfFace) {
  for (FaceId f = 0; f < c_.faces.size(); ++f) {
    const CellId behind = c_.faces[f].cell[0], front = c_.faces[f].cell[1];
    EXPECT_EQ(cell_across(c_, f, behind), front);
    EXPECT_EQ(cell_across(c_, f, front), behind);
  }
}

TEST_P(Traverse, EdgesOfFaceInOrder) {
  for (FaceId f = 0; f < c_.faces.size(); ++f) {
    std::vector<PairId> pairs;
    for_pairs_of_face(c_, f, [&](PairId p) { pairs.push_back(p); });
    std::set<PairId> truth;
    for (PairId p = 0; p < c_.pairs.size(); ++p) {
      if (c_.pairs[p].face == f) truth.insert(p);
    }
    EXPECT_EQ(set_of(pairs), truth);
    EXPECT_EQ(pairs.size(), truth.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      EXPECT_EQ(pair_head(c_, pairs[k]), pair_tail(c_, pairs[(k + 1) % pairs.size()]));
    }
  }
}

/// Counter-clockwise seen with the edge pointing at the viewer: angles computed in doubles must rise, once round.
TEST_P(Traverse, FacesOfEdgeInOrder) {
  for (EdgeId e = 0; e < c_.edges.size(); ++e) {
    std::vector<PairId> pairs;
    for_pairs_of_edge(c_, e, [&](PairId p) { pairs.push_back(p); });
    std::set<PairId> truth;
    for (PairId p = 0; p < c_.pairs.size(); ++p) {
      if (c_.pairs[p].edge == e) truth.insert(p);
    }
    EXPECT_EQ(set_of(pairs), truth);
    EXPECT_EQ(pairs.size(), truth.size());
    if (GetParam() != 0) continue;  // angles of any scene's faces may be too near for doubles
    const glm::dvec3 axis = glm::normalize(c_.vertices[c_.edges[e].vertex[1]].place.approx -
                                           c_.vertices[c_.edges[e].vertex[0]].place.approx);
    std::vector<double> angles;
    glm::dvec3 x(0.0), y(0.0);
    for (const PairId p : pairs) {
      const auto* n = c_.planes.approx(c_.faces[c_.pairs[p].face].plane).n;
      const glm::dvec3 into =
          glm::cross(glm::dvec3(n[0], n[1], n[2]), axis) * (c_.pairs[p].direction == 0 ? 1.0 : -1.0);
      if (angles.empty()) x = glm::normalize(into), y = glm::cross(axis, x);
      const double angle = std::atan2(glm::dot(into, y), glm::dot(into, x));
      angles.push_back(angle < -1e-9 ? angle + 2 * std::acos(-1.0) : angle);
    }
    EXPECT_TRUE(std::ranges::is_sorted(angles));
  }
}

TEST_P(Traverse, CellsOfEdge) {
  std::vector<CellId> cells;
  for (EdgeId e = 0; e < c_.edges.size(); ++e) {
    cells_of_edge(c_, e, cells);
    std::set<CellId> truth;
    std::size_t count = 0;
    for (const Pair& p : c_.pairs) {
      if (p.edge != e) continue;
      ++count;
      truth.insert(c_.faces[p.face].cell[0]);
      truth.insert(c_.faces[p.face].cell[1]);
    }
    EXPECT_EQ(set_of(cells), truth);
    EXPECT_EQ(cells.size(), count);
  }
}

TEST_P(Traverse, EdgesOfVertex) {
  Marks marks;
  std::vector<EdgeId> edges;
  for (VertexId v = 0; v < c_.vertices.size(); ++v) {
    edges_of_vertex(c_, v, marks, edges);
    std::set<EdgeId> truth;
    for (EdgeId e = 0; e < c_.edges.size(); ++e) {
      if (c_.edges[e].vertex[0] == v || c_.edges[e].vertex[1] == v) truth.insert(e);
    }
    EXPECT_EQ(set_of(edges), truth);
    EXPECT_EQ(edges.size(), truth.size());
  }
}

TEST_P(Traverse, PairAcross) {
  for (PairId p = 0; p < c_.pairs.size(); ++p) {
    for (const CellId cell : c_.faces[c_.pairs[p].face].cell) {
      const PairId q = pair_across(c_, p, cell);
      EXPECT_EQ(c_.pairs[q].edge, c_.pairs[p].edge);
      EXPECT_TRUE(bounds(c_.pairs[q].face, cell));
      EXPECT_NE(q, p);
      EXPECT_EQ(pair_across(c_, q, cell), p);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Traverse, ::testing::Range(0, 12));

}  // namespace
}  // namespace sightline::testing
