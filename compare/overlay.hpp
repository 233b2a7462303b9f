// Areas in which two descriptions of the window differ. For this folder's own use.
#pragma once

#include "compare/answer.hpp"

#include <functional>

namespace sightline::comparison {

/// Called with a part of the window: the face of the drawing there, what the other one shows there, its area.
using Part = std::function<void(std::uint32_t face, PolygonId shown, double area)>;
/// Whether a face may show a polygon.
using Agrees = std::function<bool(std::uint32_t face, PolygonId shown)>;

/// Parts in which `pixels` disagree with the drawing: per face and row of pixels, the area of the face in each of the
/// row's pixels, from the trapezoids between its boundary and the row.
void differences(const Drawing& drawing, const Pixels& pixels, const Agrees& agrees, const Part& part);
/// Parts in which another drawing disagrees: both are cut into stretches of t between which no edge begins, ends or
/// crosses another; in one they are sorted from left to right, and between two neighbours lies a trapezoid.
/// `other` may be no subdivision at all: what lies right of an edge is then what that edge says.
void differences(const Drawing& drawing, const Drawing& other, const Agrees& agrees, const Part& part);

}  // namespace sightline::comparison
