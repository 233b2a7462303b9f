// A scene that hides nothing: what the stitcher is given when tracing is left out.
#pragma once

#include "exact/window.hpp"
#include "scene/camera.hpp"
#include "visibility_map/fragment.hpp"

namespace sightline::bench {

/// side x side squares, two triangles each, that cover the whole window of a camera before them; bumpy: in planes of
/// their own, else in one plane.
Scene make_quilt(std::uint32_t side, bool bumpy);
Camera quilt_camera();

/// Each triangle's part of the window as a fragment. Resets the table to the camera's eye.
void fragments_of(const Scene& quilt, const Camera& camera, SightlineTable& table, Fragments& out);

}  // namespace sightline::bench
