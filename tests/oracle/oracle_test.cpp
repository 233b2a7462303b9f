// Maps of small scenes against the oracle, face by face and edge by edge. SIGHTLINE_CASES=n makes n cases instead of
// the usual few hundred, SIGHTLINE_FIRST=k begins with seed k, SIGHTLINE_DUMP=folder writes what fails there,
// minimised.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/oracle/judging.hpp"

namespace sightline::oracle {
namespace {

using testing::Case;
using testing::make_case;

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* wanted = std::getenv(name);
  return wanted == nullptr ? usual : std::strtoull(wanted, nullptr, 10);
}

TEST(Oracle, AgreesOnDegenerateScenes) {
  const std::uint64_t first = setting("SIGHTLINE_FIRST", 0), count = setting("SIGHTLINE_CASES", 400);
  const char* dump = std::getenv("SIGHTLINE_DUMP");
  int failures = 0;
  for (std::uint64_t seed = first; seed < first + count && failures < 20; ++seed) {
    const Case sample = make_case(seed, 4 + static_cast<int>(seed % 9));
    const std::string different = judge(sample);
    EXPECT_EQ(different, "") << "seed " << seed;
    if (different.empty()) continue;
    ++failures;
    if (dump == nullptr) continue;
    const Case smaller = minimised(sample);
    const std::filesystem::path file = std::string(dump) + "/case" + std::to_string(seed) + ".obj";
    write_case(file, smaller, judge(smaller));
  }
}

/// Every scene that once came out wrong. Each file says what it showed.
TEST(Oracle, AgreesOnCorpus) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SIGHTLINE_CORPUS)) {
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const auto& file : files) {
    for (const Case& sample : read_cases(file)) EXPECT_EQ(judge(sample), "") << file;
  }
}

}  // namespace
}  // namespace sightline::oracle
