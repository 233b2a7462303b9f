// The rays of a field's samples, cast and counted. For the building of fields.
#pragma once

#include "sample/field.hpp"
#include "sample/ray_caster.hpp"

namespace sightline {

/// Lists of cells one after the other: the samples of one row or more.
struct FieldRow {
  std::vector<std::uint32_t> first{0}, members;
};

/// Made for one slab of a scene and used on one thread; all it is made of must outlive it.
class FieldSampler {
 public:
  FieldSampler(const Scene& scene, const RayCaster& caster, const FieldCells& partition, const FieldOptions& options,
               const FieldSlab& slab);

  /// All samples of one (u,v), s running fastest.
  FieldRow sample(std::uint32_t u, std::uint32_t v);
  std::uint64_t rays() const { return rays_; }

 private:
  /// A ray on its way: it has come to k = begin + gone.
  struct Going {
    glm::dvec3 origin, direction;
    std::uint32_t sample;
    PolygonId last = none;
    double gone = 0, step = 0;
  };

  void send(std::uint32_t u, std::uint32_t v, std::uint32_t t);
  void follow();
  void rank(std::vector<std::uint32_t>& met, FieldRow& row);

  const RayCaster& caster_;
  const FieldCells& partition_;
  const FieldOptions& options_;
  const FieldSlab& slab_;
  // Unit coordinates are base_unit_ + scale_ (world - base_).
  double scale_;
  glm::dvec3 base_, base_unit_;
  std::uint64_t rays_ = 0;
  std::vector<std::vector<std::uint32_t>> met_;  // of each s: the cells that its rays met, as often as they did
  std::vector<Going> going_;
  std::vector<Ray> cast_;
  std::vector<RayHit> hits_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranked_;
};

}  // namespace sightline
