#include "scene/growing_file.hpp"

#include "scene/read.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>

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

/// A new file under a temporary name, gone again if it is not renamed. All are linked, for remove_temporary_files. Its
/// folder is held open: should that be moved away meanwhile, the file is completed, or goes, where it is.
class Temporary {
 public:
  /// Opens it: `fd` is -1 where that fails, and errno says why.
  Temporary(const std::filesystem::path& folder, std::string name) : name_(std::move(name)) {
    folder_ = ::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (folder_ < 0) return;
    const std::lock_guard lock(mutex_);
    fd_ = ::openat(folder_, name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd_ >= 0) link();
  }
  ~Temporary() {
    if (fd_ >= 0 && !renamed_) {
      const std::lock_guard lock(mutex_);
      ::unlinkat(folder_, name_.c_str(), 0);
      unlink();
    }
    const int error = errno;
    if (folder_ >= 0) ::close(folder_);
    errno = error;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  int fd() const { return fd_; }
  /// In its folder. 0, or the error.
  int rename(const std::filesystem::path& name) {
    const std::lock_guard lock(mutex_);
    if (::renameat(folder_, name_.c_str(), folder_, name.c_str()) != 0) return errno;
    renamed_ = true;
    unlink();
    return 0;
  }
  static void remove_all() noexcept {
    mutex_.lock();  // for ever: whoever still writes waits for the end of the process
    for (const Temporary* t = first_; t != nullptr; t = t->next_) ::unlinkat(t->folder_, t->name_.c_str(), 0);
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
  std::string name_;
  int folder_ = -1, fd_ = -1;
  bool renamed_ = false;
  Temporary* before_ = nullptr;
  Temporary* next_ = nullptr;
};

}  // namespace

struct GrowingFile::State {
  std::filesystem::path file;
  std::unique_ptr<Temporary> temporary;  // null for a device
  int fd = -1;

  ~State() {
    if (fd >= 0) ::close(fd);
  }
};

GrowingFile::GrowingFile(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.file = file;
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) fail_system(EISDIR, file);
    if (!S_ISREG(status.st_mode)) {
      s.fd = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
      if (s.fd < 0) fail_system(errno, file);
      return;
    }
  }
  static std::atomic<unsigned> counter{0};
  do {
    const std::string ending = ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
    s.temporary = std::make_unique<Temporary>(file.parent_path(), file.filename().string() + ending);
  } while (s.temporary->fd() < 0 && errno == EEXIST);
  s.fd = s.temporary->fd();
  if (s.fd < 0) fail_system(errno, file);
}

GrowingFile::~GrowingFile() = default;

void GrowingFile::append(std::string_view content) {
  if (const int error = write_all(state_->fd, content)) fail_system(error, state_->file);
}

void GrowingFile::finish() {
  State& s = *state_;
  int error = ::close(std::exchange(s.fd, -1)) != 0 ? errno : 0;
  if (error == 0 && s.temporary) error = s.temporary->rename(s.file.filename());
  if (error != 0) fail_system(error, s.file);
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  GrowingFile whole(file);
  whole.append(content);
  whole.finish();
}

void remove_temporary_files() noexcept { Temporary::remove_all(); }

}  // namespace sightline
