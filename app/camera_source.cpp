#include "app/camera_source.hpp"

#include "app/exit_codes.hpp"

#include <stdexcept>

namespace sightline::app {

namespace {

constexpr std::size_t batch = 4096;

}  // namespace

CameraSource::CameraSource(const std::filesystem::path& file, const std::vector<double>& window) : window_(window) {
  reader_.emplace(file);
  if (!reader_->regular()) return;
  total_ = 0;
  for (bool more = true; more;) {
    cameras_.clear();
    more = reader_->read(cameras_, batch, batch);
    *total_ += cameras_.size();
  }
  reader_.emplace(file);
}

void CameraSource::next() {
  cameras_.clear();
  ended_ = !reader_->read(cameras_, first_ ? few_cameras : 1, batch);
  first_ = false;
  if (window_.empty()) return;
  try {
    for (Camera& c : cameras_) c = crop(c, {window_[0], window_[1]}, {window_[2], window_[3]});
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--window: ") + error.what());
  }
}

}  // namespace sightline::app
