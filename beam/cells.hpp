// The engine `cells`. Internal to beam/.
#pragma once

#include <memory>

#include "beam/topology.hpp"
#include "beam/view.hpp"

namespace sightline {

/// Funkhouser 1999, section 4: beams go depth first through transparent faces, trimmed by each. Copies share what was
/// gathered from the complex.
std::unique_ptr<Engine> cells_engine(const Scene& scene, const Complex& complex, double max_distance);

}  // namespace sightline
