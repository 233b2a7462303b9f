#include "bench/compare/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace sightline::peers {
namespace {

double wall_seconds() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// What goes through the pipe before the lists.
struct Header {
  Status status;
  double seconds;
  std::uint32_t faces, edges, vertices, visible, note;
  bool gives_visible;
};

void send(int pipe, const void* data, std::size_t bytes) {
  const char* at = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = write(pipe, at, bytes);
    if (written <= 0) _exit(1);
    at += written;
    bytes -= static_cast<std::size_t>(written);
  }
}

void limit(int resource, double most) {
  const rlimit bound{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(static_cast<__rlimit_resource>(resource), &bound);
}

double address_space() {
  double pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lf", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

[[noreturn]] void answer(int pipe, Method& method, const Camera& camera, const ChildLimits& limits) {
  limit(RLIMIT_CPU, std::ceil(limits.seconds));
  limit(RLIMIT_AS, address_space() + limits.gigabytes * 1e9);
  limit(RLIMIT_CORE, 0);
  rlimit stack{};  // some peers recurse deeply
  getrlimit(RLIMIT_STACK, &stack);
  stack.rlim_cur = stack.rlim_max;
  setrlimit(RLIMIT_STACK, &stack);
  const int silent = open("/dev/null", O_WRONLY);
  if (silent >= 0) dup2(silent, STDERR_FILENO);
  Outcome out;
  try {
    out = method.map(camera, Want::visible);
    if (out.status == Status::done && out.seconds < 0.2) {
      double times[3];
      for (double& t : times) t = method.map(camera, Want::time).seconds;
      std::sort(std::begin(times), std::end(times));
      out.seconds = times[1];
    }
  } catch (const std::exception& e) {
    out = failure(e.what());
  }
  const Header header{out.status,
                      out.seconds,
                      out.faces,
                      out.edges,
                      out.vertices,
                      static_cast<std::uint32_t>(out.visible.size()),
                      static_cast<std::uint32_t>(out.note.size()),
                      out.gives_visible};
  send(pipe, &header, sizeof header);
  send(pipe, out.visible.data(), out.visible.size() * sizeof(PolygonId));
  send(pipe, out.note.data(), out.note.size());
  _exit(0);
}

Outcome parse(const std::string& bytes, int status, double limit_seconds) {
  Outcome out;
  Header header{};
  if (bytes.size() < sizeof header) {
    const bool late = WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL);
    out.status = late ? Status::cut_off : Status::failed;
    out.seconds = late ? limit_seconds : 0;
    out.note = late                  ? "cut off"
               : WIFSIGNALED(status) ? std::string("ended by signal ") + strsignal(WTERMSIG(status))
                                     : "gave no answer";
    return out;
  }
  std::memcpy(&header, bytes.data(), sizeof header);
  out.status = header.status;
  out.seconds = header.seconds;
  out.faces = header.faces;
  out.edges = header.edges;
  out.vertices = header.vertices;
  out.gives_visible = header.gives_visible;
  out.visible.resize(header.visible);
  std::memcpy(out.visible.data(), bytes.data() + sizeof header, header.visible * sizeof(PolygonId));
  out.note = bytes.substr(sizeof header + header.visible * sizeof(PolygonId), header.note);
  return out;
}

}  // namespace

Outcome map_in_child(Method& method, const Camera& camera, const ChildLimits& limits) {
  int ends[2];
  if (pipe(ends) != 0) return failure("no pipe");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    return failure("no process");
  }
  if (child == 0) {
    close(ends[0]);
    answer(ends[1], method, camera, limits);
  }
  close(ends[1]);
  // Processor time is bounded by the child's own limit; the wall only guards against one that sleeps.
  const double end = wall_seconds() + 4 * limits.seconds + 30;
  std::string bytes;
  char buffer[65536];
  for (;;) {
    pollfd ready{ends[0], POLLIN, 0};
    const int some = poll(&ready, 1, 1000);
    if (some > 0) {
      const ssize_t got = read(ends[0], buffer, sizeof buffer);
      if (got <= 0) break;
      bytes.append(buffer, static_cast<std::size_t>(got));
    } else if (wall_seconds() > end) {
      kill(child, SIGKILL);
      break;
    }
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  return parse(bytes, status, limits.seconds);
}

}  // namespace sightline::peers
