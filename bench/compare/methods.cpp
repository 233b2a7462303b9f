// Which methods this build has.
#include "bench/compare/method.hpp"

namespace sightline::peers {

std::vector<Source> sources() {
  std::vector<Source> all;
  all.push_back({"ours", "", make_ours});
  all.push_back({"embree", "libembree-dev", {}});
#ifdef SIGHTLINE_COMPARE_EMBREE
  all.back().make = make_embree;
#endif
  all.push_back({"cgal", "libcgal-dev", {}});
#ifdef SIGHTLINE_COMPARE_CGAL
  all.back().make = make_cgal;
#endif
  all.push_back({"gl2ps", "libgl2ps-dev", {}});
#ifdef SIGHTLINE_COMPARE_GL2PS
  all.back().make = make_gl2ps;
#endif
  all.push_back({"occt", "libocct-modeling-algorithms-dev libocct-visualization-dev", {}});
#ifdef SIGHTLINE_COMPARE_OCCT
  all.back().make = make_occt;
#endif
  return all;
}

}  // namespace sightline::peers
