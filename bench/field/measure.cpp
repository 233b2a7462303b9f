#include "bench/field/measure.hpp"

#include "bench/cpu_seconds.hpp"

#include <algorithm>
#include <cstdlib>

namespace sightline::bench {

Stage::Stage(const Scene& scene, std::vector<Camera> cameras, std::uint32_t pixels)
    : scene_(scene), cameras_(std::move(cameras)), buffer_(scene, pixels) {
  buffer_.draw(cameras_.front());  // warms what there is to warm
  const double start = cpu_seconds();
  for (const Camera& camera : cameras_) {
    const auto items = buffer_.draw(camera);
    whole_.emplace_back(items.begin(), items.end());
  }
  draw_all_ = (cpu_seconds() - start) / static_cast<double>(cameras_.size());
}

/// `mark` gives the marks of a camera and what they took.
template <class Mark>
Frame Stage::measured(const FieldCells& cells, const Mark& mark) {
  Frame sum;
  std::vector<char> drawn(scene_.polygon_count());
  for (std::size_t k = 0; k < cameras_.size(); ++k) {
    const FieldMarks marks = mark(cameras_[k], sum.look_up);
    const std::vector<PolygonId> polygons = polygons_of(cells, marks.cells);
    std::ranges::fill(drawn, 0);
    for (const PolygonId p : polygons) drawn[p] = 1;
    const double start = cpu_seconds();
    const auto items = buffer_.draw(cameras_[k], drawn);
    sum.draw += cpu_seconds() - start;
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < items.size(); ++i) wrong += items[i] != whole_[k][i] ? 1 : 0;
    sum.wrong += static_cast<double>(wrong) / static_cast<double>(items.size());
    sum.cells += static_cast<double>(marks.cells.size());
    sum.triangles += static_cast<double>(polygons.size());
  }
  for (double* part : {&sum.cells, &sum.triangles, &sum.look_up, &sum.draw, &sum.wrong}) {
    *part /= static_cast<double>(cameras_.size());
  }
  return sum;
}

Frame Stage::look_up(const Field& field, const FieldQueryOptions& options) {
  FieldQuery query(field, options);
  return measured(field.partition, [&](const Camera& camera, double& seconds) {
    const double start = cpu_seconds();
    FieldMarks marks = query.mark(camera);
    seconds += cpu_seconds() - start;
    return marks;
  });
}

Frame Stage::trace(const RayCaster& caster, const FieldCells& cells, std::uint32_t subsample) {
  return measured(cells, [&](const Camera& camera, double& seconds) {
    const double start = cpu_seconds();
    FieldMarks marks = trace_marks(caster, scene_, cells, camera, pixels(), subsample);
    seconds += cpu_seconds() - start;
    return marks;
  });
}

FieldCells cells_near(const Scene& scene, std::uint32_t wanted) {
  const bool named = !scene.soup().objects.empty();
  const auto objects = field_objects(scene, named ? FieldObjects::named : FieldObjects::connected);
  FieldCells best = cells_of_objects(scene, objects, 1);
  const auto apart = [&](const FieldCells& cells) {
    return std::abs(std::int64_t{cells.count} - std::int64_t{wanted});
  };
  double low = 1, high = 256;
  for (int k = 0; k < 24 && apart(best) > 0; ++k) {
    const double along = 0.5 * (low + high);
    FieldCells cells = cells_of_objects(scene, objects, along);
    (cells.count < wanted ? low : high) = along;
    if (apart(cells) < apart(best)) best = std::move(cells);
  }
  return best;
}

}  // namespace sightline::bench
