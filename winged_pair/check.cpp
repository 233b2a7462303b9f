#include "winged_pair/check.hpp"

#include "winged_pair/check_stages.hpp"

namespace sightline {

std::vector<std::string> check(const Complex& complex, const Scene& scene, std::size_t most) {
  using namespace check_detail;
  Faults faults(most == 0 ? 1 : most);
  check_references(complex, scene, faults);
  if (faults.empty()) check_topology(complex, faults);
  if (faults.empty()) check_vertices(complex, scene, faults);
  if (faults.empty()) check_convexity(complex, faults);
  if (faults.empty()) {
    check_labels(complex, scene, faults);
    check_volume(complex, faults);
  }
  return std::move(faults.lines());
}

}  // namespace sightline
