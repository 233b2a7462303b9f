#include "app/interrupt.hpp"

#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace sightline::app {

namespace {

std::mutex mutex;
std::condition_variable changed;
int writers = 0;
bool closed = false;
std::atomic<pid_t> child_process = 0;

sigset_t interrupts() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

[[noreturn]] void wait_for_interrupt() {
  const sigset_t set = interrupts();
  int received = SIGINT;
  sigwait(&set, &received);
  // A second signal finds the default action and a thread that lets it through.
  signal(SIGINT, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  if (const pid_t child = child_process) kill(child, received);
  {
    std::unique_lock lock(mutex);
    closed = true;
    changed.wait(lock, [] { return writers == 0; });
  }
  constexpr char message[] = "sightline: interrupted\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(128 + received);
}

}  // namespace

void watch_interrupts() {
  const sigset_t set = interrupts();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  std::thread(wait_for_interrupt).detach();
}

void set_interrupted_child(pid_t child) { child_process = child; }

Writing::Writing() {
  std::unique_lock lock(mutex);
  changed.wait(lock, [] { return !closed; });
  ++writers;
}

Writing::~Writing() {
  const std::lock_guard lock(mutex);
  if (--writers == 0) changed.notify_all();
}

}  // namespace sightline::app
