// What sampled methods hold in memory.
#pragma once

#include <cstddef>

namespace sightline::comparison {

/// Bytes, the scene itself apart.
struct MethodMemory {
  std::size_t kept = 0;      // for looking up: what was sampled, or a buffer
  std::size_t building = 0;  // beside that, the most at a time while sampling: Embree's tree, an exact tree, a buffer
};

/// Methods that know it. It grows with the views that were asked for where samples are taken when they are needed.
class TellsMemory {
 public:
  TellsMemory() = default;
  virtual ~TellsMemory() = default;
  TellsMemory(const TellsMemory&) = delete;
  TellsMemory& operator=(const TellsMemory&) = delete;

  virtual MethodMemory memory() const = 0;
};

}  // namespace sightline::comparison
