// sightline verify SCENE MAP.json ..: runs the separate program sightline-verify, which shares no code with the kernel.
#include "app/exit_codes.hpp"
#include "app/interrupt.hpp"
#include "app/messages.hpp"
#include "app/options.hpp"
#include "app/report.hpp"
#include "app/stopwatch.hpp"
#include "compare/companion.hpp"

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstring>
#include <system_error>

namespace sightline::app {

namespace {

constexpr const char* program = "sightline-verify";

/// Starts it with the signals that this process holds back let through.
pid_t start(const std::filesystem::path& verifier, const std::vector<std::string>& arguments) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t nothing;
  sigemptyset(&nothing);
  posix_spawnattr_setsigmask(&attributes, &nothing);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t child = 0;
  const int error = posix_spawn(&child, verifier.c_str(), nullptr, &attributes, argv.data(), environ);
  posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), verifier.string());
  return child;
}

struct VerifyCommand {
  CommonOptions common;
  std::vector<std::string> arguments;  // for the verifier
};

int run_verifier(const std::vector<std::string>& arguments) {
  const pid_t child = start(comparison::companion(program), arguments);
  set_interrupted_child(child);
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
  }
  set_interrupted_child(0);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  const int signal = WTERMSIG(status);
  if (signal == SIGINT || signal == SIGTERM) return 128 + signal;
  complain(std::string(program) + " was ended by signal " + std::to_string(signal) + " (" + strsignal(signal) + ")");
  return internal_error;
}

int verify_maps(VerifyCommand& command) {
  std::vector<std::string> arguments = command.arguments;
  if (command.common.threads != 0) {
    arguments.insert(arguments.end(), {"--threads", std::to_string(command.common.threads)});
  }
  check(command.common);
  const Stopwatch watch;
  const int code = run_verifier(arguments);
  Report report{"verify", {}, {}, {}, watch.seconds(), code};
  publish(report, command.common);
  return code;
}

}  // namespace

void add_verify_command(CLI::App& root, Run& run) {
  CLI::App* sub = root.add_subcommand("verify", "Check maps against the scene in exact rationals, independently");
  sub->footer(
      "SCENE MAP.json [MAP.json ..] and all other options are passed to the separate program sightline-verify: "
      "--snap,\n"
      "--one-sided, --cameras FILE, --limit N, --json, -q.\n"
      "Exit code 0: every map is right; 1: a fault was found; 3: bad input; 5: a limit was reached.");
  auto command = std::make_shared<VerifyCommand>();
  add_run_options(*sub, command->common);
  sub->allow_extras();
  sub->callback([sub, command, &run] {
    command->arguments = sub->remaining();
    if (command->arguments.empty())
      throw UsageError("verify: SCENE and MAP.json are needed (see sightline verify --help)");
    run = [command] { return verify_maps(*command); };
  });
}

}  // namespace sightline::app
