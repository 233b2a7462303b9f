// The `.bitfield` file: ASCII, as docs/bitfield.md describes it.
#pragma once

#include "sample/bitfield_samples.hpp"
#include "scene/errors.hpp"

#include <filesystem>
#include <string>

namespace sightline {

/// The file's text. Law: reading it gives the same samples.
std::string bitfield_text(const BitfieldSamples& samples);
/// `file` is the name for messages. Throws InputError naming file, line and item.
BitfieldSamples parse_bitfield(const std::string& file, std::string_view text);
BitfieldSamples read_bitfield(const std::filesystem::path& file);

}  // namespace sightline
