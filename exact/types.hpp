// The names that everything exact is spoken in.
#pragma once

#include <gmpxx.h>

#include <cstdint>

namespace sightline {

/// An integer of any length: the end of every chain of fixed widths, and the type in which tables are filled.
using Integer = mpz_class;

/// The sign of an exact quantity: -1, 0 or +1. Stages may also answer `uncertain`; public predicates never do.
using Sign = int;
inline constexpr Sign uncertain = 2;

using PointId = std::uint32_t;      // a point of the scene: its vertex index in the file
using PlaneId = std::uint32_t;      // an interned canonical plane
using SightlineId = std::uint32_t;  // an interned canonical plane through the eye of one camera
inline constexpr std::uint32_t none = 0xffffffffu;

/// A sightline with a side: its oriented normal is `sign` times the canonical normal of `id`.
struct SightlineRef {
  SightlineId id = none;
  Sign sign = 1;
  SightlineRef operator-() const { return {id, -sign}; }
  bool operator==(const SightlineRef&) const = default;
};

}  // namespace sightline
