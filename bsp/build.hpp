// From a scene to its winged-pair complex.
#pragma once

#include "bsp/weights.hpp"
#include "winged_pair/complex.hpp"

namespace sightline {

struct BuildOptions {
  ChoiceWeights weights;  // other weights make another complex of the same scene, with the same maps
};

struct BuildStats {
  double seconds = 0;        // from the scene in memory to the complex
  std::size_t bytes = 0;     // of the complex
  std::uint32_t splits = 0;  // pieces of surfaces cut by planes
};

/// Binary space partition of the scene's enlarged bounding box (Funkhouser 1999, section 3): cells convex, every face
/// convex and wholly inside or outside of every polygon, every polygon covered by the faces that carry it. Takes any
/// scene: interpenetrating, coplanar, duplicate, nearly coplanar polygons. Deterministic.
Complex build(const Scene& scene, const BuildOptions& options = {}, BuildStats* stats = nullptr);

/// Bytes that a complex holds in memory.
std::size_t complex_bytes(const Complex& complex);

}  // namespace sightline
