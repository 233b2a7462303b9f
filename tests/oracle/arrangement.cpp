#include "tests/oracle/arrangement.hpp"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <unordered_map>

namespace sightline::oracle {
namespace {

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Traits = CGAL::Arr_segment_traits_2<Kernel>;
using Planar = CGAL::Arrangement_2<Traits>;

Traits::Point_2 to_cgal(const Point& p) { return {CGAL::Gmpq(p.x.get_mpq_t()), CGAL::Gmpq(p.y.get_mpq_t())}; }
Point from_cgal(const Traits::Point_2& p) { return {mpq_class(p.x().mpq()), mpq_class(p.y().mpq())}; }

}  // namespace

Arrangement arrange(const std::vector<Segment>& segments) {
  std::vector<Traits::X_monotone_curve_2> curves;
  for (const auto& [a, b] : segments) curves.emplace_back(to_cgal(a), to_cgal(b));
  Planar planar;
  CGAL::insert(planar, curves.begin(), curves.end());

  Arrangement result;
  std::unordered_map<const void*, std::uint32_t> vertex, half_edge, face;
  for (auto v = planar.vertices_begin(); v != planar.vertices_end(); ++v) {
    vertex[&*v] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back(from_cgal(v->point()));
  }
  std::uint32_t count = 0;
  for (auto h = planar.halfedges_begin(); h != planar.halfedges_end(); ++h) half_edge[&*h] = count++;
  face[&*planar.unbounded_face()] = 0;
  count = 1;
  for (auto f = planar.faces_begin(); f != planar.faces_end(); ++f) {
    if (!f->is_unbounded()) face[&*f] = count++;
  }
  for (auto h = planar.halfedges_begin(); h != planar.halfedges_end(); ++h) {
    result.half_edges.push_back(
        {vertex[&*h->source()], half_edge[&*h->twin()], half_edge[&*h->next()], face[&*h->face()]});
  }
  result.faces.resize(count);
  for (auto f = planar.faces_begin(); f != planar.faces_end(); ++f) {
    auto& borders = result.faces[face[&*f]];
    for (auto c = f->outer_ccbs_begin(); c != f->outer_ccbs_end(); ++c) borders.push_back(half_edge[&**c]);
    for (auto c = f->inner_ccbs_begin(); c != f->inner_ccbs_end(); ++c) borders.push_back(half_edge[&**c]);
  }
  return result;
}

}  // namespace sightline::oracle
