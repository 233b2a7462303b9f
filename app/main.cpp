// The `sightline` command: one file a subcommand; here, how it ends.
#include "app/exit_codes.hpp"
#include "app/interrupt.hpp"
#include "app/limits.hpp"
#include "app/messages.hpp"
#include "app/options.hpp"
#include "scene/errors.hpp"

#include <CLI/CLI.hpp>
#include <new>

namespace {

using namespace sightline;
using namespace sightline::app;

/// The subcommand on the command line, whose help is the one to look at.
std::string help_hint(const CLI::App& root) {
  for (const CLI::App* command : root.get_subcommands()) return "sightline " + command->get_name() + " --help";
  return "sightline --help";
}

int run_command(int argc, char** argv) {
  CLI::App root("Exact visibility maps of polygon scenes", "sightline");
  root.set_version_flag("--version", "sightline " SIGHTLINE_VERSION, "Print the version and exit");
  root.require_subcommand(1);
  Run run;
  add_model_command(root, run);
  add_build_command(root, run);
  add_trace_command(root, run);
  add_clip_command(root, run);
  add_compare_command(root, run);
  add_bitfield_command(root, run);
  add_field_command(root, run);
  add_verify_command(root, run);
  try {
    root.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return root.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    complain(std::string(error.what()) + " (see " + help_hint(root) + ")");
    return wrong_usage;
  }
  watch_interrupts();
  watch_memory();
  return run();
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_command(argc, argv);
  } catch (const UsageError& error) {
    complain(error.what());
    return wrong_usage;
  } catch (const InputError& error) {
    complain(error.what());
    return bad_input;
  } catch (const OutputError& error) {
    complain(error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    complain("out of memory");
    return limit_reached;
  } catch (const std::length_error& error) {
    complain(std::string("too large: ") + error.what());
    return limit_reached;
  } catch (const std::exception& error) {
    complain(std::string("internal error: ") + error.what());
    return internal_error;
  }
}
