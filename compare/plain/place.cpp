// Where a vertex is seen, in doubles: takes the place of visibility_map/stitch_place.cpp and stitch_compare.cpp in the
// program that measures what exact stages cost.
#include "visibility_map/stitch_state.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline::stitching {
namespace {

/// det(x, right, up) : det(x, up, forward) : det(x, forward, right) are as 1 : s - 1/2 : t - 1/2.
glm::dvec2 place(const State& s, CornerId c) {
  const glm::dvec3& x = s.corners[c].approx;
  const double depth = glm::dot(x, glm::cross(s.frame[1], s.frame[2]));
  return {0.5 + glm::dot(x, glm::cross(s.frame[2], s.frame[0])) / depth,
          0.5 + glm::dot(x, glm::cross(s.frame[0], s.frame[1])) / depth};
}

}  // namespace

void set_frame(State& s) {
  s.frame[0] = s.camera->forward;
  s.frame[1] = s.camera->right;
  s.frame[2] = s.camera->up;
}

/// Vertices on the window's sides are there by name.
void place_vertices(State& s) {
  for (VertexDraft& vertex : s.vertices) {
    const Corner& corner = s.corners[vertex.corner];
    const auto on = [&](Window::Side side) {
      return s.camera != nullptr && (corner.low == s.border[side].id || corner.high == s.border[side].id);
    };
    vertex.st = s.camera ? place(s, vertex.corner) : glm::dvec2(0);
    if (on(Window::left)) vertex.st.x = 0;
    if (on(Window::right)) vertex.st.x = 1;
    if (on(Window::bottom)) vertex.st.y = 0;
    if (on(Window::top)) vertex.st.y = 1;
    vertex.direction = glm::normalize(s.corners[vertex.corner].approx);
  }
}

Sign compare_places(State& s, CornerId a, CornerId b) {
  const glm::dvec3 &x = s.corners[a].approx, &y = s.corners[b].approx;
  const glm::dvec2 p = s.camera ? place(s, a) : glm::dvec2(x), q = s.camera ? place(s, b) : glm::dvec2(y);
  return p.x != q.x ? (p.x < q.x ? -1 : 1) : p.y != q.y ? (p.y < q.y ? -1 : 1) : 0;
}

}  // namespace sightline::stitching
