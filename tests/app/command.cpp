#include "tests/app/command.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace sightline::test {

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(SIGHTLINE_WORK) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

namespace {

fs::path beside(const fs::path& folder, const char* ending) { return folder.string() + ending; }

void redirect(int to, const fs::path& file) {
  const int from = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  if (from < 0 || dup2(from, to) < 0) _exit(126);
  close(from);
}

}  // namespace

pid_t start(const fs::path& folder, const std::vector<std::string>& arguments, void (*before)()) {
  std::vector<std::string> words{SIGHTLINE_COMMAND};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const fs::path out = beside(folder, ".out"), err = beside(folder, ".err");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) {
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    if (chdir(folder.c_str()) != 0) _exit(126);
    if (before != nullptr) before();
    execv(argv[0], argv.data());
    _exit(127);
  }
  return child;
}

Ended wait(const fs::path& folder, pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), read(beside(folder, ".out")),
          read(beside(folder, ".err"))};
}

Ended run(const fs::path& folder, const std::vector<std::string>& arguments, void (*before)()) {
  return wait(folder, start(folder, arguments, before));
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

std::string read(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("no file " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) files[fs::relative(entry.path(), folder).string()] = read(entry.path());
  }
  return files;
}

std::string first_lines(const std::string& text, int n) {
  std::istringstream in(text);
  std::string result, line;
  while (n > 0 && std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    result += line + "\n";
    --n;
  }
  return result;
}

bool one_complaint(const std::string& text) {
  return text.starts_with("sightline: ") && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

}  // namespace sightline::test
