// Open CASCADE's exact hidden-line removal, HLRBRep_Algo. The view is mapped projectively first and then looked at in
// parallel: its own perspective projector takes straight edges for what they are only up to its tolerance.
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRep_Builder.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>

#include <glm/geometric.hpp>

#include "bench/compare/piecewise.hpp"

namespace sightline::peers {
namespace {

/// The window's width and the range of depths in its units: its tolerance is 1e-7.
constexpr double extent = 1000;

class HiddenLines : public PiecewisePeer {
 public:
  HiddenLines() : PiecewisePeer("occt") {}

  Outcome map(const Camera& camera, Want) override {
    Outcome out;
    try {
      const double start = cpu_seconds();
      project(*scene_, pieces_, camera, view_);
      TopoDS_Compound compound;
      BRep_Builder builder;
      builder.MakeCompound(compound);
      for (std::uint32_t k = 0; k < view_.size(); ++k) add(k, builder, compound);
      const Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo;
      algorithm->Add(compound);
      // Looks along -z: the largest 1 / depth is the nearest.
      algorithm->Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0))));
      algorithm->Update();
      algorithm->Hide();
      HLRBRep_HLRToShape shapes(algorithm);
      const TopoDS_Shape visible = shapes.VCompound();
      out.seconds = cpu_seconds() - start;
      if (!visible.IsNull()) {
        for (TopExp_Explorer e(visible, TopAbs_EDGE); e.More(); e.Next()) ++out.edges;
      }
    } catch (const Standard_Failure& e) {
      out.status = Status::failed;
      out.note = std::string("OCCT: ") + e.GetMessageString();
    }
    return out;
  }

 private:
  void add(std::uint32_t k, const BRep_Builder& builder, TopoDS_Compound& compound) const {
    BRepBuilderAPI_MakePolygon border;
    glm::dvec3 normal(0), middle(0);
    const auto loop = view_.of(k);
    const auto place = [&](std::size_t i) {
      const glm::dvec3& p = loop[i % loop.size()];
      return glm::dvec3(p.x * extent, p.y * extent, p.z / view_.nearest * extent);
    };
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec3 p = place(i);
      normal += glm::cross(p - place(0), place(i + 1) - place(0));
      middle += p / static_cast<double>(loop.size());
      border.Add(gp_Pnt(p.x, p.y, p.z));
    }
    if (glm::length(normal) < 1e-12) return;
    border.Close();
    if (!border.IsDone()) return;
    const gp_Pln plane(gp_Pnt(middle.x, middle.y, middle.z), gp_Dir(normal.x, normal.y, normal.z));
    BRepBuilderAPI_MakeFace face(plane, border.Wire(), true);
    if (face.IsDone()) builder.Add(compound, face.Face());
  }

  Projected view_;
};

}  // namespace

Methods make_occt() {
  Methods all;
  all.push_back(std::make_unique<HiddenLines>());
  return all;
}

}  // namespace sightline::peers
