// Clipped scenes and texture regions as files.
#pragma once

#include "clip/t_free.hpp"

#include <filesystem>
#include <string>

namespace sightline {

/// Lines `CAMERA interior|exterior s t s t s t ..`, cameras counted from 0, `#` comments. Throws InputError.
std::vector<std::vector<TextureRegion>> read_regions(const std::filesystem::path& file, std::size_t cameras);

/// The pieces as an ASCII PLY file: vertices with 17 significant digits, those with equal coordinates once; faces with
/// `vertex_indices`, `source_polygon` and `cameras`, the list of those that see all of the face, ascending. Corners run
/// as those of the source polygon. Where `thresholded`, a list `partly` follows: cameras that see some of it. With
/// `t_free` the faces have the corners given there.
std::string clip_ply(const Scene& scene, const ClipResult& result, bool thresholded = false,
                     const TFreePieces* t_free = nullptr);

/// CSV as `trace` writes it, header line included: what each camera sees of each polygon, in all of its window,
/// whatever its regions.
std::string clip_csv(const Scene& scene, std::span<const Camera> cameras, const ClipOptions& options = {});

}  // namespace sightline
