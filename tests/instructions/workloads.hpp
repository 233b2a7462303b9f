// Fixed work whose instructions are counted.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace sightline::instructions {

struct Workload {
  std::string name;                                // letters and _
  std::function<std::function<void()>()> prepare;  // not counted; gives what is
};
std::vector<Workload> workloads();

}  // namespace sightline::instructions
