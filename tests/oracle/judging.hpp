// Runs the kernel on a case and lets the oracle judge the map.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/oracle/scenes.hpp"

namespace sightline::oracle {

/// Faults of the complex, then differences between the map and the oracle's, one a line; empty: all is right.
std::string judge(const testing::Case& sample);
/// The same fault with as few polygons and corners as leaving out one after the other leads to.
testing::Case minimised(testing::Case sample);

/// Cases as files: OBJ, with comments `# camera` and twelve numbers (eye, forward, right, up), and `# one-sided`.
void write_case(const std::filesystem::path& file, const testing::Case& sample, const std::string& comment);
/// One case for each camera of the file.
std::vector<testing::Case> read_cases(const std::filesystem::path& file);

}  // namespace sightline::oracle
