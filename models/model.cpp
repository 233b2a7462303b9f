#include "models/model.hpp"

#include "models/generators.hpp"

#include <array>
#include <cmath>
#include <stdexcept>

namespace sightline {
namespace {

using namespace models;

/// A turn by an angle about (1,2,3), by Rodrigues' formula.
class Turn {
 public:
  explicit Turn(double degrees) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    c_ = std::cos(angle);
    s_ = std::sin(angle);
    const double size = std::sqrt(14.0);
    axis_ = {1 / size, 2 / size, 3 / size};
  }
  glm::dvec3 operator()(const glm::dvec3& v) const {
    const glm::dvec3 across(axis_.y * v.z - axis_.z * v.y, axis_.z * v.x - axis_.x * v.z,
                            axis_.x * v.y - axis_.y * v.x);
    const double along = (axis_.x * v.x + axis_.y * v.y + axis_.z * v.z) * (1 - c_);
    return {c_ * v.x + s_ * across.x + along * axis_.x, c_ * v.y + s_ * across.y + along * axis_.y,
            c_ * v.z + s_ * across.z + along * axis_.z};
  }

 private:
  double c_, s_;
  glm::dvec3 axis_;
};

void rotate(Model& model, double degrees) {
  const Turn turn(degrees);
  for (glm::dvec3& v : model.soup.vertices) v = turn(v);
  for (CameraLine& c : model.cameras) {
    c.eye = turn(c.eye);
    c.forward = turn(c.forward);
    c.up = turn(c.up);
  }
}

struct Entry {
  const char* name;
  std::uint32_t polygons;  // the paper's
  bool scalable;
  Model (*make)(std::uint32_t polygons, std::uint64_t seed);
};

constexpr std::array<Entry, 9> entries{{
    {"rooms", 20, false, [](std::uint32_t, std::uint64_t) { return make_rooms(); }},
    {"maze", 310, true, make_maze},
    {"arena", 665, false, [](std::uint32_t, std::uint64_t) { return make_arena(); }},
    {"city", 1125, true, make_city},
    {"floor", 1772, true, make_floor},
    {"building", 10057, true, make_building},
    {"tower", 2409, false, [](std::uint32_t, std::uint64_t) { return make_tower(); }},
    {"campus", 660, false, [](std::uint32_t, std::uint64_t seed) { return make_campus(seed); }},
    {"random", 1000, true, make_random},
}};

}  // namespace

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const Entry& entry : entries) names.emplace_back(entry.name);
  return names;
}

Model make_model(const std::string& name, const ModelOptions& options) {
  for (const Entry& entry : entries) {
    if (name != entry.name) continue;
    if (!std::isfinite(options.rotate_degrees)) throw std::invalid_argument(name + ": the angle must be finite");
    const std::uint32_t polygons = options.polygons == 0 ? entry.polygons : options.polygons;
    if (!entry.scalable && polygons != entry.polygons) {
      throw std::invalid_argument(name + ": has " + std::to_string(entry.polygons) + " polygons and no other number");
    }
    Model model = entry.make(polygons, options.seed);
    if (options.rotate_degrees != 0) rotate(model, options.rotate_degrees);
    return model;
  }
  throw std::invalid_argument("no model named '" + name + "'");
}

}  // namespace sightline
