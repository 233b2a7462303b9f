#include "exact/tally.hpp"

#include <gtest/gtest.h>
#include <thread>
#include <vector>

namespace sightline {
namespace {

TEST(Tally, SumsRunningAndEndedThreads) {
  const Tally before = tally_total();
  tally().identity += 5;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([] {
      for (int k = 0; k < 1000; ++k) ++tally().filter;
      ++tally().exact[3];
    });
  for (std::thread& t : threads) t.join();
  const Tally sum = tally_total() - before;
  EXPECT_EQ(sum.identity, 5u);
  EXPECT_EQ(sum.filter, 4000u);
  EXPECT_EQ(sum.exact[3], 4u);
}

}  // namespace
}  // namespace sightline
