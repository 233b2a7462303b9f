#include "scene/camera_reader.hpp"
#include "scene/read.hpp"
#include "scene/text_scanner.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <exception>
#include <limits>
#include <string>
#include <system_error>

namespace sightline {
namespace {

constexpr std::size_t step = 1 << 16;          // bytes read at a time
constexpr std::size_t longest_line = 1 << 20;  // bytes; eleven numbers need far fewer

}  // namespace

struct CameraReader::State {
  std::string file;
  int fd = -1;
  bool regular = false, ended = false;
  std::string text;  // of which what lies before `at` is done with
  std::size_t at = 0;
  std::size_t lines = 0, cameras = 0, bytes = 0;
  std::exception_ptr fault;  // to be told once the cameras before it have been given out

  ~State() {
    if (fd >= 0) ::close(fd);
  }
  [[noreturn]] void fail(const char* what) const {
    fail_input(file, 0, {"file"}, std::string(what) + ": " + std::generic_category().message(errno));
  }
  /// The next line without its end; false where none is complete.
  bool next_line(std::string_view& line) {
    std::size_t end = text.find('\n', at);
    if (end == std::string::npos) {
      if (!ended || at == text.size()) return false;
      end = text.size();
    }
    line = std::string_view(text).substr(at, end - at);
    at = std::min(end + 1, text.size());
    ++lines;
    return true;
  }
  void fill() {
    text.erase(0, at);
    at = 0;
    if (text.size() > longest_line) fail_input(file, lines + 1, {"camera", cameras}, "the line does not end");
    const std::size_t before = text.size();
    text.resize(before + step);
    ssize_t got = 0;
    do {
      got = ::read(fd, text.data() + before, step);
    } while (got < 0 && errno == EINTR);
    if (got < 0) fail("cannot be read");
    text.resize(before + static_cast<std::size_t>(got));
    bytes += static_cast<std::size_t>(got);
    ended = got == 0;
  }
  void parse(std::string_view line, std::vector<Camera>& out) {
    static constexpr std::array<const char*, 11> names{"eye x", "eye y", "eye z", "forward x", "forward y", "forward z",
                                                       "up x",  "up y",  "up z",  "angle",     "aspect"};
    TextScanner in(file, line, {.comments = true, .continuations = false}, lines);
    if (!in.find_token()) return;
    const Item item{"camera", cameras};
    std::array<double, names.size()> v{};
    for (std::size_t k = 0; k < v.size(); ++k) v[k] = in.number(item, names[k]);
    if (!in.at_line_end()) in.fail(item, quoted(in.token()) + " is one number too many");
    try {
      out.push_back(make_camera({v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9], v[10]));
    } catch (const std::invalid_argument& e) {
      in.fail(item, e.what());
    }
    ++cameras;
  }
};

CameraReader::CameraReader(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  state_->file = file.string();
  state_->fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (state_->fd < 0) state_->fail("cannot be opened");
  struct stat status {};
  if (::fstat(state_->fd, &status) != 0) state_->fail("cannot be read");
  if (S_ISDIR(status.st_mode)) fail_input(state_->file, 0, {"file"}, "is a folder");
  state_->regular = S_ISREG(status.st_mode);
}

CameraReader::~CameraReader() = default;

bool CameraReader::regular() const { return state_->regular; }

bool CameraReader::read(std::vector<Camera>& cameras, std::size_t least, std::size_t most) {
  State& s = *state_;
  if (s.fault) std::rethrow_exception(s.fault);
  const std::size_t before = cameras.size();
  while (cameras.size() - before < most) {
    std::string_view line;
    if (s.next_line(line)) {
      try {
        s.parse(line, cameras);
      } catch (const InputError&) {
        if (s.regular || cameras.size() == before) throw;
        s.fault = std::current_exception();
        return true;
      }
    } else if (s.ended) {
      if (s.bytes == 0) fail_input(s.file, 0, {"file"}, "is empty");
      if (s.cameras == 0) fail_input(s.file, 0, {"file"}, "holds no camera");
      return false;
    } else if (cameras.size() - before >= least && !s.regular) {
      return true;
    } else {
      s.fill();
    }
  }
  return true;
}

std::vector<Camera> read_cameras(const std::filesystem::path& file) {
  constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  std::vector<Camera> cameras;
  CameraReader(file).read(cameras, all, all);
  return cameras;
}

}  // namespace sightline
