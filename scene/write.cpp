#include "scene/read.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <system_error>

namespace sightline {
namespace {

[[noreturn]] void fail_system(int error, const std::filesystem::path& file) {
  throw std::system_error(error, std::generic_category(), file.string());
}

/// 0, or the error.
int write_all(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t done = ::write(fd, content.data(), content.size());
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(done));
  }
  return 0;
}

int close_after(int fd, int error) { return ::close(fd) != 0 && error == 0 ? errno : error; }

/// A terminal, a pipe or another device cannot be replaced by renaming: it is written to.
void write_device(const std::filesystem::path& file, std::string_view content) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) fail_system(errno, file);
  if (const int error = close_after(fd, write_all(fd, content))) fail_system(error, file);
}

template <class Number>
void append(std::string& text, Number value) {
  char digits[32];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

void append(std::string& text, const glm::dvec3& v) {
  for (int k = 0; k < 3; ++k) {
    append(text, v[k]);
    if (k < 2) text += ' ';
  }
}

}  // namespace

void write_file(const std::filesystem::path& file, std::string_view content) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) fail_system(EISDIR, file);
    if (!S_ISREG(status.st_mode)) return write_device(file, content);
  }
  static std::atomic<unsigned> counter{0};
  std::filesystem::path temporary;
  int fd = -1;
  do {
    temporary = file;
    temporary += ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    fd = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (fd < 0 && errno == EEXIST);
  if (fd < 0) fail_system(errno, file);
  int error = close_after(fd, write_all(fd, content));
  if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail_system(error, file);
  }
}

void write_obj(const std::filesystem::path& file, const PolygonSoup& soup) {
  std::string text;
  text.reserve(48 * soup.vertices.size() + 8 * soup.corners.size());
  for (const glm::dvec3& v : soup.vertices) {
    text += "v ";
    append(text, v);
    text += '\n';
  }
  std::uint32_t object = none;
  for (std::size_t p = 0; p + 1 < soup.first.size(); ++p) {
    const std::uint32_t own = soup.object_of.empty() ? none : soup.object_of[p];
    if (own != object) text += own == none ? "g\n" : "o " + soup.objects[own] + "\n";
    object = own;
    text += 'f';
    for (std::uint32_t k = soup.first[p]; k < soup.first[p + 1]; ++k) {
      text += ' ';
      append(text, std::uint64_t{soup.corners[k]} + 1);
    }
    text += '\n';
  }
  write_file(file, text);
}

void write_cameras(const std::filesystem::path& file, std::span<const CameraLine> cameras) {
  std::string text = "# eye x y z  forward x y z  up x y z  vertical angle in degrees  aspect\n";
  for (const CameraLine& c : cameras) {
    append(text, c.eye);
    text += "  ";
    append(text, c.forward);
    text += "  ";
    append(text, c.up);
    text += "  ";
    append(text, c.vertical_fov_degrees);
    text += ' ';
    append(text, c.aspect);
    text += '\n';
  }
  write_file(file, text);
}

}  // namespace sightline
