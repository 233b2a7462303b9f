#include "compare/guard.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

namespace sightline::comparison {
namespace {

void limit(__rlimit_resource resource, double most) {
  const rlimit bound{static_cast<rlim_t>(most), static_cast<rlim_t>(most)};
  setrlimit(resource, &bound);
}

double address_space() {
  double pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lf", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// First a byte that says whether it is an answer or a reason, then it.
void send(int pipe, char what, const std::string& text) {
  const std::string all = what + text;
  std::size_t sent = 0;
  while (sent < all.size()) {
    const ssize_t written = write(pipe, all.data() + sent, all.size() - sent);
    if (written <= 0) _exit(1);
    sent += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void be_child(int pipe, const std::function<std::string()>& work, const Limits& limits) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int fault : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGINT, SIGTERM}) std::signal(fault, SIG_DFL);
  limit(RLIMIT_CPU, std::ceil(limits.seconds));
  limit(RLIMIT_AS, address_space() + limits.gigabytes * 1e9);
  limit(RLIMIT_CORE, 0);
  if (const int silent = open("/dev/null", O_WRONLY); silent >= 0) dup2(silent, STDERR_FILENO);
  try {
    send(pipe, '+', work());
  } catch (const std::exception& error) {
    send(pipe, '-', error.what());
  } catch (...) {
    send(pipe, '-', "threw what is no exception");
  }
  _exit(0);
}

/// All that comes through the pipe; false if it takes longer than a child that is bounded by its own limits can.
bool receive(int pipe, double seconds, std::string& bytes) {
  const auto start = std::chrono::steady_clock::now();
  char buffer[65536];
  for (;;) {
    pollfd ready{pipe, POLLIN, 0};
    if (poll(&ready, 1, 1000) > 0) {
      const ssize_t got = read(pipe, buffer, sizeof buffer);
      if (got <= 0) return true;
      bytes.append(buffer, static_cast<std::size_t>(got));
    } else if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > seconds) {
      return false;
    }
  }
}

}  // namespace

Guarded run_guarded(const std::function<std::string()>& work, const Limits& limits) {
  int ends[2];
  if (pipe(ends) != 0) return {{}, "no pipe"};
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    close(ends[0]);
    close(ends[1]);
    return {{}, "no process"};
  }
  if (child == 0) {
    close(ends[0]);
    be_child(ends[1], work, limits);
  }
  close(ends[1]);
  Guarded result;
  // Processor time is bounded by the child's own limit; the wall only guards against one that sleeps.
  if (!receive(ends[0], 10 * limits.seconds + 60, result.bytes)) kill(child, SIGKILL);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    const bool late = signal == SIGXCPU || signal == SIGKILL;
    return {{}, late ? "took too long" : std::string("ended by signal: ") + strsignal(signal)};
  }
  if (result.bytes.empty()) return {{}, "gave no answer"};
  const char what = result.bytes.front();
  result.bytes.erase(0, 1);
  if (what == '-') result.why = std::exchange(result.bytes, {});
  return result;
}

}  // namespace sightline::comparison
