// Runs the sightline command as a user does.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace sightline::test {

/// Does the command run under a sanitizer, which takes memory of its own?
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// How a run ended: its exit code, or minus the signal that ended it, and what it printed.
struct Ended {
  int code;
  std::string out, err;
};

/// An empty folder of this name for one test, made anew; the command runs in it.
std::filesystem::path fresh_folder(const std::string& name);

/// `before`: what the new process does before it becomes the command.
pid_t start(const std::filesystem::path& folder, const std::vector<std::string>& arguments, void (*before)() = nullptr);
Ended wait(const std::filesystem::path& folder, pid_t child);
Ended run(const std::filesystem::path& folder, const std::vector<std::string>& arguments, void (*before)() = nullptr);

void write(const std::filesystem::path& file, const std::string& text);
std::string read(const std::filesystem::path& file);
/// Every regular file below a folder, by its path from there.
std::map<std::string, std::string> files_below(const std::filesystem::path& folder);
/// The first n lines of a text that do not begin a comment.
std::string first_lines(const std::string& text, int n);
/// True for one line, ended by its newline, that begins with "sightline: ".
bool one_complaint(const std::string& text);

}  // namespace sightline::test
