#include "sample/field_slab.hpp"

#include "scene/errors.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <sstream>
#include <string>

namespace sightline {
namespace {

constexpr double margin = 1.0 / 64;  // of the box's longest side, so that what lies on the border is within

double longest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

glm::dvec3 unit_vector(int axis, double length) {
  glm::dvec3 v(0);
  v[axis] = length;
  return v;
}

/// The lines with direction `sign` along `axis`, at most `slope` off it, that meet the box; st at `place` of its depth.
FieldSlab axis_slab(const FieldBox& box, int axis, double sign, double slope, double place) {
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  const glm::dvec3 size = box.high - box.low;
  const double spare = margin * longest(size), depth = size[axis] + 2 * spare;
  // What leaves the box at its farther end from st has gone so far aside.
  const double aside = slope * depth * std::max(place, 1 - place) + spare;
  FieldSlab slab;
  slab.uv = {unit_vector(axis, sign) - unit_vector(a, slope) - unit_vector(b, slope), unit_vector(a, 2 * slope),
             unit_vector(b, 2 * slope)};
  const double from_start = place * depth;  // the ray runs through the box from here on
  const double start = sign > 0 ? box.low[axis] - spare : box.high[axis] + spare;
  glm::dvec3 corner = box.low - glm::dvec3(aside);
  corner[axis] = start + sign * from_start;
  slab.st = {corner, unit_vector(a, size[a] + 2 * aside), unit_vector(b, size[b] + 2 * aside)};
  slab.begin = slab.end = -from_start;
  return slab;
}

struct SlabReader {
  std::string where;
  const FieldBox& box;

  [[noreturn]] void fail(const std::string& what) const { throw InputError(where + what); }

  FieldPlane plane(std::istringstream& words) const {
    FieldPlane p;
    for (glm::dvec3* v : {&p.corner, &p.across, &p.upwards}) {
      for (int k = 0; k < 3; ++k) {
        std::string word;
        if (!(words >> word)) fail("a slab has 18 numbers: corner, across and upwards of uv and of st");
        std::size_t read = 0;
        try {
          (*v)[k] = std::stod(word, &read);
        } catch (const std::exception&) {
          read = 0;
        }
        if (read != word.size() || !std::isfinite((*v)[k])) fail("'" + word + "' is no number");
      }
    }
    return p;
  }

  FieldSlab slab(const std::string& line) const {
    std::istringstream words(line);
    std::string kind, more;
    words >> kind;
    if (kind != "plane" && kind != "infinity") fail("'" + kind + "': a slab begins with `plane` or `infinity`");
    FieldSlab out;
    out.infinite = kind == "infinity";
    out.uv = plane(words);
    out.st = plane(words);
    if (words >> more) fail("'" + more + "' stands after the slab's 18 numbers");
    const glm::dvec3 uv = glm::cross(out.uv.across, out.uv.upwards), st = glm::cross(out.st.across, out.st.upwards);
    if (glm::length(uv) == 0 || glm::length(st) == 0) fail("a plane has no area");
    const auto slant = [](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::length(glm::cross(a, b)) / (glm::length(a) * glm::length(b));
    };
    if (out.infinite) {
      directions(out, st);
    } else {
      if (slant(uv, st) > 1e-9) fail("the planes uv and st are not parallel");
      const double apart = glm::dot(out.st.corner - out.uv.corner, st) / glm::length(st);
      if (std::abs(apart) <= 1e-9 * longest(box.high - box.low)) fail("the planes uv and st are one");
      out.begin = out.end = -1;
    }
    return out;
  }

