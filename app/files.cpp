#include "app/files.hpp"

#include "app/exit_codes.hpp"
#include "app/interrupt.hpp"
#include "scene/read.hpp"
#include "winged_pair/file.hpp"

#include <cstdio>
#include <system_error>

namespace sightline::app {

namespace {

Scene read_scene(const std::filesystem::path& file, const SceneOptions& options) {
  PolygonSoup soup = read_polygons(file);
  try {
    return make_scene(std::move(soup), options);
  } catch (const SceneError& error) {
    throw InputError(file.string() + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError("--snap " + options.snap + ": " + error.what());
  }
}

}  // namespace

Input read_input(const std::filesystem::path& file, const CommonOptions& options) {
  if (file.extension() != ".wp") return {read_scene(file, {options.snap, options.one_sided}), {}};
  if (!options.snap.empty() || options.one_sided) {
    throw UsageError("--snap and --one-sided belong to `sightline build`: " + file.string() + " is already built");
  }
  SceneAndComplex both = read_wp(file);
  return {std::move(both.scene), std::move(both.complex)};
}

void write_safely(const std::filesystem::path& file, const std::function<void()>& write) {
  const Writing guard;
  try {
    write();
  } catch (const std::system_error& error) {
    throw OutputError("cannot write " + file.string() + ": " + error.code().message(), error.code());
  }
}

void write_text(const std::filesystem::path& file, std::string_view text) {
  write_safely(file, [&] { write_file(file, text); });
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw OutputError("cannot make folder " + folder.string() + ": " + error.message());
}

std::filesystem::path numbered(const std::filesystem::path& folder, std::size_t number, const char* ending) {
  std::string digits = std::to_string(number);
  if (digits.size() < 4) digits.insert(0, 4 - digits.size(), '0');
  return folder / (digits + ending);
}

void print_result(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    throw OutputError("cannot write to standard output");
  }
}

}  // namespace sightline::app
