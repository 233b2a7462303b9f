// Ctrl-C: exit code 130, no half file.
#include "tests/app/command.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sightline::test {
namespace {

int entries(const std::filesystem::path& folder) {
  int count = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; it != end; it.increment(error)) ++count;
  return count;
}

/// Starts a build that waits for its input, and interrupts it when it does: opening the other end of the pipe succeeds
/// only once the command has begun to read.
TEST(Interrupt, WhileReading) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const auto folder = fresh_folder("reading");
    ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);
    const pid_t child = start(folder, {"build", "pipe.obj", "-o", "x.wp"});
    const int pipe = open((folder / "pipe.obj").c_str(), O_WRONLY);
    ASSERT_GE(pipe, 0);
    kill(child, signal);
    const Ended ended = wait(folder, child);
    close(pipe);
    EXPECT_EQ(ended.code, 128 + signal);
    EXPECT_EQ(ended.err, "sightline: interrupted\n");
    EXPECT_TRUE(files_below(folder).empty());
  }
}

/// Interrupted at some moment of its writing: what is there is whole, and under its own name.
TEST(Interrupt, WhileWriting) {
  const auto folder = fresh_folder("writing");
  ASSERT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "whole", "--format", "map,svg"}).code, 0);
  const auto whole = files_below(folder / "whole");
  std::filesystem::create_directory(folder / "maps");
  for (int tries = 0; tries < 20; ++tries) {
    const pid_t child =
        start(folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "maps", "--format", "map,svg"});
    while (entries(folder / "maps") < tries) {
    }
    kill(child, SIGINT);
    const Ended ended = wait(folder, child);
    EXPECT_TRUE(ended.code == 130 || ended.code == -SIGINT || ended.code == 0) << ended.code;
    for (const auto& [name, text] : files_below(folder / "maps")) {
      ASSERT_TRUE(whole.contains(name)) << name;
      EXPECT_EQ(text, whole.at(name));
    }
  }
}

}  // namespace
}  // namespace sightline::test
