// --max-memory and --timeout: exit code 5, one line, no half file.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

namespace sightline::test {
namespace {

using Words = std::vector<std::string>;

/// One command of each kind that reads `scene`.
std::vector<Words> commands(const std::string& scene) {
  return {{"build", scene, "-o", "x.wp"},
          {"trace", scene, "--cameras", "m.cameras", "-o", "maps", "--format", "map,svg,png,pdf,csv"},
          {"trace", scene, "--cameras", "m.cameras", "-o", "maps", "--engine", "cells"},
          {"trace", scene, "--cameras", "m.cameras", "-o", "maps", "--engine", "hybrid"},
          {"clip", scene, "--cameras", "m.cameras", "-o", "clipped.ply"},
          {"compare", scene, "--cameras", "m.cameras", "--methods", "double,cells", "-o", "compared"},
          {"verify", scene, "m.map.json"}};
}

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A folder with m.obj, m.cameras and m.map.json.
std::filesystem::path folder_with_model(const std::string& name, const Words& model, const std::string& cameras) {
  const auto folder = fresh_folder(name);
  EXPECT_EQ(run(folder, with({"model"}, with(model, {"-o", "m.obj"}))).code, 0);
  write(folder / "m.cameras", cameras);
  return folder;
}

constexpr const char* camera = "5.5 5.5 1.5  1 0.25 0  0 0 1  60 1.25\n";

TEST(Limits, TimeWhileReading) {
  const auto folder = folder_with_model("time_reading", {"rooms"}, camera);
  ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
  const auto before = files_below(folder);
  for (const Words& words : commands("pipe.obj")) {
    const Ended ended = run(folder, with(words, {"--timeout", "0.05"}));
    EXPECT_EQ(ended.code, 5) << words[0];
    EXPECT_EQ(ended.err, "sightline: the time limit of 0.05 s is reached (--timeout)\n") << words[0];
    EXPECT_EQ(files_below(folder), before) << words[0];
  }
}

/// Whatever had been written when the time was over is whole.
TEST(Limits, TimeWhileWriting) {
  const auto folder = folder_with_model("time_writing", {"rooms"}, "");
  std::filesystem::remove(folder / "m.cameras");
  ASSERT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  write(folder / "m.cameras", first_lines(read(folder / "m.cameras"), 15));
  const Words trace{"trace", "m.obj", "--cameras", "m.cameras", "--format", "map,png", "-o"};
  ASSERT_EQ(run(folder, with(trace, {"whole"})).code, 0);
  const auto whole = files_below(folder / "whole");
  std::filesystem::create_directory(folder / "maps");
  for (const char* seconds : {"0.01", "0.02", "0.05", "0.1", "0.2"}) {
    const Ended ended = run(folder, with(trace, {"maps", "--timeout", seconds}));
    EXPECT_TRUE(ended.code == 5 || ended.code == 0) << ended.code << ended.err;
    for (const auto& [name, content] : files_below(folder / "maps")) {
      ASSERT_TRUE(whole.contains(name)) << name;
      EXPECT_EQ(content, whole.at(name)) << name;
    }
  }
}

TEST(Limits, Memory) {
  if (sanitized) GTEST_SKIP() << "a sanitizer takes more memory than any limit leaves";
  const auto folder = folder_with_model("memory", {"random", "--polygons", "60000"}, camera);
  const auto before = files_below(folder);
  for (const Words& words : commands("m.obj")) {
    const Ended ended = run(folder, with(words, {"--max-memory", "16M", "-q"}));
    if (words[0] == "verify") continue;
    EXPECT_EQ(ended.code, 5) << words[0] << ended.err;
    EXPECT_EQ(ended.err, "sightline: the limit of 16777216 bytes of memory is reached (--max-memory)\n") << words[0];
    EXPECT_EQ(files_below(folder), before) << words[0];
  }
  const Ended model = run(folder, {"model", "random", "--polygons", "60000", "-o", "y.obj", "--max-memory", "2M"});
  EXPECT_EQ(model.code, 5) << model.err;
  EXPECT_TRUE(one_complaint(model.err));
  EXPECT_EQ(files_below(folder), before);
}

/// In the verifier it is GMP that runs out of memory.
TEST(Limits, MemoryOfVerify) {
  if (sanitized) GTEST_SKIP() << "a sanitizer takes more memory than any limit leaves";
  const auto folder = folder_with_model("memory_verify", {"city", "--polygons", "60000"}, camera);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "maps"}).code, 0);
  const Words verify{"verify", "m.obj", "maps/0000.map.json", "--threads", "1"};
  EXPECT_EQ(run(folder, verify).code, 0);
  const Ended ended = run(folder, with(verify, {"--max-memory", "1M"}));
  EXPECT_EQ(ended.code, 5) << ended.err;
  EXPECT_EQ(ended.err, "sightline-verify: out of memory\n");
}

TEST(Limits, EnoughOfBoth) {
  const auto folder = folder_with_model("enough", {"rooms"}, camera);
  Words limits{"--timeout", "1e6"};
  if (!sanitized) limits = with(limits, {"--max-memory", "2G"});
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "free"}).code, 0);
  ASSERT_EQ(run(folder, with({"trace", "m.obj", "--cameras", "m.cameras", "-o", "limited"}, limits)).code, 0);
  EXPECT_EQ(files_below(folder / "free"), files_below(folder / "limited"));
}

TEST(Limits, WrongUsage) {
  const auto folder = fresh_folder("usage");
  for (const Words& words : {Words{"--timeout", "0"},
                             {"--timeout", "-1"},
                             {"--timeout", "nan"},
                             {"--timeout", "1h"},
                             {"--timeout", "1e400"},
                             {"--max-memory", "0"},
                             {"--max-memory", "-1"},
                             {"--max-memory", "5X"},
                             {"--max-memory", "lots"},
                             {"--max-memory", "99999999999G"}}) {
    const Ended ended = run(folder, with({"model", "rooms", "-o", "m.obj"}, words));
    EXPECT_EQ(ended.code, 2) << words[0] << ' ' << words[1];
    EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
    EXPECT_TRUE(files_below(folder).empty());
  }
}

}  // namespace
}  // namespace sightline::test
