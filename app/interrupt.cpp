#include "app/interrupt.hpp"

#include "app/exit_codes.hpp"
#include "scene/read.hpp"

#include <pthread.h>
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <thread>

namespace sightline::app {

namespace {

// No locks: memory may run out, and with it the process end, wherever a thread stands.
std::atomic<int> writers = 0;
thread_local int own_writers = 0;
std::atomic<bool> closed = false;
std::atomic<pid_t> child_process = 0;
char time_line[100] = "";

sigset_t watched_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGALRM}) sigaddset(&set, signal);
  return set;
}

constexpr timespec pause_time{0, 5'000'000};
constexpr int most_pauses = 400;

/// Until no other thread writes, for two seconds, or until the next signal.
void wait_for_writers() {
  const sigset_t set = watched_signals();
  for (int pauses = 0; writers > own_writers && pauses < most_pauses; ++pauses) {
    if (sigtimedwait(&set, nullptr, &pause_time) > 0) return;
  }
}

[[noreturn]] void wait_for_signal() {
  const sigset_t set = watched_signals();
  int received = SIGINT;
  sigwait(&set, &received);
  if (received == SIGALRM) end_process(limit_reached, time_line);
  end_process(128 + received, "sightline: interrupted\n");
}

}  // namespace

void watch_interrupts() {
  const sigset_t set = watched_signals();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  // A file that grows beyond its limit is an error like a full disk, and is told in a line.
  signal(SIGXFSZ, SIG_IGN);
  std::thread(wait_for_signal).detach();
}

void limit_time(double seconds) {
  std::snprintf(time_line, sizeof time_line, "sightline: the time limit of %g s is reached (--timeout)\n", seconds);
  const double whole = std::floor(seconds);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  // All zeros would mean no limit.
  timer.it_value.tv_usec = std::clamp<suseconds_t>(static_cast<suseconds_t>((seconds - whole) * 1e6), 1, 999'999);
  setitimer(ITIMER_REAL, &timer, nullptr);
}

[[noreturn]] void end_process(int exit_code, const char* line) noexcept {
  if (closed.exchange(true)) {
    for (;;) pause();
  }
  if (const pid_t child = child_process) kill(child, SIGTERM);
  wait_for_writers();
  remove_temporary_files();
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line, std::strlen(line));
  _exit(exit_code);
}

void set_interrupted_child(pid_t child) { child_process = child; }

Writing::Writing() {
  ++own_writers;
  ++writers;
  if (!closed) return;
  --writers;
  for (;;) pause();
}

Writing::~Writing() {
  --writers;
  --own_writers;
}

}  // namespace sightline::app
