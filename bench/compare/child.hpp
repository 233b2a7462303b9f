// A view computed in a process of its own, which can be ended.
#pragma once

#include "bench/compare/method.hpp"

namespace sightline::peers {

struct ChildLimits {
  double seconds = 60;    // of processor time
  double gigabytes = 12;  // of address space beyond the parent's
};

/// As method.map(camera, Want::visible), in a child: cut off at the limits, failed where it crashes. A short view is
/// run three times there, and its median time counts: the first run pays for the child's own pages.
Outcome map_in_child(Method& method, const Camera& camera, const ChildLimits& limits);

}  // namespace sightline::peers
