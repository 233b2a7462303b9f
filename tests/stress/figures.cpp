#include "tests/stress/figures.hpp"

#include <cmath>
#include <limits>

#include "tests/stress/judge.hpp"

namespace sightline::stress {
namespace {

/// A plane with a lattice in it: along axes, slanting by whole numbers, or any.
struct Lattice {
  glm::dvec3 origin, u, v;
  glm::dvec3 at(double i, double j) const { return origin + i * u + j * v; }
};

glm::dvec3 anywhere(Random& random, double range) {
  const double x = random.unit(), y = random.unit(), z = random.unit();
  return range * (2.0 * glm::dvec3(x, y, z) - 1.0);
}
glm::dvec3 whole(Random& random, int range) {
  const int x = random.between(-range, range), y = random.between(-range, range), z = random.between(-range, range);
  return {x, y, z};
}

Lattice lattice(Random& random) {
  switch (random.below(3)) {
    case 0: {
      Lattice out{glm::dvec3(whole(random, 4)) * 0.3, {0, 0, 0}, {0, 0, 0}};
      const int axis = random.below(3);
      out.u[axis] = 1;
      out.v[(axis + 1) % 3] = 1;
      return out;
    }
    case 1:
      return {whole(random, 4), {random.between(1, 3), random.between(-2, 2), 1}, {random.between(-1, 0), 1, 2}};
    default: {
      const Turn turn = some_turn(random);
      return {anywhere(random, 2), turn.row[0], turn.row[1]};
    }
  }
}

void nudge(glm::dvec3& place, Random& random) {
  double& x = place[random.below(3)];
  x = stepped(x, random.once_in(2) ? 1 : -1);
}

}  // namespace

std::uint32_t Figure::vertex(const glm::dvec3& place) {
  soup.vertices.push_back(place);
  return static_cast<std::uint32_t>(soup.vertices.size() - 1);
}
void Figure::join(const std::vector<std::uint32_t>& corners) {
  soup.corners.insert(soup.corners.end(), corners.begin(), corners.end());
  soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
}
void Figure::add(const std::vector<glm::dvec3>& places) {
  std::vector<std::uint32_t> corners;
  for (const glm::dvec3& p : places) corners.push_back(vertex(p));
  join(corners);
}
void Figure::add_parallelogram(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v) {
  add({corner, corner + u, corner + u + v, corner + v});
}
void Figure::add_box(const glm::dvec3& low, const glm::dvec3& high) {
  const auto first = static_cast<std::uint32_t>(soup.vertices.size());
  for (std::uint32_t k = 0; k < 8; ++k)
    vertex({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  constexpr std::array<std::array<std::uint32_t, 4>, 6> sides{
      {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
  for (const auto& s : sides) join({first + s[0], first + s[1], first + s[2], first + s[3]});
}

double stepped(double x, int units) {
  const double end = units < 0 ? -std::numeric_limits<double>::max() : std::numeric_limits<double>::max();
  for (int k = 0; k < std::abs(units); ++k) x = std::nextafter(x, end);
  return x;
}

glm::dvec3 Turn::operator()(const glm::dvec3& v) const {
  return {glm::dot(row[0], v), glm::dot(row[1], v), glm::dot(row[2], v)};
}

Turn some_turn(Random& random) {
  for (;;) {
    const glm::dvec3 a = anywhere(random, 1), b = anywhere(random, 1);
    if (glm::length(glm::cross(a, b)) < 0.1) continue;
    const glm::dvec3 x = glm::normalize(a), z = glm::normalize(glm::cross(a, b));
    return {{x, glm::cross(z, x), z}};
  }
}

PolygonSoup all_but_coplanar(Random& random) {
  const Lattice plane = lattice(random);
  Figure figure;
  for (int count = random.between(3, 7); count > 0; --count) {
    const int i = random.between(-2, 1), j = random.between(-2, 1), w = random.between(1, 3), h = random.between(1, 3);
    std::vector<glm::dvec3> corners{plane.at(i, j), plane.at(i + w, j), plane.at(i + w, j + h)};
    if (random.once_in(2)) corners.push_back(plane.at(i, j + h));
    for (glm::dvec3& p : corners) {
      if (random.once_in(3)) nudge(p, random);
    }
    figure.add(corners);
  }
  return figure.soup;
}

PolygonSoup slivers(Random& random) {
  constexpr double thin = 1e-12;
  Figure figure;
  const Lattice plane = lattice(random);
  for (int count = random.between(2, 5); count > 0; --count) {
    const Lattice own = random.once_in(3) ? lattice(random) : plane;
    const int i = random.between(-1, 1), j = random.between(-1, 1);
    const double at = random.between(0, 4) / 4.0;
    figure.add({own.at(i, j), own.at(i + 1, j), own.at(i + at, j + (random.once_in(2) ? thin : -thin))});
  }
  const glm::dvec3 off = anywhere(random, 0.5);
  figure.add_parallelogram(plane.at(-2, -2) + off, 4.0 * plane.u, 4.0 * plane.v);
  return figure.soup;
}

PolygonSoup needles(Random& random) {
  Figure figure;
  const int levels = random.between(1, 3);
  const bool slanting = random.once_in(2);
  for (int k = 0; k < levels; ++k) {
    figure.add_parallelogram({-2, -2, k}, {4, 0, slanting ? 1 : 0}, {0, 4, slanting && random.once_in(2) ? 1.5 : 0});
  }
  for (int count = random.between(1, 4); count > 0; --count) {
    const glm::dvec3 from{random.between(-4, 4) / 4.0, random.between(-4, 4) / 4.0, -1};
    glm::dvec3 to{random.between(-4, 4) / 4.0, random.between(-4, 4) / 4.0, levels + 0.5};
    if (random.once_in(4)) to = {from.x, from.y, 1000};
    const glm::dvec3 wide = random.once_in(2) ? glm::dvec3(1e-12, 0, 0) : 1e-12 * anywhere(random, 1);
    figure.add(random.once_in(2) ? std::vector{from, from + wide, to} : std::vector{from, to, to + wide});
  }
  return figure.soup;
}

PolygonSoup cycle(Random& random) {
  Figure figure;
  const int count = random.between(3, 6);
  const bool whole_numbers = random.once_in(2);
  std::vector<glm::dvec3> corners;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * 3.141592653589793 * k / count;
    glm::dvec3 p{8 * std::cos(angle), 8 * std::sin(angle), 0};
    if (whole_numbers) p = {std::round(p.x), std::round(p.y), 0};
    corners.push_back(p);
  }
  const double rise = random.once_in(3) ? 0 : random.once_in(2) ? 1 : 0x1p-40;
  for (int k = 0; k < count; ++k) {
    const glm::dvec3 a = corners[static_cast<std::size_t>(k)], b = corners[static_cast<std::size_t>((k + 1) % count)];
    const glm::dvec3 along = b - a, across{-along.y * 0.125, along.x * 0.125, 0};
    glm::dvec3 low = a - 0.25 * along, high = b + 0.25 * along;
    low.z = random.once_in(8) ? stepped(low.z, 1) : low.z;
    high.z = rise;
    if (random.once_in(8)) high.z = stepped(high.z, random.once_in(2) ? 1 : -1);
    figure.add({low, high, high + across, low + across});
  }
  return figure.soup;
}

PolygonSoup cracked_wall(Random& random) {
  Figure figure;
  const Lattice plane = lattice(random);
  const double lean = random.once_in(2) ? 0 : 0.3;  // else the middle points are rounded
  const int rows = random.between(2, 4);
  figure.add({plane.at(-1, 0), plane.at(0, 0), plane.at(lean, 4), plane.at(-1, 4)});
  const auto middle = [&](int k) {
    glm::dvec3 p = plane.at(lean * k / rows, 4.0 * k / rows);
    const int axis = random.below(3);
    p[axis] = stepped(p[axis], random.between(-2, 2));
    return p;
  };
  std::uint32_t below = figure.vertex(middle(0)), below_right = figure.vertex(plane.at(2, 0));
  for (int k = 1; k <= rows; ++k) {
    const std::uint32_t above = figure.vertex(middle(k)), above_right = figure.vertex(plane.at(2, 4.0 * k / rows));
    // In part the piece above has a point of its own.
    figure.join({below, below_right, above_right, above});
    below = random.once_in(3) ? figure.vertex(middle(k)) : above;
    below_right = above_right;
  }
  const glm::dvec3 behind = glm::cross(plane.u, plane.v);
  figure.add_parallelogram(plane.at(-3, -3) + behind, 7.0 * plane.u, 10.0 * plane.v);
  return figure.soup;
}

PolygonSoup duplicates(Random& random) {
  Figure figure;
  const Lattice plane = lattice(random);
  for (int count = random.between(1, 3); count > 0; --count) {
    const Lattice own = random.once_in(2) ? lattice(random) : plane;
    const int i = random.between(-1, 1), j = random.between(-1, 1), w = random.between(1, 2), h = random.between(1, 2);
    std::vector<glm::dvec3> corners{own.at(i, j), own.at(i + w, j), own.at(i + w, j + h), own.at(i, j + h)};
    if (random.once_in(2)) corners.pop_back();
    const auto first = static_cast<std::uint32_t>(figure.soup.vertices.size());
    figure.add(corners);
    for (int copies = random.between(1, 4); copies > 0; --copies) {
      std::vector<std::uint32_t> own_corners;
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        own_corners.push_back(random.once_in(2) ? first + k : figure.vertex(corners[k]));
        if (random.once_in(6)) own_corners.push_back(own_corners.back());
        if (random.once_in(4))
          own_corners.push_back(figure.vertex((corners[k] + corners[(k + 1) % corners.size()]) * 0.5));
      }
      std::rotate(own_corners.begin(), own_corners.begin() + random.below(3), own_corners.end());
      if (random.once_in(2)) std::ranges::reverse(own_corners);
      figure.join(own_corners);
    }
  }
  return figure.soup;
}

PolygonSoup shell(Random& random) {
  Figure figure;
  const glm::dvec3 low{0.1, -1, 0.3}, high{1.7, random.once_in(2) ? 1 : 0.7, 2};
  figure.add_box(low, high);
  const std::uint32_t sides = 6;
  if (random.once_in(2)) {
    for (std::uint32_t k = 0; k < sides; ++k) {
      std::vector<std::uint32_t> corners(figure.soup.corners.begin() + figure.soup.first[k],
                                         figure.soup.corners.begin() + figure.soup.first[k + 1]);
      std::ranges::reverse(corners);
      figure.join(corners);
    }
  } else {
    const int units = random.once_in(2) ? 1 : -1;
    const auto beside = [&](const glm::dvec3& p, int direction) {
      return glm::dvec3{stepped(p.x, direction * units), stepped(p.y, direction * units),
                        stepped(p.z, direction * units)};
    };
    figure.add_box(beside(low, 1), beside(high, -1));
  }
  if (random.once_in(2)) figure.soup = placed(figure.soup, some_turn(random));
  return figure.soup;
}

PolygonSoup mixed_exponents(Random& random) {
  constexpr double sizes[] = {0, 1e-300, 1e-200, 1e-16, 0.1, 1, 7, 1e16, 1e200, 1e300};
  Figure figure;
  const int lowest = random.once_in(2) ? 0 : 4;
  const auto coordinate = [&] {
    const double size = sizes[static_cast<std::size_t>(random.between(lowest, 9))];
    return (random.once_in(2) ? 1 : -1) * (random.once_in(2) ? 1 : 0.5 + random.unit()) * size;
  };
  for (int count = random.between(2, 4); count > 0; --count) {
    std::vector<glm::dvec3> corners;
    const int flat = random.below(6);
    const double level = coordinate();
    for (int k = 0; k < 3; ++k) {
      glm::dvec3 p{coordinate(), coordinate(), coordinate()};
      if (flat < 3) p[flat] = level;
      corners.push_back(p);
    }
    figure.add(corners);
  }
  return figure.soup;
}

PolygonSoup coplanar_crowd(Random& random, int count, int range) {
  Figure figure;
  for (int k = 0; k < count; ++k) {
    const int w = random.between(1, 12), h = random.between(1, 12);
    const int x = random.below(range - w), y = random.below(range - h);
    figure.add_parallelogram({x, y, 0}, {w, 0, 0}, {0, h, 0});
  }
  return figure.soup;
}

PolygonSoup crowd_through_a_point(Random& random, int count, bool sharing) {
  Figure figure;
  for (int k = 0; k < count; ++k) {
    const glm::dvec3 u = whole(random, 100), v = whole(random, 100);
    if (sharing) {
      figure.add_parallelogram({0, 0, 0}, u, v);
    } else {
      figure.add({u, v, -u, -v});
    }
  }
  return figure.soup;
}

PolygonSoup crowd_through_a_line(Random& random, int count, bool sharing) {
  Figure figure;
  for (int k = 0; k < count; ++k) {
    const glm::dvec3 u{random.between(-1000, 1000), random.between(-1000, 1000), 0}, up{0, 0, random.between(1, 1000)};
    if (sharing) {
      figure.add_parallelogram({0, 0, 0}, u, up);
    } else {
      figure.add_parallelogram(-u, 2.0 * u, up);
    }
  }
  return figure.soup;
}

glm::dvec3 hard_eye(const PolygonSoup& soup, Random& random) {
  const auto p = static_cast<std::size_t>(random.below(static_cast<int>(soup.first.size()) - 1));
  const auto count = static_cast<int>(soup.first[p + 1] - soup.first[p]);
  const auto corner = [&](int k) {
    return soup.vertices[soup.corners[soup.first[p] + static_cast<unsigned>(k % count)]];
  };
  const int k = random.below(count);
  const glm::dvec3 a = corner(k), b = corner(k + 1), c = corner(k + 2);
  glm::dvec3 eye = a;
  switch (random.below(7)) {
    case 0:
      break;
    case 1:
      eye = a * 0.5 + b * 0.5;
      break;
    case 2:  // collinear with an edge
      eye = random.once_in(2) ? a + (a - b) : a + 2.5 * (a - b);
      break;
    case 3:  // in a plane, on the polygon or beside it
      eye = a + (random.between(-4, 8) / 4.0) * (b - a) + (random.between(-4, 8) / 4.0) * (c - a);
      break;
    case 4:  // in the line of two vertices, or between them
      eye =
          a * 0.5 + soup.vertices[static_cast<std::size_t>(random.below(static_cast<int>(soup.vertices.size())))] * 0.5;
      break;
    case 5:  // in two planes that are parallel to axes
      eye = {a.x, b.y, 2 * c.z - a.z};
      break;
    default:
      eye = a + 3.0 * (b - c) + glm::dvec3{c.y - a.y, 1, a.x - b.x};
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (random.once_in(4)) eye[axis] = stepped(eye[axis], random.once_in(2) ? 1 : -1);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(eye[axis])) eye[axis] = 1;
  }
  return eye;
}

Camera hard_camera(const PolygonSoup& soup, Random& random) {
  const auto vertex = [&] {
    return soup.vertices[static_cast<std::size_t>(random.below(static_cast<int>(soup.vertices.size())))];
  };
  const glm::dvec3 eye = hard_eye(soup, random), a = vertex(), b = vertex();
  const double width = random.between(1, 4);
  if (random.once_in(8)) return aimed(eye, eye + (a - b), width);
  return aimed(eye, random.once_in(2) ? a : a * 0.5 + b * 0.5, width);
}

}  // namespace sightline::stress
