// The cameras of `trace`, batch by batch.
#pragma once

#include "scene/camera_reader.hpp"

#include <optional>

namespace sightline::app {

inline constexpr std::size_t few_cameras = 16;  // below this many a tree is divided only where they look

/// A file is read through once beforehand, so that nothing is begun for one with a fault; a pipe cannot be.
class CameraSource {
 public:
  /// `window`: empty, or what part of each camera's window is wanted: low s, low t, high s, high t. Throws InputError.
  CameraSource(const std::filesystem::path& file, const std::vector<double>& window);

  /// The next cameras; at first few only if there are no more. Throws InputError; UsageError for the window.
  void next();
  const std::vector<Camera>& cameras() const { return cameras_; }
  bool ended() const { return ended_; }
  /// How many there are in all; nothing is known of a pipe's.
  std::optional<std::size_t> total() const { return total_; }

 private:
  std::optional<CameraReader> reader_;
  std::vector<double> window_;
  std::vector<Camera> cameras_;
  std::optional<std::size_t> total_;
  bool first_ = true, ended_ = false;
};

}  // namespace sightline::app
