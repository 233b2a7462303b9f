// What all subcommands have in common.
#pragma once

#include "app/limits.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace sightline::app {

struct CommonOptions {
  std::string snap;
  bool one_sided = false;
  unsigned threads = 0;  // 0: one a processor
  std::string engine = "front-to-back";
  std::filesystem::path report;
  bool quiet = false;
  bool json = false;
  LimitOptions limits;
};

/// Adds them to a subcommand. Values are checked when `check` is called, after parsing.
void add_common_options(CLI::App& command, CommonOptions& options);
/// Those of them that concern the run and not the scene or the messages: --threads, --engine, --report,
/// --max-memory, --timeout, --version.
void add_run_options(CLI::App& command, CommonOptions& options);
/// Throws UsageError; fills in the number of threads and sets the limits: what a command does first.
void check(CommonOptions& options);

/// The subcommands: each adds itself to the root; when it is chosen on the command line it sets `run`, which returns
/// the exit code.
using Run = std::function<int()>;
void add_model_command(CLI::App& root, Run& run);
void add_build_command(CLI::App& root, Run& run);
void add_trace_command(CLI::App& root, Run& run);
void add_clip_command(CLI::App& root, Run& run);
void add_compare_command(CLI::App& root, Run& run);
void add_bitfield_command(CLI::App& root, Run& run);
void add_field_command(CLI::App& root, Run& run);
void add_verify_command(CLI::App& root, Run& run);

}  // namespace sightline::app
