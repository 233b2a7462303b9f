// What was read and made, in a line each.
#pragma once

#include "app/report.hpp"

#include <string>

namespace sightline::app {

std::string describe(const Scene& scene);
std::string describe(const ComplexFigures& complex);
/// "1 camera", "2 cameras"
std::string counted(std::size_t n, const std::string& noun);

}  // namespace sightline::app
