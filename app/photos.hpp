// The part of `clip` that has to do with photographs (`--photos`).
#pragma once

#include "app/options.hpp"
#include "app/report.hpp"
#include "clip/clip.hpp"
#include "photos/image.hpp"

namespace sightline::app {

struct PhotoCommand {
  std::filesystem::path folder;  // empty: no photographs
  int guard = 1;
  double density = 1;
  int page = 4096;
};
void add_photo_options(CLI::App& command, PhotoCommand& options);

/// The photographs FOLDER/0000.png and so on, one a camera; none without a folder. Throws InputError.
std::vector<Image> read_photos(const PhotoCommand& command, std::span<const Camera> cameras);
/// What is written beside OUT.ply: OUT.obj and OUT.mtl. Throws UsageError where that would be the scene's file.
void check_textured(const std::filesystem::path& output, const std::filesystem::path& input);
/// Maps the photographs to the pieces and writes OUT.obj, OUT.mtl and OUT-0.png, OUT-1.png and so on.
PhotoFigures write_textured(const PhotoCommand& command, std::vector<Image> images, const Scene& scene,
                            std::span<const Camera> cameras, const ClipOptions& options, const ClipResult& clipped,
                            const std::filesystem::path& output);

}  // namespace sightline::app
