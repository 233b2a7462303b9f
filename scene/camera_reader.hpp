// Cameras as they come.
#pragma once

#include "scene/camera.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

namespace sightline {

/// Reads a cameras file, or a pipe, batch by batch, in memory that does not grow with it. What is wrong throws
/// InputError, as read_cameras does; with a pipe, once the cameras before it have been given out.
class CameraReader {
 public:
  explicit CameraReader(const std::filesystem::path& file);
  ~CameraReader();
  CameraReader(const CameraReader&) = delete;
  CameraReader& operator=(const CameraReader&) = delete;

  /// Appends cameras: `most`, or fewer where the file ends, or where as many as `least` have come and more would have
  /// to be waited for. True: there may be more.
  bool read(std::vector<Camera>& cameras, std::size_t least, std::size_t most);
  /// A file that can be read a second time, and no pipe?
  bool regular() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sightline
