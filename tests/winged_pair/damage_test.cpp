// check() must refuse every kind of damage, and survive it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/winged_pair/samples.hpp"
#include "winged_pair/traverse.hpp"

namespace sightline::testing {
namespace {

struct Damage {
  const char* name;
  std::function<void(Complex&)> inflict;
  const char* fault;  // words of the fault that must be among those found
};

/// A face between two cells that carries a surface, or one that carries none.
FaceId inner_face(const Complex& c, bool opaque) {
  for (FaceId f = 0; f < c.faces.size(); ++f) {
    const Face& face = c.faces[f];
    if (face.cell[0] != none && face.cell[1] != none && (face.label != 0) == opaque) return f;
  }
  throw std::logic_error("no such face");
}
EdgeId inner_edge(const Complex& c) {
  for (EdgeId e = 0; e < c.edges.size(); ++e) {
    std::vector<CellId> cells;
    cells_of_edge(c, e, cells);
    if (cells.size() > 3 && std::ranges::count(cells, none) == 0) return e;
  }
  throw std::logic_error("no such edge");
}

/// Turns the records into those of the mirror image, consistently, but for the sides on which cells lie.
void swap_clocks(Complex& c) {
  for (Pair& p : c.pairs) {
    std::swap(p.clock[0], p.clock[1]);
    p.direction = 1 - p.direction;
  }
}

const std::vector<Damage>& damages() {
  static const std::vector<Damage> list{
      {"VertexPlaneOutOfRange", [](Complex& c) { c.vertices[3].place.plane[1] = c.planes.size(); }, "vertex 3: plane"},
      {"VertexEdgeOutOfRange", [](Complex& c) { c.vertices[3].edge = none; }, "vertex 3: edge"},
      {"VertexEdgeElsewhere",
       [](Complex& c) {
         for (EdgeId e = 0; e < c.edges.size(); ++e) {
           if (c.edges[e].vertex[0] != 3 && c.edges[e].vertex[1] != 3) c.vertices[3].edge = e;
         }
       },
       "does not end in it"},
      {"VertexOfOtherPlanes",
       [](Complex& c) { std::ranges::copy(c.vertices[5].place.plane, c.vertices[6].place.plane); },
       "approximation off"},
      {"VertexMoved", [](Complex& c) { c.vertices[8].place.approx.x += 1e-9; }, "vertex 8: approximation off"},
      {"VertexWithoutBound", [](Complex& c) { c.vertices[8].place.error = std::nan(""); },
       "vertex 8: approximation off"},
      {"VertexOfParallelPlanes", [](Complex& c) { c.vertices[8].place.plane[0] = c.vertices[8].place.plane[1]; },
       "do not meet in one point"},
      {"VerticesAlike", [](Complex& c) { c.vertices[9].place = c.vertices[8].place; }, "the same point"},
      {"VerticesSwapped", [](Complex& c) { std::swap(c.vertices[8].place, c.vertices[9].place); }, "does not lie on"},
      {"EdgeVertexOutOfRange", [](Complex& c) { c.edges[2].vertex[1] = 1u << 31; }, "edge 2: vertex"},
      {"EdgeOfOneVertex", [](Complex& c) { c.edges[2].vertex[1] = c.edges[2].vertex[0]; }, "edge 2: both ends"},
      {"EdgeTurned", [](Complex& c) { std::swap(c.edges[2].vertex[0], c.edges[2].vertex[1]); }, "ends in vertex"},
      {"EdgePlanesTurned", [](Complex& c) { std::swap(c.edges[2].plane[0], c.edges[2].plane[1]); },
       "does not run along"},
      {"EdgePlaneElsewhere", [](Complex& c) { c.edges[2].plane[0] = c.box_plane[1][1]; },
       "edge 2: vertex"},
      {"EdgeOfParallelPlanes", [](Complex& c) { c.edges[2].plane[0] = c.edges[2].plane[1]; }, "do not meet in a line"},
      {"EdgePairElsewhere", [](Complex& c) { c.edges[2].pair = c.edges[3].pair; }, "edge 2: its pair"},
      {"EdgePointsElsewhere", [](Complex& c) { c.edges[inner_edge(c)].a = 0, c.edges[inner_edge(c)].b = 9; },
       "does not lie on its line"},
      {"EdgeOfOnePoint", [](Complex& c) { c.edges[inner_edge(c)].a = 0, c.edges[inner_edge(c)].b = none; },
       "only one scene point"},
      {"FaceCellOutOfRange", [](Complex& c) { c.faces[1].cell[0] = static_cast<CellId>(c.cells.size()); },
       "face 1: cell"},
      {"FaceTurned", [](Complex& c) { std::swap(c.faces[7].cell[0], c.faces[7].cell[1]); }, "differ between them"},
      {"FaceOfOneCell", [](Complex& c) { c.faces[7].cell[0] = c.faces[7].cell[1]; }, "the same cell on both sides"},
      {"FacePlaneElsewhere", [](Complex& c) { c.faces[7].plane = c.faces[0].plane; }, "face 7: vertex"},
      {"FaceLabelOutOfRange", [](Complex& c) { c.faces[7].label = static_cast<LabelId>(c.label_first.size() - 1); },
       "face 7: label"},
      {"FaceLabelLost", [](Complex& c) { c.faces[inner_face(c, true)].label = 0; }, "is wrong, the surfaces on it are"},
      {"FaceLabelGained", [](Complex& c) { c.faces[inner_face(c, false)].label = c.faces[inner_face(c, true)].label; },
       "is wrong, the surfaces on it are none"},
      {"FacePairElsewhere", [](Complex& c) { c.faces[7].pair = c.faces[8].pair; }, "face 7: its pair"},
      {"CellFaceOutOfRange", [](Complex& c) { c.cells[1].face = none; }, "cell 1: face"},
      {"CellFaceElsewhere",
       [](Complex& c) {
         for (FaceId f = 0; f < c.faces.size(); ++f) {
           if (c.faces[f].cell[0] != 1 && c.faces[f].cell[1] != 1) c.cells[1].face = f;
         }
       },
       "cell 1: its face"},
      {"CellTooMany", [](Complex& c) { c.cells.push_back(c.cells[0]); }, "does not bound it"},
      {"NoCell", [](Complex& c) { c.cells.clear(); }, "no cell"},
      {"PairFaceOutOfRange", [](Complex& c) { c.pairs[5].face = none; }, "pair 5: face"},
      {"PairFaceElsewhere", [](Complex& c) { c.pairs[5].face = c.pairs[5].face == 0 ? 1 : 0; },
       "clock leads from face"},
      {"PairEdgeElsewhere", [](Complex& c) { c.pairs[5].edge = c.pairs[c.pairs[5].clock[1]].edge; }, "spin leads from"},
      {"PairTurned", [](Complex& c) { c.pairs[5].direction ^= 1; }, "pair 5: ends in vertex"},
      {"PairDirection", [](Complex& c) { c.pairs[5].direction = 2; }, "pair 5: direction"},
      {"ClockOutOfRange", [](Complex& c) { c.pairs[5].clock[0] = static_cast<PairId>(c.pairs.size()); },
       "pair 5: clock"},
      {"ClockTurned", [](Complex& c) { std::swap(c.pairs[5].clock[0], c.pairs[5].clock[1]); }, "does not lead back"},
      {"SpinOutOfRange", [](Complex& c) { c.pairs[5].spin[1] = none; }, "pair 5: spin"},
      {"SpinShort",
       [](Complex& c) {  // takes a pair out of its ring
         const PairId p = c.edges[inner_edge(c)].pair, next = c.pairs[p].spin[1], last = c.pairs[p].spin[0];
         c.pairs[next].spin[0] = last, c.pairs[last].spin[1] = next;
         c.pairs[p].spin[0] = c.pairs[p].spin[1] = p;
       },
       "differ between them"},
      {"SpinTurned",
       [](Complex& c) {
         const EdgeId e = inner_edge(c);
         std::vector<PairId> ring;
         for_pairs_of_edge(c, e, [&](PairId p) { ring.push_back(p); });
         for (const PairId p : ring) std::swap(c.pairs[p].spin[0], c.pairs[p].spin[1]);
       },
       "differ between them"},
      {"Mirrored",
       [](Complex& c) {  // consistent in itself, but inside out
         swap_clocks(c);
         for (Face& f : c.faces) std::swap(f.cell[0], f.cell[1]);
       },
       "runs clockwise"},
      {"LabelsNotAscending",
       [](Complex& c) {
         for (std::size_t k = 1; k + 1 < c.label_first.size(); ++k) {
           const auto first = c.label_surfaces.begin() + c.label_first[k];
           if (c.label_first[k + 1] - c.label_first[k] > 1) std::swap(first[0], first[1]);
         }
       },
       "not ascending"},
      {"LabelSurfaceOutOfRange", [](Complex& c) { c.label_surfaces[0] = 99; }, "label 1: surface 99"},
      {"LabelTableShort", [](Complex& c) { c.label_first.pop_back(); }, "labels: the table"},
      {"LabelTableTurned", [](Complex& c) { c.label_first[2] = c.label_first[3] + 1; }, "ends before it begins"},
      {"BoxMoved", [](Complex& c) { c.box[1][2] += 1; }, "is not its upper side"},
      {"BoxPlane", [](Complex& c) { c.box_plane[1][0] = c.box_plane[2][0]; }, "is not its lower side along axis 1"},
      {"BoxLarger",
       [](Complex& c) {
         c.box[1][2] += 1;
         c.box_plane[2][1] = c.planes.add_axis(2, c.box[1][2]).id;
       },
       "not in a side of the box"},
      {"PlanesOfOtherScene", [](Complex& c) { c.planes = empty_scene().planes(); }, "planes: "},
      {"VertexAdded", [](Complex& c) { c.vertices.push_back(c.vertices[0]); }, "does not end in it"},
      {"EdgeAdded", [](Complex& c) { c.edges.push_back(c.edges[0]); }, "its pair"},
  };
  return list;
}

class CheckDamage : public ::testing::TestWithParam<Damage> {};

TEST_P(CheckDamage, IsRefused) {
  static const Scene scene = crossing_scene();
  static const Complex right = build(scene);
  static const std::string faults_before = joined(check(right, scene));
  ASSERT_EQ(faults_before, "");
  Complex damaged = right;
  GetParam().inflict(damaged);
  const std::string faults = joined(check(damaged, scene, 1000));
  EXPECT_NE(faults.find(GetParam().fault), std::string::npos) << faults;
}

INSTANTIATE_TEST_SUITE_P(All, CheckDamage, ::testing::ValuesIn(damages()),
                         [](const auto& test) { return std::string(test.param.name); });

/// Any one number of any record changed at random: found, or without meaning (which of several valid references a
/// record holds).
TEST(CheckDamageAnywhere, NeverCrashes) {
  const Scene scene = crossing_scene();
  const Complex right = build(scene);
  std::uint64_t state = 1;
  const auto random = [&state](std::size_t n) {
    state = state * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<std::uint32_t>((state >> 33) % n);
  };
  for (int round = 0; round < 3000; ++round) {
    Complex c = right;
    const auto scramble = [&](auto& records) {
      auto* words = reinterpret_cast<std::uint32_t*>(&records[random(records.size())]);
      words[random(sizeof(records[0]) / 4)] = random(4) == 0 ? none : random(c.pairs.size());
    };
    switch (random(4)) {
      case 0:
        scramble(c.pairs);
        break;
      case 1:
        scramble(c.faces);
        break;
      case 2:
        scramble(c.edges);
        break;
      default:
        c.vertices[random(c.vertices.size())].place.plane[random(3)] = random(c.planes.size());
    }
    const bool refused = !check(c, scene).empty();
    const bool same = std::ranges::equal(c.pairs, right.pairs, [](const Pair& a, const Pair& b) {
      return a.face == b.face && a.edge == b.edge && std::ranges::equal(a.clock, b.clock) &&
             std::ranges::equal(a.spin, b.spin) && a.direction == b.direction;
    });
    EXPECT_TRUE(same || refused) << "round " << round;
  }
}

}  // namespace
}  // namespace sightline::testing
