#include "bench/bitfield/bodies.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <numbers>
#include <stdexcept>

namespace sightline {
namespace {

constexpr double pi = std::numbers::pi;

class Builder {
 public:
  std::uint32_t vertex(const glm::dvec3& p) {
    const auto round = [](double x) { return std::nearbyint(x * 4096) / 4096; };
    soup_.vertices.emplace_back(round(p.x), round(p.y), round(p.z));
    return static_cast<std::uint32_t>(soup_.vertices.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    soup_.corners.insert(soup_.corners.end(), {a, b, c});
    soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
  }
  /// Two triangles for every mesh of a net whose rows are closed; place(row, column) gives its corners.
  void net(unsigned rows, unsigned columns, const std::function<std::uint32_t(unsigned, unsigned)>& corner) {
    for (unsigned r = 0; r < rows; ++r) {
      for (unsigned c = 0; c < columns; ++c) {
        const unsigned next = (c + 1) % columns;
        triangle(corner(r, c), corner(r + 1, c), corner(r + 1, next));
        triangle(corner(r, c), corner(r + 1, next), corner(r, next));
      }
    }
  }
  PolygonSoup take(const std::string& name) {
    soup_.source = name + ".obj";
    return std::move(soup_);
  }

 private:
  PolygonSoup soup_;
};

/// A ball whose radius depends on the direction.
PolygonSoup ball(const std::string& name, unsigned rings, const std::function<double(const glm::dvec3&)>& radius) {
  Builder builder;
  const unsigned around = 2 * rings;
  const auto add = [&](double polar, double turn) {
    const glm::dvec3 d(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar));
    return builder.vertex(radius(d) * d);
  };
  const std::uint32_t top = add(0, 0);
  for (unsigned k = 1; k < rings; ++k) {
    for (unsigned j = 0; j < around; ++j) add(pi * k / rings, 2 * pi * j / around);
  }
  const std::uint32_t end = add(pi, 0);
  const auto at = [&](unsigned ring, unsigned j) { return top + 1 + ring * around + j % around; };
  for (unsigned j = 0; j < around; ++j) {
    builder.triangle(top, at(0, j), at(0, j + 1));
    builder.triangle(at(rings - 2, j), end, at(rings - 2, j + 1));
  }
  builder.net(rings - 2, around, at);
  return builder.take(name);
}

double bunny_radius(const glm::dvec3& d) {
  double r =
      1 + 0.06 * std::sin(5 * d.x + 2 * d.y) + 0.05 * std::sin(6 * d.z - 3 * d.x) + 0.02 * std::sin(17 * d.y + 9 * d.z);
  for (const double side : {-1.0, 1.0}) {
    const double apart = glm::distance(d, glm::normalize(glm::dvec3(0.2, 0.42 * side, 1)));
    r += 0.9 * std::exp(-apart * apart / 0.025);
  }
  return r;
}

/// Folds along the lines on which a sum of waves that bend one another is zero.
double brain_radius(const glm::dvec3& d) {
  const glm::dvec3 bent = d + 0.22 * glm::dvec3(std::sin(7 * d.y + 1), std::sin(6 * d.z + 2), std::sin(8 * d.x + 3));
  const double wave = std::sin(13 * bent.x) + std::sin(12 * bent.y + 1) + std::sin(11 * bent.z + 2);
  const double fold = std::exp(-wave * wave / 1.1);
  return 1 - 0.7 * fold;
}

void add_wheel(Builder& builder, const glm::dvec3& middle, double size, unsigned teeth, double turned) {
  constexpr unsigned steps = 240, layers = 8, bore_layers = 3, rings = 3;
  constexpr double thickness = 0.25, bore = 0.25;
  const auto rim = [&](unsigned c) {
    const double phase = std::sin(2 * pi * teeth * c / steps);
    return size * (1 + 0.1 * std::clamp(3 * phase, -1.0, 1.0));
  };
  const auto place = [&](double r, unsigned c, double z) {
    const double turn = 2 * pi * c / steps + turned;
    return middle + glm::dvec3(r * std::cos(turn), r * std::sin(turn), z);
  };
  // One closed net: out along the lower side, up along the rim, in along the upper side, down through the bore.
  std::vector<std::vector<std::uint32_t>> rows;
  const auto row = [&](double part, double z) {  // part: from the bore, 0, to the rim, 1
    rows.emplace_back();
    for (unsigned c = 0; c < steps; ++c) {
      rows.back().push_back(builder.vertex(place(bore + part * (rim(c) - bore), c, z)));
    }
  };
  for (unsigned k = 0; k < rings; ++k) row(1.0 * k / rings, -thickness);
  for (unsigned k = 0; k < layers; ++k) row(1, thickness * (2.0 * k / layers - 1));
  for (unsigned k = 0; k < rings; ++k) row(1 - 1.0 * k / rings, thickness);
  for (unsigned k = 0; k < bore_layers; ++k) row(0, thickness * (1 - 2.0 * k / bore_layers));
  rows.push_back(rows.front());
  builder.net(static_cast<unsigned>(rows.size()) - 1, steps, [&](unsigned r, unsigned c) { return rows[r][c]; });
}

PolygonSoup gears() {
  Builder builder;
  for (unsigned shaft = 0; shaft < 3; ++shaft) {
    for (unsigned k = 0; k < 3; ++k) {
      const double turn = 2 * pi * shaft / 3;
      const glm::dvec3 middle(0.9 * std::cos(turn), 0.9 * std::sin(turn), 0.8 * k + 0.25 * shaft - 1);
      add_wheel(builder, middle, 0.9 + 0.1 * ((shaft + k) % 3), 20 + 4 * k, 0.1 * shaft);
    }
  }
  return builder.take("gears");
}

}  // namespace

const std::vector<std::string>& body_names() {
  static const std::vector<std::string> names{"bunny", "gears", "brain"};
  return names;
}

PolygonSoup make_body(const std::string& name) {
  if (name == "bunny") return ball(name, 128, bunny_radius);
  if (name == "gears") return gears();
  if (name == "brain") return ball(name, 264, brain_radius);
  throw std::invalid_argument("no body is called " + name + " (bunny, gears, brain)");
}

}  // namespace sightline
