// Places that cannot be written to: full, closed, gone. One line, exit code 3, what was there stays.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>

#include <linux/capability.h>

namespace sightline::test {
namespace {

using Words = std::vector<std::string>;

/// Every command that writes, to the folder `to`.
std::vector<Words> commands(const std::string& to) {
  return {{"model", "rooms", "-o", to + "/x.obj"},
          {"build", "m.obj", "-o", to + "/x.wp"},
          {"trace", "m.obj", "--cameras", "m.cameras", "-o", to, "--format", "map"},
          {"trace", "m.obj", "--cameras", "m.cameras", "-o", to, "--format", "svg"},
          {"trace", "m.obj", "--cameras", "m.cameras", "-o", to, "--format", "png"},
          {"trace", "m.obj", "--cameras", "m.cameras", "-o", to, "--format", "pdf"},
          {"trace", "m.obj", "--cameras", "m.cameras", "-o", to, "--format", "csv"},
          {"clip", "m.obj", "--cameras", "one.cameras", "-o", to + "/x.ply"},
          {"compare", "m.obj", "--cameras", "one.cameras", "--methods", "cells", "-o", to},
          {"model", "rooms", "-o", "again.obj", "--report", to + "/report.json"}};
}

std::filesystem::path folder_with_model(const std::string& name) {
  const auto folder = fresh_folder(name);
  EXPECT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  write(folder / "one.cameras", first_lines(read(folder / "m.cameras"), 1));
  return folder;
}

/// Runs each of them and expects a complaint, that what was in `to` is still there, and no temporary file.
void expect_refused(const std::filesystem::path& folder, const std::string& to, void (*before)()) {
  const auto there = files_below(folder / to);
  for (Words words : commands(to)) {
    words.emplace_back("-q");
    const Ended ended = run(folder, words, before);
    EXPECT_EQ(ended.code, 3) << words[0];
    EXPECT_TRUE(one_complaint(ended.err) && ended.err.starts_with("sightline: cannot ")) << words[0] << ended.err;
    auto now = files_below(folder / to);
    for (const auto& [name, content] : there) EXPECT_EQ(now[name], content) << words[0];
    for (const auto& [name, content] : now) EXPECT_EQ(name.find(".tmp"), std::string::npos) << words[0] << name;
  }
}

void let_no_file_grow() {
  const rlimit bytes{300, 300};
  setrlimit(RLIMIT_FSIZE, &bytes);
  signal(SIGXFSZ, SIG_IGN);  // for what this process prints itself
}

/// A limit on the size of files fails as a full disk does: in the middle of a write.
TEST(Places, Full) {
  const auto folder = folder_with_model("full");
  std::filesystem::create_directory(folder / "to");
  write(folder / "to" / "x.wp", "what was there");
  write(folder / "to" / "0000.map.json", "what was there");
  expect_refused(folder, "to", let_no_file_grow);
}

TEST(Places, DevicesThatAreFull) {
  const auto folder = folder_with_model("device");
  for (const char* name : {"x.obj", "x.wp", "x.ply", "report.json"}) {
    std::filesystem::create_symlink("/dev/full", folder / name);
  }
  for (const Words& words : {Words{"model", "rooms", "-o", "x.obj"},
                             {"build", "m.obj", "-o", "x.wp"},
                             {"clip", "m.obj", "--cameras", "one.cameras", "-o", "x.ply"},
                             {"build", "m.obj", "-o", "y.wp", "--report", "report.json"}}) {
    const Ended ended = run(folder, words);
    EXPECT_EQ(ended.code, 3) << words[0];
    EXPECT_NE(ended.err.find("No space left on device"), std::string::npos) << ended.err;
  }
}

/// Root may write everywhere, unless it gives that right away.
void obey_permissions() { prctl(PR_CAPBSET_DROP, CAP_DAC_OVERRIDE, 0, 0, 0); }

TEST(Places, ReadOnly) {
  const auto folder = folder_with_model("read_only");
  std::filesystem::create_directory(folder / "to");
  namespace fs = std::filesystem;
  const auto none = fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  fs::permissions(folder / "to", none, fs::perm_options::remove);
  expect_refused(folder, "to", obey_permissions);
  fs::permissions(folder / "to", none, fs::perm_options::add);
}

/// The folder is removed while maps are written to it.
TEST(Places, Gone) {
  const auto folder = folder_with_model("gone");
  const pid_t child = start(folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "maps", "-q"});
  while (!std::filesystem::exists(folder / "maps")) {
  }
  std::filesystem::rename(folder / "maps", folder / "elsewhere");
  const Ended ended = wait(folder, child);
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
  EXPECT_NE(ended.err.find("cannot write maps/"), std::string::npos) << ended.err;
  for (const auto& [name, text] : files_below(folder / "elsewhere")) {
    EXPECT_TRUE(name.ends_with(".map.json")) << name;
  }
}

}  // namespace
}  // namespace sightline::test
