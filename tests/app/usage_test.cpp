// What the command line may say, and what is answered when it says something else.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>

namespace sightline::test {
namespace {

using Arguments = std::vector<std::string>;

TEST(Usage, WrongUsageIsOneLineAndExitCode2) {
  const auto folder = fresh_folder("wrong");
  ASSERT_EQ(run(folder, {"model", "rooms", "-o", "r.obj"}).code, 0);
  ASSERT_EQ(run(folder, {"build", "r.obj", "-o", "r.wp"}).code, 0);
  const auto before = files_below(folder);
  const Arguments trace{"trace", "r.obj", "--cameras", "r.cameras", "-o", "maps"};
  const auto with = [](Arguments base, const Arguments& more) {
    base.insert(base.end(), more.begin(), more.end());
    return base;
  };
  const std::vector<Arguments> cases{
      {},
      {"paint"},
      {"--nonsense"},
      {"model"},
      {"model", "rooms"},
      {"model", "palace", "-o", "x.obj"},
      {"model", "rooms", "-o", "x.txt"},
      {"model", "city", "--polygons", "-5", "-o", "x.obj"},
      {"model", "city", "--polygons", "many", "-o", "x.obj"},
      {"model", "rooms", "--rotate", "nan", "-o", "x.obj"},
      {"model", "rooms", "--seed", "x", "-o", "x.obj"},
      {"build"},
      {"build", "r.obj"},
      {"build", "r.obj", "-o", "x.txt"},
      {"build", "r.wp", "-o", "x.wp"},
      {"build", "r.obj", "-o", "x.wp", "extra"},
      {"build", "r.obj", "-o", "x.wp", "--nonsense"},
      {"build", "r.obj", "-o", "x.wp", "--snap", "0"},
      {"build", "r.obj", "-o", "x.wp", "--snap", "-1"},
      {"build", "r.obj", "-o", "x.wp", "--snap", "fine"},
      {"build", "r.obj", "-o", "x.wp", "--snap", "inf"},
      {"trace"},
      {"trace", "r.obj", "-o", "maps"},
      {"trace", "r.obj", "--cameras", "r.cameras"},
      {"trace", "r.wp", "--cameras", "r.cameras", "-o", "maps", "--snap", "1e-6"},
      {"trace", "r.wp", "--cameras", "r.cameras", "-o", "maps", "--one-sided"},
      with(trace, {"--min-angle", "-1"}),
      with(trace, {"--window", "0,0,1"}),
      with(trace, {"--window", "0.5,0,0.5,1"}),
      with(trace, {"--window", "0,0,0.3,1"}),
      with(trace, {"--window", "0,0,nan,1"}),
      with(trace, {"--min-angle", "0.5"}),
      with(trace, {"--min-angle", "nan"}),
      with(trace, {"--min-angle", "1e-9", "--engine", "cells"}),
      with(trace, {"--max-distance", "0"}),
      with(trace, {"--max-distance", "nan"}),
      with(trace, {"--max-distance", "5", "--engine", "hybrid"}),
      with(trace, {"--threads", "0"}),
      with(trace, {"--threads", "-1"}),
      with(trace, {"--threads", "two"}),
      with(trace, {"--format", "gif"}),
      with(trace, {"--format", "map,,svg"}),
      with(trace, {"--format"}),
      with(trace, {"--engine", "fast"}),
      with(trace, {"--min-angle", "1e-9", "--engine", "hybrid"}),
      {"verify"},
  };
  for (const Arguments& arguments : cases) {
    std::string line;
    for (const std::string& word : arguments) line += word + " ";
    SCOPED_TRACE(line);
    const Ended ended = run(folder, arguments);
    EXPECT_EQ(ended.code, 2);
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
  EXPECT_EQ(files_below(folder), before);
}

TEST(Usage, HelpAndVersionGoToStandardOutput) {
  const auto folder = fresh_folder("help");
  for (const Arguments& arguments :
       {Arguments{"--help"}, {"model", "--help"}, {"build", "--help"}, {"trace", "--help"}, {"verify", "--help"}}) {
    const Ended ended = run(folder, arguments);
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.out.find("Usage"), std::string::npos);
    EXPECT_EQ(ended.err, "");
  }
  for (const Arguments& arguments : {Arguments{"--version"}, {"trace", "--version"}}) {
    const Ended ended = run(folder, arguments);
    EXPECT_EQ(ended.code, 0);
    EXPECT_TRUE(ended.out.starts_with("sightline 0.")) << ended.out;
    EXPECT_EQ(ended.err, "");
  }
}

}  // namespace
}  // namespace sightline::test
