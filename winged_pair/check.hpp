// Proof that a complex is what it claims to be.
#pragma once

#include "winged_pair/complex.hpp"

#include <string>

namespace sightline {

/// Every fault found, one line each, at most `most`; empty: the complex is right. Proves, exactly: references in range;
/// spin and clock inverse to each other; loops closed, direction bits right; rings around edges in geometric order;
/// edges and vertices on their planes; faces convex, each wholly inside or outside of every surface in its plane, with
/// the label that follows; cells convex; Euler numbers of every cell boundary, of every vertex's link and of the whole;
/// cell volumes positive and adding up exactly to the box.
std::vector<std::string> check(const Complex& complex, const Scene& scene, std::size_t most = 20);

}  // namespace sightline
