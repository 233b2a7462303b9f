#include "bsp/choose.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {
namespace {

constexpr std::size_t most_candidates = 64;  // planes looked at in a large cell
constexpr std::size_t most_counted = 2048;   // pieces counted for each
constexpr std::size_t most_for_median = 512;
constexpr std::size_t free_space_from = 24;  // pieces from which cuts in free space are considered
constexpr double flat = 0x1p-40;             // unit length below which a piece counts as lying in a plane

// Area of a box's section by a plane with normal n, roughly: the side seen along the normal's main axis.
double section(const glm::dvec3& size, const double n[3]) {
  const int k = main_axis(n);
  return size[(k + 1) % 3] * size[(k + 2) % 3] * std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / std::abs(n[k]);
}

// The part of the box's surface that lies behind the plane and the part in front, the cut counted with both.
std::pair<double, double> surface_parts(const Bounds& box, const double n[3], double d) {
  const glm::dvec3 size = box.high - box.low;
  const double all = surface(size);
  const int k = main_axis(n);
  // Where the plane meets the box's middle line along its main axis.
  const glm::dvec3 middle = (box.low + box.high) * 0.5;
  const double at = (d - n[(k + 1) % 3] * middle[(k + 1) % 3] - n[(k + 2) % 3] * middle[(k + 2) % 3]) / n[k];
  glm::dvec3 below = size, above = size;
  below[k] = std::clamp(at - box.low[k], 0.0, size[k]);
  above[k] = size[k] - below[k];
  const double parts[2] = {surface(below) / all, surface(above) / all};
  return n[k] > 0 ? std::pair{parts[0], parts[1]} : std::pair{parts[1], parts[0]};
}

/// Calls visit(piece) for a regular sample of at most so many.
template <class Visit>
void for_sample(std::span<Piece> pieces, std::size_t most, Visit&& visit) {
  const std::size_t stride = pieces.size() / most + 1;
  for (std::size_t k = 0; k < pieces.size(); k += stride) visit(pieces[k]);
}

struct Places {
  std::size_t above, first;
};

/// How many of the ascending values, which are not none, are at most `low`, and how many are below `high`. Both are
/// looked for at once, without branches: neither has to wait for the other.
Places find(const std::vector<double>& values, double low, double high) {
  const double *above = values.data(), *first = above;
  for (std::size_t n = values.size(); n > 1;) {
    const std::size_t half = n / 2;
    above += above[half - 1] <= low ? half : 0;
    first += first[half - 1] < high ? half : 0;
    n -= half;
  }
  return {static_cast<std::size_t>(above - values.data()) + (*above <= low ? 1 : 0),
          static_cast<std::size_t>(first - values.data()) + (*first < high ? 1 : 0)};
}

}  // namespace

double Chooser::area(Piece& piece) const {
  if (piece.known_area < 0) piece.known_area = pieces_.area(piece);
  return piece.known_area;
}

// A piece that lies within rounding of a plane without being in it is cut or not as the exact signs say; but it leaves
// a wedge of a cell behind, where walls of others end in slivers.
void Chooser::add_hair(Count& n, const Piece& piece, PlaneId plane) const {
  const int found = plane == none ? 3 : pieces_.exact_sides(piece, plane);
  const double cut = found == 3 ? 1 : weights_.hair;
  n.split += cut;
  (found == 1 ? n.behind : n.front) += 1 - cut;
}

// A piece lies in front of the cuts below it, and behind those above it: two places among the sorted cuts tell its side
// of all of them. Those between, if any, are within rounding of it.
void Chooser::count_axes(std::span<Piece> pieces) {
  for (int axis = 0; axis < 3; ++axis) {
    auto& cuts = cuts_[axis];
    std::sort(cuts.begin(), cuts.end(), [](auto& a, auto& b) { return a.value < b.value; });
    values_[axis].clear();
    for (const AxisCut& cut : cuts) values_[axis].push_back(cut.value);
    in_front_[axis].assign(cuts.size() + 1, 0);
    behind_[axis].assign(cuts.size() + 1, 0);
  }
  for_sample(pieces, most_counted, [&](Piece& piece) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto& values = values_[axis];
      if (values.empty()) continue;
      const auto [above, first] = find(values, piece.low[axis] + flat, piece.high[axis] - flat);
      ++in_front_[axis][above];
      ++behind_[axis][first];
      for (std::size_t k = first; k < above; ++k) {
        AxisCut& cut = cuts_[axis][k];
        if (piece.plane == cut.plane) {
          cut.count.covered += area(piece);
          cut.count.on += 1;
        } else {
          cut.count.within += 1;
          add_hair(cut.count, piece, cut.plane);
        }
      }
    }
  });
  for (int axis = 0; axis < 3; ++axis) {
    double front = 0, behind = 0, all = 0;
    for (const std::uint32_t n : in_front_[axis]) all += n;
    front = all;
    for (std::size_t k = 0; k < cuts_[axis].size(); ++k) {
      Count& n = cuts_[axis][k].count;
      const double flush = n.on + n.within;
      front -= in_front_[axis][k];
      behind += behind_[axis][k];
      n.front += front - flush;
      n.behind += behind - flush;
      n.split += all - front - behind + flush;
    }
  }
}

