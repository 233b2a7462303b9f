// Visibility fields (Blais and Poulin): what is marked is drawn exactly, so that the error is that of the set alone.
#include "sample/field.hpp"
#include "compare/memory.hpp"
#include "compare/method.hpp"
#include "compare/subset.hpp"
#include "sample/field_query.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <map>
#include <stdexcept>
#include <tuple>

namespace sightline::comparison {
namespace {

/// Samples of 81 rays; cells are grids over objects, or polygons.
struct Setting {
  FieldOptions field;
  FieldFilter filter = FieldFilter::nearest;
  bool polygons = false;
};

/// A look-up for each of 128 x 128 pixels.
constexpr FieldQueryOptions one_view{.pixels = 128};
constexpr double cells_along_object = 16, view_cells_along_scene = 16;

/// Fields know what is seen from free space. For eyes outside of the scene's box there is one field of six slabs around
/// it; for eyes within, one for each cube of a grid in which an eye comes to lie, made when it does. Of each only the
/// slabs that a camera looks along are made.
class VisibilityField : public TimedMethod, public TellsMemory {
 public:
  VisibilityField(const Scene& scene, const Setting& setting)
      : scene_(scene), setting_(setting), box_(box_of(scene)), partition_(partition()) {}

  /// Of all fields so far; the numbers of the polygons' cells, which they share, once.
  MethodMemory memory() const override {
    const std::size_t shared = partition_.of.size() * sizeof(std::uint32_t);
    MethodMemory sum{shared, tree_bytes_};
    for (const auto& [key, part] : parts_) sum.kept += field_memory_bytes(part->field) - shared;
    return sum;
  }

 private:
  struct Part {
    Part(Field f, const FieldQueryOptions& options) : field(std::move(f)), query(field, options) {}
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;
    Field field;
    FieldQuery query;
  };
  using Key = std::tuple<int, int, int, std::size_t>;  // place of the view cell, slab

  FieldCells partition() const {
    if (setting_.polygons) return cells_of_polygons(scene_);
    const auto kind = scene_.soup().objects.empty() ? FieldObjects::connected : FieldObjects::named;
    return cells_of_objects(scene_, field_objects(scene_, kind), cells_along_object);
  }

  void approach(const Camera& camera) override {
    const bool within =
        glm::all(glm::lessThanEqual(box_.low, camera.eye)) && glm::all(glm::lessThanEqual(camera.eye, box_.high));
    glm::dvec3 place(-1);
    std::vector<FieldSlab> slabs;
    if (within) {
      const glm::dvec3 size = box_.high - box_.low;
      const glm::dvec3 edge(std::max({size.x, size.y, size.z}) / view_cells_along_scene);
      place = glm::floor((camera.eye - box_.low) / edge);
      slabs = slabs_within({box_.low + place * edge, box_.low + (place + 1.0) * edge});
    } else {
      slabs = slabs_around(box_);
    }
    asked_.clear();
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      if (!meets(slabs[k], camera)) continue;
      const Key key{static_cast<int>(place.x), static_cast<int>(place.y), static_cast<int>(place.z), k};
      auto& part = parts_[key];
      if (part == nullptr) {
        FieldQueryOptions options = one_view;
        options.filter = setting_.filter;
        FieldStats stats;
        part = std::make_unique<Part>(build_field(scene_, {slabs[k]}, partition_, setting_.field, {}, &stats), options);
        tree_bytes_ = stats.tree_bytes;
      }
      asked_.push_back(part.get());
    }
  }

  static bool meets(const FieldSlab& slab, const Camera& camera) {
    const SlabView view(slab, camera);
    const auto within = [](double n, double d) { return d > 0 && n >= 0 && n <= d; };
    for (std::uint32_t k = 0; k < one_view.pixels * one_view.pixels; ++k) {
      const double x = (k % one_view.pixels + 0.5) / one_view.pixels, y = (k / one_view.pixels + 0.5) / one_view.pixels;
      const double uv = view.uv_denominator()(x, y), st = view.st_denominator()(x, y);
      const auto& n = view.numerators();
      if (within(n[0](x, y), uv) && within(n[1](x, y), uv) && within(n[2](x, y), st) && within(n[3](x, y), st)) {
        return true;
      }
    }
    return false;
  }

  void look(const Camera& camera) override {
    std::vector<char> marked(partition_.count);
    for (Part* part : asked_) {
      for (const std::uint32_t cell : part->query.mark(camera).cells) marked[cell] = 1;
    }
    cells_.clear();
    for (std::uint32_t cell = 0; cell < partition_.count; ++cell) {
      if (marked[cell] != 0) cells_.push_back(cell);
    }
    seen_from_ = camera;
  }

  void tell(Answer& answer) override {
    answer.reported = polygons_of(partition_, cells_);
    draw_subset(scene_, answer.reported, seen_from_, answer.shown.emplace<Drawing>());
  }

  const Scene& scene_;
  Setting setting_;
  FieldBox box_;
  FieldCells partition_;
  std::map<Key, std::unique_ptr<Part>> parts_;
  std::vector<Part*> asked_;
  std::vector<std::uint32_t> cells_;
  std::size_t tree_bytes_ = 0;
  Camera seen_from_;
};

/// The text up to a separator, which is taken off with it.
std::string_view cut(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

Setting read(std::string_view text) {
  const std::invalid_argument wrong(
      "samples along u, v, s and t (1 to 4096), the ids of a sample (1 to 65535), and, if wanted, :uv, :st, :uv+st or "
      ":polygons, as in 16x16x32x32:5:uv");
  Setting setting;
  std::string_view samples = cut(text, ':');
  for (std::uint32_t& n : setting.field.samples) {
    const auto number = setting_number(cut(samples, 'x'), 1, 4096);
    if (!number) throw wrong;
    n = *number;
  }
  const auto ids = setting_number(cut(text, ':'), 1, 65535);
  if (!ids || !samples.empty()) throw wrong;
  setting.field.ids = *ids;
  while (!text.empty()) {
    const std::string_view word = cut(text, ':');
    if (word == "uv") {
      setting.filter = FieldFilter::uv;
    } else if (word == "st") {
      setting.filter = FieldFilter::st;
    } else if (word == "uv+st") {
      setting.filter = FieldFilter::uvst;
    } else if (word == "polygons") {
      setting.polygons = true;
    } else {
      throw wrong;
    }
  }
  return setting;
}

}  // namespace

MakeMethod parse_field(const std::string& setting) {
  return [chosen = read(setting)](const Scene& scene) { return std::make_unique<VisibilityField>(scene, chosen); };
}

}  // namespace sightline::comparison
