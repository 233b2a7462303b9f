#include "scene/read.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <mutex>
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

/// A new file under a temporary name, gone again if it is not renamed. All are linked, for remove_temporary_files.
class Temporary {
 public:
  /// Opens it: `fd` is -1 where that fails, and errno says why.
  explicit Temporary(const char* name) : name_(name) {
    const std::lock_guard lock(mutex_);
    fd_ = ::open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ >= 0) link();
  }
  ~Temporary() {
    if (fd_ < 0 || renamed_) return;
    const std::lock_guard lock(mutex_);
    ::unlink(name_);
    unlink();
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int fd() const { return fd_; }
  /// 0, or the error.
  int rename(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    if (::rename(name_, file.c_str()) != 0) return errno;
    renamed_ = true;
    unlink();
    return 0;
  }
  static void remove_all() noexcept {
    mutex_.lock();  // for ever: whoever still writes waits for the end of the process
    for (const Temporary* t = first_; t != nullptr; t = t->next_) ::unlink(t->name_);
  }

 private:
  void link() {
    next_ = first_;
    if (first_ != nullptr) first_->before_ = this;
    first_ = this;
  }
  void unlink() {
    (before_ != nullptr ? before_->next_ : first_) = next_;
    if (next_ != nullptr) next_->before_ = before_;
  }

  static inline std::mutex mutex_;
  static inline Temporary* first_ = nullptr;
  const char* name_;
  int fd_ = -1;
  bool renamed_ = false;
  Temporary* before_ = nullptr;
  Temporary* next_ = nullptr;
};

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
  for (;;) {
    std::filesystem::path name = file;
    name += ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    Temporary temporary(name.c_str());
    if (temporary.fd() < 0 && errno == EEXIST) continue;
    if (temporary.fd() < 0) fail_system(errno, file);
    int error = close_after(temporary.fd(), write_all(temporary.fd(), content));
    if (error == 0) error = temporary.rename(file);
    if (error != 0) fail_system(error, file);
    return;
  }
}

void remove_temporary_files() noexcept { Temporary::remove_all(); }

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
