#include "app/options.hpp"

#include "app/exit_codes.hpp"

#include <CLI/CLI.hpp>
#include <thread>

namespace sightline::app {

void add_run_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "Threads to use (default: one a processor)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command.add_option("--engine", options.engine, "Algorithm: front-to-back, cells or hybrid")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--report", options.report, "Write times, counts and decision tallies to this JSON file")
      ->type_name("FILE");
  add_limit_options(command, options.limits);
  command.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "Print the version and exit");
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--snap", options.snap, "Move coordinates and eyes to the nearest multiples of this decimal unit")
      ->type_name("UNIT");
  command.add_flag("--one-sided", options.one_sided, "Polygons are opaque only from their counter-clockwise side");
  add_run_options(command, options);
  command.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
  command.add_flag("--json", options.json, "Print the report to standard output");
}

void check(CommonOptions& options) {
  if (options.engine != "cells" && options.engine != "front-to-back" && options.engine != "hybrid") {
    throw UsageError("--engine " + options.engine + ": no such engine (front-to-back, cells, hybrid)");
  }
  if (options.threads == 0) options.threads = std::max(1u, std::thread::hardware_concurrency());
  apply(options.limits, options.threads);
}

}  // namespace sightline::app
