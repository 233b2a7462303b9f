// ID bitfields (Meruvia and Strothotte): the polygons of a list made beforehand, drawn without error.
#include "compare/memory.hpp"
#include "compare/method.hpp"
#include "compare/subset.hpp"
#include "sample/bitfield_viewer.hpp"
#include "sample/bitfield_viewpoints.hpp"

#include <stdexcept>

namespace sightline::comparison {
namespace {

struct BitfieldSetting {
  unsigned samples = 0, neighbours = 6;
};

BitfieldSetting bitfield_setting(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto samples = setting_number(std::string_view(text).substr(0, colon), least_viewpoints, most_viewpoints);
  BitfieldSetting setting;
  if (colon != std::string::npos) {
    const std::string neighbours = text.substr(colon + 1);
    setting.neighbours = neighbours == "3" ? 3 : neighbours == "6" ? 6 : 0;
  }
  if (!samples || setting.neighbours == 0) {
    throw std::invalid_argument("a number of samples from 4 to 16384, and :3 for three neighbours in place of six");
  }
  setting.samples = *samples;
  return setting;
}

BitfieldViewer viewer_of(const Scene& scene, const BitfieldSetting& setting, bool exact, std::size_t& building) {
  std::vector<Camera> cameras;
  for (const CameraLine& c : sphere_cameras(scene, setting.samples)) {
    cameras.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  BitfieldSampling sampling;
  sampling.exact = exact;
  sampling.building_bytes = &building;
  return {sample_bitfields(scene, cameras, sampling), {setting.neighbours, BitfieldViewing::lists, 1}};
}

class Bitfields : public TimedMethod, public TellsMemory {
 public:
  Bitfields(const Scene& scene, const BitfieldSetting& setting, bool exact)
      : scene_(scene), viewer_(viewer_of(scene, setting, exact, building_)) {}
  MethodMemory memory() const override { return {viewer_.bytes(), building_}; }  // its lists

 private:
  void look(const Camera& camera) override {
    polygons_ = viewer_.look(camera).polygons;
    camera_ = camera;
  }

  void tell(Answer& answer) override {
    answer.reported.assign(polygons_.begin(), polygons_.end());
    draw_subset(scene_, answer.reported, camera_, answer.shown.emplace<Drawing>());
  }

  const Scene& scene_;
  std::size_t building_ = 0;
  BitfieldViewer viewer_;
  std::span<const PolygonId> polygons_;
  Camera camera_;
};

template <bool exact>
MakeMethod parse_setting(const std::string& text) {
  const BitfieldSetting setting = bitfield_setting(text);
  return [setting](const Scene& scene) { return std::make_unique<Bitfields>(scene, setting, exact); };
}

}  // namespace

MakeMethod parse_bitfield_method(const std::string& setting) { return parse_setting<false>(setting); }
MakeMethod parse_exact_bitfield_method(const std::string& setting) { return parse_setting<true>(setting); }

}  // namespace sightline::comparison
