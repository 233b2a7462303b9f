#include "bench/field/subjects.hpp"

#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sightline::bench {
namespace {

const double pi = std::acos(-1.0);

/// Balls bent into shape: `columns` around, `rows` + 1 from pole to pole, 2 columns rows triangles.
class Modeller {
 public:
  explicit Modeller(const std::string& name) { soup_.source = name; }

  void object(const std::string& name, const glm::dvec3& at, double turn) {
    soup_.objects.push_back(name);
    at_ = at;
    cosine_ = std::cos(turn);
    sine_ = std::sin(turn);
  }

  /// `shape` takes a direction to a point of the object's own coordinates.
  void ball(int columns, int rows, const std::function<glm::dvec3(const glm::dvec3&)>& shape) {
    const auto base = static_cast<std::uint32_t>(soup_.vertices.size());
    const auto put = [&](double polar, double around) {
      const glm::dvec3 p =
          shape({std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), std::cos(polar)});
      soup_.vertices.push_back(at_ + glm::dvec3(cosine_ * p.x - sine_ * p.y, sine_ * p.x + cosine_ * p.y, p.z));
    };
    put(pi, 0);
    for (int r = 1; r <= rows; ++r) {
      for (int c = 0; c < columns; ++c) put(pi * (1 - r / (rows + 1.0)), 2 * pi * c / columns);
    }
    put(0, 0);
    const auto at = [&](int r, int c) {
      return base + 1 + static_cast<std::uint32_t>((r - 1) * columns + c % columns);
    };
    for (int c = 0; c < columns; ++c) {
      triangle(base, at(1, c + 1), at(1, c));
      for (int r = 1; r < rows; ++r) {
        triangle(at(r, c), at(r, c + 1), at(r + 1, c + 1));
        triangle(at(r, c), at(r + 1, c + 1), at(r + 1, c));
      }
      triangle(at(rows, c), at(rows, c + 1), base + 1 + static_cast<std::uint32_t>(rows * columns));
    }
  }

  void ellipsoid(int columns, int rows, const glm::dvec3& middle, const glm::dvec3& radii) {
    ball(columns, rows, [&](const glm::dvec3& d) { return middle + radii * d; });
  }

  PolygonSoup take() { return std::move(soup_); }

 private:
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.corners.insert(soup_.corners.end(), {a, b, c});
    soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.object_of.push_back(static_cast<std::uint32_t>(soup_.objects.size() - 1));
  }

  PolygonSoup soup_;
  glm::dvec3 at_{0};
  double cosine_ = 1, sine_ = 0;
};

/// A box with round edges for a direction: |x|^n + |y|^n + |z|^n = 1.
glm::dvec3 rounded_box(const glm::dvec3& d, double n) {
  return d / std::pow(std::pow(std::abs(d.x), n) + std::pow(std::abs(d.y), n) + std::pow(std::abs(d.z), n), 1 / n);
}

}  // namespace

Subject turtles() {
  Modeller m("turtles");
  for (int k = 0; k < 6; ++k) {
    m.object("turtle " + std::to_string(k), {6.5 * (k % 3) + 2.0 * (k / 3), 7.5 * (k / 3), 0}, 0.9 * k);
    m.ball(125, 131, [](const glm::dvec3& d) {  // the shell, with plates
      const double plates = 1 + 0.03 * std::cos(9 * std::atan2(d.y, d.x)) * (1 - d.z * d.z);
      return glm::dvec3(0, 0, 1.2) + plates * glm::dvec3(2.6, 2, d.z > 0 ? 1.7 : 0.4) * d;
    });
    m.ellipsoid(24, 20, {3.1, 0, 1.5}, {0.9, 0.6, 0.6});
    m.ellipsoid(24, 20, {-2.8, 0, 1}, {0.7, 0.2, 0.2});
    for (int leg = 0; leg < 4; ++leg) {
      m.ellipsoid(24, 20, {leg % 2 == 0 ? 1.6 : -1.6, leg < 2 ? 1.6 : -1.6, 0.6}, {0.6, 0.6, 0.8});
    }
  }
  return {"turtles", m.take(), 4680, {16, 16, 16, 16}};
}

