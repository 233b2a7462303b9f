// A sequence of cameras allocates nothing once buffers have grown: neither by operator new nor through GMP.
#include <gmp.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "beam/trace.hpp"
#include "bsp/tree.hpp"
#include "models/model.hpp"

namespace {

std::size_t by_new = 0, by_gmp = 0;

void* checked(void* p) {
  if (!p) throw std::bad_alloc();
  return p;
}
void* gmp_allocate(std::size_t size) {
  ++by_gmp;
  return checked(std::malloc(size));
}
void* gmp_reallocate(void* p, std::size_t, std::size_t size) {
  ++by_gmp;
  return checked(std::realloc(p, size));
}
void gmp_free(void* p, std::size_t) { std::free(p); }

}  // namespace

// Not inlined: GCC would warn of memory that is allocated by one and freed by the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++by_new;
  return checked(std::malloc(size != 0 ? size : 1));
}
// As the library's own does; under a sanitizer its own would be another allocator than that of the others.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return operator new(size); }
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace sightline {
namespace {

struct Sequence {
  const char* model;
  std::uint32_t polygons;
  std::size_t cameras;
  /// Some eyes lie all but in a plane of free space, or see lines all but parallel: rare, and told by long integers.
  bool long_integers;
};

class Allocation : public testing::TestWithParam<Sequence> {};

TEST_P(Allocation, NoneOnceBuffersHaveGrown) {
  const auto [name, polygons, cameras, long_integers] = GetParam();
  const Model model = make_model(name, {.polygons = polygons});
  std::vector<Camera> sequence;
  for (std::size_t k = 0; k < cameras; ++k) {
    const CameraLine& c = model.cameras[k * model.cameras.size() / cameras];
    sequence.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
  }
  const Scene scene = make_scene(model.soup);
  const BspTree tree(scene);
  Tracer tracer(tree);
  VisibilityMap map;
  mp_set_memory_functions(gmp_allocate, gmp_reallocate, gmp_free);
  by_new = by_gmp = 0;
  for (const Camera& camera : sequence) tracer.trace(camera, map);
  EXPECT_GT(by_new, 0u) << "nothing is counted";
  EXPECT_GT(by_gmp, 0u) << "nothing is counted";
  by_new = by_gmp = 0;
  for (const Camera& camera : sequence) tracer.trace(camera, map);
  EXPECT_EQ(by_new, 0u);
  if (!long_integers) {
    EXPECT_EQ(by_gmp, 0u);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Allocation,
                         testing::Values(Sequence{"maze", 0, 20, true}, Sequence{"building", 2'000, 50, true},
                                         Sequence{"city", 0, 20, true}, Sequence{"random", 50, 4, false}),
                         [](const auto& param) { return std::string(param.param.model); });

}  // namespace
}  // namespace sightline
