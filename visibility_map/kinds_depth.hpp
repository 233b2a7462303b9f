// Which of the two planes beside a stretch of a line is nearer. Internal to visibility_map/.
#pragma once

#include "visibility_map/stitch_state.hpp"

namespace sightline::stitching {

/// The order in depth of planes p and q at a stretch's ends: +1 where p is nearer, 0 where they are equally far. Along
/// the stretch it is linear (up to a positive factor): both 0 means 0 all along, and it changes at most once, where the
/// stretch's line meets `equal`. Two equal signs other than 0 may stand for "this sign within, and 0 at most at an
/// end".
struct Depths {
  Sign from, to;
  SightlineRef equal{};  // set where from * to < 0
  bool certain() const { return from != uncertain && to != uncertain; }
};

/// By doubles; either sign may be `uncertain`.
Depths filter_depths(const State& s, const Stretch& stretch, PlaneId p, PlaneId q);
/// From edges of the scene in plane p that carry the stretch, against plane q (of the polygon that shows it): exact
/// where it answers. Depths along the stretch are those of the edge, and a segment whose ends are on the eye's side of
/// q is so within.
Depths carried_depths(State& s, const std::vector<Carrier>& carriers, const Shown& q);
/// Always an answer.
Depths exact_depths(State& s, const Stretch& stretch, const Shown& p, const Shown& q);

}  // namespace sightline::stitching