Subject cars() {
  Modeller m("cars");
  for (int k = 0; k < 8; ++k) {
    m.object("car " + std::to_string(k), {5.5 * (k % 4) + 1.5 * (k / 4), 4.0 * (k / 4), 0}, 0.3 * (k % 3));
    m.ball(127, 22, [](const glm::dvec3& d) {
      const glm::dvec3 p = rounded_box(d, 5) * glm::dvec3(2.2, 0.9, 0.5) + glm::dvec3(0, 0, 0.9);
      const double cabin = std::max(0.0, 1 - std::pow(std::abs(p.x + 0.2) / 1.2, 4));
      return p + glm::dvec3(0, 0, p.z > 1 ? 0.6 * cabin : 0);
    });
    for (int wheel = 0; wheel < 4; ++wheel) {
      m.ellipsoid(20, 12, {wheel % 2 == 0 ? 1.4 : -1.4, wheel < 2 ? 0.9 : -0.9, 0.4}, {0.4, 0.15, 0.4});
    }
  }
  return {"cars", m.take(), 1364, {12, 12, 48, 48}};
}

Subject bunny(const std::string& file) {
  const std::array<std::uint32_t, 4> samples{8, 8, 32, 32};
  if (!file.empty()) return {"bunny", read_polygons(file), 235, samples};
  Modeller m("ball");
  m.object("ball", {0, 0, 0}, 0);
  m.ball(264, 132, [](const glm::dvec3& d) {
    return d *
           (1 + 0.12 * std::sin(5 * d.x + 2 * d.z) * std::cos(4 * d.y - d.x) + 0.03 * std::sin(17 * d.z + 11 * d.y));
  });
  return {"bunny", m.take(), 235, samples};
}

std::vector<CameraLine> animation(const PolygonSoup& soup, std::size_t frames) {
  glm::dvec3 low = soup.vertices.front(), high = low;
  for (const glm::dvec3& v : soup.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const glm::dvec3 middle = 0.5 * (low + high), size = high - low;
  // So far away that the whole of it is in the picture.
  const double height = 40,
               apart = 0.55 * std::max(size.x, 1.2 * size.z) / std::tan(height / 2 * pi / 180) + size.y / 2;
  std::vector<CameraLine> cameras;
  for (std::size_t k = 0; k < frames; ++k) {
    const double turn = frames == 1 ? 0 : 0.12 * (2.0 * static_cast<double>(k) / static_cast<double>(frames - 1) - 1);
    const glm::dvec3 from(std::sin(turn), -std::cos(turn), 0.2);
    cameras.push_back({middle + apart * from, -from, {0, 0, 1}, height, 1});
  }
  return cameras;
}

FieldSlab slab_for(const FieldBox& box, std::span<const Camera> cameras) {
  glm::dvec3 low(INFINITY), high(-INFINITY);  // of directions that go 1 along y
  for (const Camera& c : cameras) {
    for (int corner = 0; corner < 4; ++corner) {
      const glm::dvec3 d = c.forward + (corner % 2 - 0.5) * c.right + (corner / 2 - 0.5) * c.up;
      low = glm::min(low, d / d.y);
      high = glm::max(high, d / d.y);
    }
  }
  const glm::dvec3 size = box.high - box.low;
  const double depth = 1.02 * size.y;
  const glm::dvec3 aside = 0.51 * depth * glm::max(glm::abs(low), glm::abs(high));
  FieldSlab slab;
  slab.uv = {{low.x, 1, low.z}, {high.x - low.x, 0, 0}, {0, 0, high.z - low.z}};
  slab.st.corner = {box.low.x - aside.x, 0.5 * (box.low.y + box.high.y), box.low.z - aside.z};
  slab.st.across = {size.x + 2 * aside.x, 0, 0};
  slab.st.upwards = {0, 0, size.z + 2 * aside.z};
  slab.begin = slab.end = -0.5 * depth;
  return slab;
}

}  // namespace sightline::bench
