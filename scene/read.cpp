#include "scene/read.hpp"

#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace sightline {
namespace {

[[noreturn]] void fail_system(const std::string& file, const char* what) {
  fail_input(file, 0, {"file"}, std::string(what) + ": " + std::generic_category().message(errno));
}

struct Descriptor {
  int fd;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

struct Format {
  const char* extension;
  PolygonSoup (*read)(const std::string&, std::string_view);
};
constexpr std::array<Format, 4> formats{
    {{".obj", read_obj}, {".ply", read_ply}, {".off", read_off}, {".stl", read_stl}}};

}  // namespace

std::string load_file(const std::string& file) {
  const Descriptor in{::open(file.c_str(), O_RDONLY | O_CLOEXEC)};
  if (in.fd < 0) fail_system(file, "cannot be opened");
  struct stat status {};
  if (::fstat(in.fd, &status) != 0) fail_system(file, "cannot be read");
  if (S_ISDIR(status.st_mode)) fail_input(file, 0, {"file"}, "is a folder");
  std::string content;
  // One byte more than the file is said to have shows its end without another read; a pipe grows step by step.
  constexpr std::size_t step = 1 << 16;
  std::size_t length = 0;
  content.resize(std::max(static_cast<std::size_t>(status.st_size) + 1, step));
  for (;;) {
    if (length == content.size()) content.resize(2 * content.size());
    const ssize_t got = ::read(in.fd, content.data() + length, content.size() - length);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_system(file, "cannot be read");
    if (got == 0) break;
    length += static_cast<std::size_t>(got);
  }
  content.resize(length);
  if (content.empty()) fail_input(file, 0, {"file"}, "is empty");
  return content;
}

PolygonSoup read_polygons(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  const auto format =
      std::find_if(formats.begin(), formats.end(), [&](const Format& f) { return extension == f.extension; });
  if (format == formats.end()) {
    fail_input(file.string(), 0, {"file"}, "has none of the extensions .obj, .ply, .off, .stl");
  }
  PolygonSoup soup = format->read(file.string(), load_file(file.string()));
  if (soup.first.size() == 1) fail_input(file.string(), 0, {"file"}, "holds no polygon");
  soup.source = file.filename().string();
  return soup;
}

}  // namespace sightline
