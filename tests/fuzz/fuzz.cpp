#include "tests/fuzz/fuzz.hpp"

#include <cstdio>
#include <cstdlib>

#include "tests/scene/temporary_folder.hpp"

namespace sightline::fuzz {

void fault(const std::string& what) {
  std::fprintf(stderr, "fault: %s\n", what.c_str());
  std::abort();
}

void expect_one_line(const std::string& message) {
  expect(!message.empty(), "an empty message");
  if (message.find('\n') != std::string::npos) fault("a message of several lines: " + message);
}

std::filesystem::path as_file(std::string_view content, const char* ending) {
  static const test::TemporaryFolder folder;
  return folder.write(std::string("input") + ending, content);
}

}  // namespace sightline::fuzz