  /// Rays of directions begin before the box, however far from it st lies.
  void directions(FieldSlab& slab, const glm::dvec3& normal) const {
    const FieldPlane &uv = slab.uv, &st = slab.st;
    const glm::dvec3 sum = uv.across + uv.upwards;
    const double side = glm::dot(uv.corner + 0.5 * sum, normal);
    double shortest = INFINITY;
    for (const glm::dvec3& d : {uv.corner, uv.corner + uv.across, uv.corner + uv.upwards, uv.corner + sum}) {
      if (!(side * glm::dot(d, normal) > 0)) fail("a direction of uv runs along the plane st");
      shortest = std::min(shortest, std::abs(glm::dot(d, normal)) / glm::length(normal));
    }
    const glm::dvec3 middle = 0.5 * (box.low + box.high);
    const double reach = glm::length(box.high - box.low) + glm::length(st.corner - middle) + glm::length(st.across) +
                         glm::length(st.upwards);
    if (glm::dot(uv.corner, glm::cross(uv.across, uv.upwards)) == 0) fail("the directions of uv lie in one plane");
    slab.begin = slab.end = -reach / shortest;
  }
};

}  // namespace

std::vector<FieldSlab> slabs_around(const FieldBox& box, double distance) {
  std::vector<FieldSlab> slabs;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      FieldSlab slab = axis_slab(box, axis, sign, 1, 0.5);
      if (distance > 0) {
        // From uv to st the ray goes `far` along the axis; uv reaches so much farther aside that slopes of 1 are in it.
        const double far = distance * longest(box.high - box.low) + std::abs(slab.begin);
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        slab.infinite = false;
        slab.uv.corner = slab.st.corner - unit_vector(axis, sign * far) - unit_vector(a, far) - unit_vector(b, far);
        slab.uv.across = slab.st.across + unit_vector(a, 2 * far);
        slab.uv.upwards = slab.st.upwards + unit_vector(b, 2 * far);
        slab.begin = slab.end = -1;
      }
      slabs.push_back(slab);
    }
  }
  return slabs;
}

std::vector<FieldSlab> slabs_within(const FieldBox& view) {
  std::vector<FieldSlab> slabs = slabs_around(view);
  for (FieldSlab& slab : slabs) slab.end = -slab.begin;
  return slabs;
}

FieldSlab slab_before(const FieldBox& box, int axis, bool upper, double slope) {
  return axis_slab(box, axis, upper ? -1.0 : 1.0, slope, 0);
}

std::vector<FieldSlab> read_slabs(const std::filesystem::path& file, const FieldBox& box) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string() + ": cannot be read");
  std::vector<FieldSlab> slabs;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    slabs.push_back(SlabReader{file.string() + ":" + std::to_string(number) + ": ", box}.slab(line));
  }
  if (slabs.empty()) throw InputError(file.string() + ": holds no slab");
  return slabs;
}

FieldRay ray_of(const FieldSlab& slab, const std::array<double, 4>& uvst) {
  const auto at = [](const FieldPlane& p, double a, double b) { return p.corner + a * p.across + b * p.upwards; };
  const glm::dvec3 uv = at(slab.uv, uvst[0], uvst[1]), st = at(slab.st, uvst[2], uvst[3]);
  const glm::dvec3 direction = slab.infinite ? uv : st - uv;
  return {st + slab.begin * direction, direction};
}

SlabView::SlabView(const FieldSlab& slab, const Camera& camera) {
  const glm::dvec3 first = camera.forward - 0.5 * (camera.right + camera.up);
  const auto linear = [&](const glm::dvec3& row) {
    return Linear{glm::dot(row, first), glm::dot(row, camera.right), glm::dot(row, camera.up)};
  };
  // A ray eye + k d meets corner + a across + b upwards where, with the plane's normal n and the vector x for which
  // x.across = 1, x.upwards = 0, x.n = 0:  a = [(x.(eye - corner)) (n.d) + (n.(corner - eye)) (x.d)] / (n.d).
  const auto crossing = [&](const FieldPlane& p, const glm::dvec3& normal, Linear& a, Linear& b) {
    const glm::dmat3 dual = glm::transpose(glm::inverse(glm::dmat3(p.across, p.upwards, normal)));
    const glm::dvec3 offset = camera.eye - p.corner;
    const double height = glm::dot(normal, offset);
    a = linear(glm::dot(dual[0], offset) * normal - height * dual[0]);
    b = linear(glm::dot(dual[1], offset) * normal - height * dual[1]);
    return linear(normal);
  };
  const auto facing = [](const FieldPlane& p, const glm::dvec3& along) {  // the normal on the side that rays go to
    const glm::dvec3 n = glm::normalize(glm::cross(p.across, p.upwards));
    return glm::dot(n, along) < 0 ? -n : n;
  };
  const glm::dvec3 along = slab.infinite ? slab.uv.corner : slab.st.corner - slab.uv.corner;
  const glm::dvec3 normal = facing(slab.st, along);
  st_ = crossing(slab.st, normal, numerators_[2], numerators_[3]);
  if (slab.infinite) {  // d = k (corner + u across + v upwards)
    const glm::dmat3 rows = glm::transpose(glm::inverse(glm::dmat3(slab.uv.corner, slab.uv.across, slab.uv.upwards)));
    uv_ = linear(rows[0]);
    numerators_[0] = linear(rows[1]);
    numerators_[1] = linear(rows[2]);
  } else {
    uv_ = crossing(slab.uv, normal, numerators_[0], numerators_[1]);
  }
}

}  // namespace sightline