Chooser::Count Chooser::count_plane(std::span<Piece> pieces, PlaneId plane) const {
  const ApproxPlane& p = planes_.approx(plane);
  const BoxSide box_side(p);
  Count n;
  for_sample(pieces, most_counted, [&](Piece& piece) {
    if (piece.plane == plane) {
      n.covered += area(piece);
      n.on += 1;
      return;
    }
    if (const Sign clear = box_side.of(piece.low, piece.high); clear != 0) {
      (clear < 0 ? n.behind : n.front) += 1;
      return;
    }
    bool behind = false, front = false;
    for (const PieceCorner& c : pieces_.corners(piece)) {
      const double s = p.n[0] * c.place.approx.x + p.n[1] * c.place.approx.y + p.n[2] * c.place.approx.z - p.d;
      behind |= s < -flat;
      front |= s > flat;
    }
    if (!behind && !front) {
      add_hair(n, piece, plane);
    } else if (behind && front) {
      n.split += 1;
    } else if (behind) {
      n.behind += 1;
    } else {
      n.front += 1;
    }
  });
  return n;
}

double Chooser::cost(const Count& n, std::size_t total, const Bounds& cell, const double normal[3], double d) const {
  const double counted = n.behind + n.front + n.split + n.on;
  const double scale = static_cast<double>(total) / counted;
  const double cut = section(cell.high - cell.low, normal);
  const double cover = cut > 0 ? std::min(1.0, n.covered * scale / cut) : 1.0;
  const auto [behind, front] = surface_parts(cell, normal, d);
  const bool along_axis = (normal[0] != 0) + (normal[1] != 0) + (normal[2] != 0) == 1;
  return weights_.split * n.split / counted +
         weights_.area * (behind * (n.behind + n.split) + front * (n.front + n.split)) / counted -
         weights_.cover * cover - (along_axis ? weights_.axis : 0.0);
}

/// Every plane of a small cell; of a large one a regular sample, so that the work stays near linear.
void Chooser::add_candidates(std::span<Piece> pieces) {
  candidates_.clear();
  const std::size_t stride = pieces.size() > 4 * most_candidates ? pieces.size() / (2 * most_candidates) : 1;
  for (std::size_t k = 0; k < pieces.size(); k += stride) candidates_.push_back(pieces[k].plane);
  std::sort(candidates_.begin(), candidates_.end());
  candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
}

/// Puts planes across an axis where they belong.
void Chooser::sort_candidates() {
  for (auto& cuts : cuts_) cuts.clear();
  std::erase_if(candidates_, [&](PlaneId plane) {
    const int axis = planes_.axis(plane);
    if (axis < 0) return false;
    const ApproxPlane& p = planes_.approx(plane);
    cuts_[axis].push_back({p.d / p.n[axis], plane, {}});
    return true;
  });
}

/// Cuts in free space near the medians of the pieces.
void Chooser::add_middles(std::span<Piece> pieces) {
  for (int axis = 0; axis < 3; ++axis) {
    middles_.clear();
    double low = pieces[0].low[axis], high = pieces[0].high[axis];
    for_sample(pieces, most_for_median, [&](Piece& p) {
      low = std::min(low, p.low[axis]);
      high = std::max(high, p.high[axis]);
      middles_.push_back((p.low[axis] + p.high[axis]) / 2);
    });
    const double size = high - low;
    if (size <= 0) continue;
    const auto middle = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
    std::nth_element(middles_.begin(), middle, middles_.end());
    // A coordinate of few digits: cheap to compute with ever after.
    const double digit = std::exp2(std::floor(std::log2(size)) - 4);
    const double value = std::round(*middle / digit) * digit;
    if (value > low && value < high) cuts_[axis].push_back({value, none, {}});
  }
}

/// A coordinate in grid units.
Integer Chooser::on_grid(double value) const {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  Integer grid = static_cast<long>(std::ldexp(mantissa, 53));
  const int shift = exponent - 53 + scene_.grid().unit_bits();
  if (shift >= 0) {
    grid <<= static_cast<unsigned long>(shift);
  } else {
    mpz_fdiv_q_2exp(grid.get_mpz_t(), grid.get_mpz_t(), static_cast<unsigned long>(-shift));
  }
  return grid;
}

Choice Chooser::choose(std::span<Piece> pieces, const Bounds& cell, bool free_space) {
  Choice best;
  const bool many = free_space && pieces.size() >= free_space_from;
  add_candidates(pieces);
  if (!many && candidates_.size() == 1) {
    best.plane = candidates_[0];
    return best;
  }
  sort_candidates();
  if (many) add_middles(pieces);
  count_axes(pieces);
  double least = INFINITY, value = 0;
  // Of equal ones the plane that was made first.
  const auto better = [&](double now, PlaneId plane) {
    if (now > least || (now == least && plane >= best.plane)) return false;
    least = now;
    best.plane = plane;
    return true;
  };
  for (const PlaneId plane : candidates_) {
    const ApproxPlane& p = planes_.approx(plane);
    better(cost(count_plane(pieces, plane), pieces.size(), cell, p.n, p.d), plane);
  }
  for (int axis = 0; axis < 3; ++axis) {
    double normal[3] = {0, 0, 0};
    normal[axis] = 1;
    for (const AxisCut& cut : cuts_[axis]) {
      if (!better(cost(cut.count, pieces.size(), cell, normal, cut.value), cut.plane)) continue;
      best.axis = axis;
      value = cut.value;
    }
  }
  if (best.plane == none) best.value = on_grid(value);
  return best;
}

}  // namespace sightline
