#include "bsp/choose.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace sightline {
namespace {

constexpr std::size_t most_candidates = 64;  // planes looked at in a large cell
constexpr std::size_t most_counted = 2048;   // pieces counted for each
constexpr std::size_t free_space_from = 24;  // pieces from which cuts in free space are considered
constexpr double flat = 0x1p-40;             // unit length below which a piece counts as lying in a plane

// Area of a box's section by a plane with normal n, roughly: the side seen along the normal's main axis.
double section(const glm::dvec3& size, const double n[3]) {
  const int k = main_axis(n);
  return size[(k + 1) % 3] * size[(k + 2) % 3] * std::hypot(n[0], n[1], n[2]) / std::abs(n[k]);
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

}  // namespace

// A piece that lies within rounding of a plane without being in it is cut or not as the exact signs say; but it leaves
// a wedge of a cell behind, where walls of others end in slivers.
void Chooser::add_hair(Count& n, const Piece& piece, PlaneId plane) const {
  const int found = plane == none ? 3 : pieces_.exact_sides(piece, plane);
  const double cut = found == 3 ? 1 : weights_.hair;
  n.split += cut;
  (found == 1 ? n.behind : n.front) += 1 - cut;
}

Chooser::Count Chooser::count_axis(std::span<const Piece> pieces, PlaneId plane, int axis, double value) const {
  Count n;
  const std::size_t stride = pieces.size() / most_counted + 1;
  for (std::size_t k = 0; k < pieces.size(); k += stride) {
    const double low = pieces[k].low[axis] - value, high = pieces[k].high[axis] - value;
    if (high <= flat && low >= -flat) {
      if (pieces[k].plane == plane) {
        n.covered += pieces_.area(pieces[k]);
        n.on += 1;
      } else {
        add_hair(n, pieces[k], plane);
      }
    } else if (high <= flat) {
      n.behind += 1;
    } else if (low >= -flat) {
      n.front += 1;
    } else {
      n.split += 1;
    }
  }
  return n;
}

Chooser::Count Chooser::count_plane(std::span<const Piece> pieces, PlaneId plane) const {
  const ApproxPlane& p = planes_.approx(plane);
  if (const int axis = planes_.axis(plane); axis >= 0) return count_axis(pieces, plane, axis, p.d / p.n[axis]);
  Count n;
  const std::size_t stride = pieces.size() / most_counted + 1;
  for (std::size_t k = 0; k < pieces.size(); k += stride) {
    if (pieces[k].plane == plane) {
      n.covered += pieces_.area(pieces[k]);
      n.on += 1;
      continue;
    }
    bool behind = false, front = false;
    for (const PieceCorner& c : pieces_.corners(pieces[k])) {
      const double s = p.n[0] * c.place.approx.x + p.n[1] * c.place.approx.y + p.n[2] * c.place.approx.z - p.d;
      behind |= s < -flat;
      front |= s > flat;
    }
    if (!behind && !front) {
      add_hair(n, pieces[k], plane);
    } else if (behind && front) {
      n.split += 1;
    } else if (behind) {
      n.behind += 1;
    } else {
      n.front += 1;
    }
  }
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

Choice Chooser::choose(std::span<const Piece> pieces, const Bounds& cell, bool free_space) {
  glm::dvec3 low = pieces[0].low, high = pieces[0].high;
  for (const Piece& p : pieces) {
    low = glm::min(low, p.low);
    high = glm::max(high, p.high);
  }

  // Candidates: every plane of a small cell; of a large one a regular sample, so that the work stays near linear.
  candidates_.clear();
  const std::size_t stride = pieces.size() > 4 * most_candidates ? pieces.size() / (2 * most_candidates) : 1;
  for (std::size_t k = 0; k < pieces.size(); k += stride) candidates_.push_back({pieces[k].plane, 0});
  std::sort(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.plane < b.plane; });
  candidates_.erase(
      std::unique(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.plane == b.plane; }),
      candidates_.end());
  Choice best;
  double least = 0;
  for (const Candidate& c : candidates_) {
    const ApproxPlane& p = planes_.approx(c.plane);
    const double now = cost(count_plane(pieces, c.plane), pieces.size(), cell, p.n, p.d);
    if (best.plane == none || now < least) {
      least = now;
      best.plane = c.plane;
    }
  }
  if (!free_space || pieces.size() < free_space_from) return best;

  for (int axis = 0; axis < 3; ++axis) {
    const double size = high[axis] - low[axis];
    if (size <= 0) continue;
    middles_.clear();
    for (const Piece& p : pieces) middles_.push_back((p.low[axis] + p.high[axis]) / 2);
    const auto middle = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
    std::nth_element(middles_.begin(), middle, middles_.end());
    // A coordinate of few digits near the median: cheap to compute with ever after.
    const double digit = std::exp2(std::floor(std::log2(size)) - 4);
    const double value = std::round(*middle / digit) * digit;
    if (!(value > low[axis] && value < high[axis])) continue;
    double normal[3] = {0, 0, 0};
    normal[axis] = 1;
    const double now = cost(count_axis(pieces, none, axis, value), pieces.size(), cell, normal, value);
    if (now < least) {
      least = now;
      best.plane = none;
      best.axis = axis;
      int exponent = 0;
      const double mantissa = std::frexp(value, &exponent);
      best.value = static_cast<long>(std::ldexp(mantissa, 53));
      const int shift = exponent - 53 + scene_.grid().unit_bits();
      if (shift >= 0) {
        best.value <<= static_cast<unsigned long>(shift);
      } else {
        mpz_fdiv_q_2exp(best.value.get_mpz_t(), best.value.get_mpz_t(), static_cast<unsigned long>(-shift));
      }
    }
  }
  return best;
}

}  // namespace sightline
