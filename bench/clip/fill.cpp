// What it costs to fill a camera's buffer: by CoverBuffer, and the rays alone that Embree would need for the same: one
// through each corner of each pixel, since a pixel is covered by a convex polygon where all its corners are.
#include <embree3/rtcore.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/cpu_seconds.hpp"
#include "clip/cover_buffer.hpp"
#include "clip/shadows.hpp"
#include "models/model.hpp"
#include "scene/read.hpp"

namespace {

using namespace sightline;

/// Triangles of all surfaces, in unit coordinates.
RTCScene embree_scene(RTCDevice device, const Scene& scene) {
  std::vector<float> places;
  std::vector<unsigned> corners;
  for (PointId p = 0; p < scene.points().size(); ++p) {
    for (int k = 0; k < 3; ++k) places.push_back(static_cast<float>(scene.points().approx(p)[k]));
  }
  for (const Surface& s : scene.surfaces()) {
    const auto edges = scene.edges(s);
    for (std::size_t k = 2; k < edges.size(); ++k) {
      if (edges[0].corner == none || edges[k - 1].corner == none || edges[k].corner == none) continue;
      for (const std::size_t c : {std::size_t{0}, k - 1, k}) corners.push_back(edges[c].corner);
    }
  }
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* to = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                         3 * sizeof(float), places.size() / 3));
  std::copy(places.begin(), places.end(), to);
  auto* index = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                               3 * sizeof(unsigned), corners.size() / 3));
  std::copy(corners.begin(), corners.end(), index);
  rtcCommitGeometry(geometry);
  RTCScene made = rtcNewScene(device);
  rtcAttachGeometry(made, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(made);
  return made;
}

/// Rays through the corners of the pixels, eight at a time; the number that hit something.
std::size_t shoot(RTCScene scene, const glm::dvec3& eye, const Camera& camera, int size) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) RTCRayHit8 packet;
  alignas(32) int valid[8];
  std::size_t hits = 0;
  for (int y = 0; y <= size; ++y) {
    for (int x = 0; x <= size; x += 8) {
      for (int k = 0; k < 8; ++k) {
        const double s = static_cast<double>(x + k) / size - 0.5, t = static_cast<double>(y) / size - 0.5;
        const glm::dvec3 ray = camera.forward + s * camera.right + t * camera.up;
        valid[k] = x + k <= size ? -1 : 0;
        packet.ray.org_x[k] = static_cast<float>(eye.x);
        packet.ray.org_y[k] = static_cast<float>(eye.y);
        packet.ray.org_z[k] = static_cast<float>(eye.z);
        packet.ray.dir_x[k] = static_cast<float>(ray.x);
        packet.ray.dir_y[k] = static_cast<float>(ray.y);
        packet.ray.dir_z[k] = static_cast<float>(ray.z);
        packet.ray.tnear[k] = packet.ray.time[k] = 0;
        packet.ray.tfar[k] = 1e30f;
        packet.ray.mask[k] = ~0u;
        packet.ray.flags[k] = 0;
        packet.hit.geomID[k] = packet.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
      }
      rtcIntersect8(valid, scene, &context, &packet);
      for (int k = 0; k < 8; ++k) hits += valid[k] != 0 && packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
    }
  }
  return hits;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Filling a buffer"};
  std::vector<std::string> names{"maze", "city", "tower", "building", "random"};
  std::vector<int> sizes{64, 128, 256, 512};
  std::size_t cameras = 8;
  std::uint32_t polygons = 0;
  bool no_rays = false, no_buffer = false;
  app.add_option("scenes", names, "models, or polygon files with a .cameras file beside them");
  app.add_option("--sizes", sizes);
  app.add_option("--cameras", cameras, "at most so many");
  app.add_option("--polygons", polygons, "of models that have a choice");
  app.add_flag("--no-rays", no_rays);
  app.add_flag("--no-buffer", no_buffer);
  CLI11_PARSE(app, argc, argv);
  RTCDevice device = rtcNewDevice("threads=1,set_affinity=0");
  std::printf(
      "scene | polygons | in the window | Embree's tree, ms | pixels a side | buffer, ms a camera | rays, ms a camera "
      "| hits\n");
  for (const std::string& name : names) {
    PolygonSoup soup;
    std::vector<Camera> all;
    if (name.find('.') != std::string::npos) {
      soup = read_polygons(name);
      all = read_cameras(std::filesystem::path(name).replace_extension(".cameras"));
    } else {
      ModelOptions options;
      options.polygons = polygons;
      const Model model = make_model(name, options);
      soup = model.soup;
      for (const CameraLine& c : model.cameras)
        all.push_back(make_camera(c.eye, c.forward, c.up, c.vertical_fov_degrees, c.aspect));
    }
    const Scene scene = make_scene(soup);
    const BoxTree boxes(scene);
    std::vector<SurfaceId> surfaces;
    const double start = cpu_seconds();
    RTCScene tree = no_rays ? nullptr : embree_scene(device, scene);
    const double build = cpu_seconds() - start;
    const std::size_t step = std::max<std::size_t>(1, all.size() / cameras);
    for (const int size : sizes) {
      double buffer = 0, rays = 0;
      std::size_t hits = 0, count = 0, found = 0;
      for (std::size_t k = 0; k < all.size(); k += step, ++count) {
        const double before = cpu_seconds();
        if (!no_buffer) {
          find_in_frame(ClipView(scene, all[k], 0, {}), boxes, surfaces);
          CoverBuffer(scene, all[k], surfaces, size);
        }
        const double middle = cpu_seconds();
        if (tree) hits += shoot(tree, scene.grid().unit(all[k].eye), all[k], size);
        buffer += middle - before;
        found += surfaces.size();
        rays += cpu_seconds() - middle;
      }
      const double each = 1e3 / static_cast<double>(count);
      std::printf("%s | %u | %zu | %.2f | %d | %.3f | %.3f | %zu\n", name.c_str(), scene.polygon_count(), found / count,
                  1e3 * build, size, buffer * each, rays * each, hits / count);
      std::fflush(stdout);
    }
    if (tree) rtcReleaseScene(tree);
  }
  rtcReleaseDevice(device);
}
