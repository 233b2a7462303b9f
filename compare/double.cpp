// The engine `front-to-back` on plain doubles: a program of its own, in which other sources stand in the place of the
// exact stages (compare/plain/).
#include "compare/companion.hpp"
#include "compare/packing.hpp"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace sightline::comparison {
namespace {

constexpr const char* program = "sightline-double";

/// The program does what may go wrong in children of its own: it always answers.
class Double : public Method {
 public:
  explicit Double(const Scene& scene) {
    const std::filesystem::path path = companion(program);
    std::array<int, 2> ends;
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw std::runtime_error("no socket");
    pipe_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDIN_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t nothing;
    sigemptyset(&nothing);
    posix_spawnattr_setsigmask(&attributes, &nothing);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    std::string name = program;
    std::array<char*, 2> arguments{name.data(), nullptr};
    const int error = posix_spawn(&child_, path.c_str(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (error != 0) {
      close(pipe_);
      throw std::runtime_error(path.string() + ": " + std::generic_category().message(error));
    }
    const std::string why = asked(packed(scene));
    if (!why.empty() || reply_.size() != sizeof prepare_seconds_) {
      end();
      throw std::runtime_error(why);
    }
    std::memcpy(&prepare_seconds_, reply_.data(), sizeof prepare_seconds_);
  }
  ~Double() override { end(); }

  double spent_elsewhere() const override { return prepare_seconds_; }
  Measured view(const Camera& camera, double usual) override {
    const Request request{camera, 2 + 50 * usual};
    Measured out;
    out.why = asked({reinterpret_cast<const char*>(&request), sizeof request});
    if (!out.why.empty()) return out;
    try {
      return unpacked(reply_);
    } catch (const std::runtime_error& error) {
      out.why = error.what();
      return out;
    }
  }

 private:
  /// Leaves an answer in reply_, or returns the reason why there is none.
  std::string asked(std::string_view request) {
    if (!send(pipe_, request) || !receive(pipe_, reply_) || reply_.empty()) return "the program has ended";
    const bool answered = reply_.front() == '+';
    reply_.erase(0, 1);
    return answered ? std::string() : reply_;
  }
  void end() {
    close(pipe_);
    int status = 0;
    waitpid(child_, &status, 0);
  }

  double prepare_seconds_ = 0;
  int pipe_ = -1;
  pid_t child_ = 0;
  std::string reply_;
};

}  // namespace

std::unique_ptr<Method> make_double(const Scene& scene) { return std::make_unique<Double>(scene); }

}  // namespace sightline::comparison
