// Scenes in, texts out.
#pragma once

#include "app/options.hpp"
#include "scene/scene.hpp"
#include "winged_pair/complex.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string_view>

namespace sightline::app {

struct Input {
  Scene scene;
  std::optional<Complex> complex;  // where the file is a .wp
};
/// Reads a polygon file or a .wp file (by extension). Throws InputError; UsageError for options that do not fit.
Input read_input(const std::filesystem::path& file, const CommonOptions& options);

/// Runs `write`, which writes `file`; an interruption waits for it. Throws OutputError naming the file.
void write_safely(const std::filesystem::path& file, const std::function<void()>& write);
void write_text(const std::filesystem::path& file, std::string_view text);
/// Makes a folder, those above it included. Throws OutputError.
void make_folder(const std::filesystem::path& folder);
/// FOLDER/0007.ending
std::filesystem::path numbered(const std::filesystem::path& folder, std::size_t number, const char* ending);
/// To standard output. Throws OutputError.
void print_result(std::string_view text);

}  // namespace sightline::app
