#include "bsp/tree_choice.hpp"

#include <bit>
#include <cmath>

namespace sightline {
namespace {

constexpr std::size_t looked_at = 64;   // parts of the sample among which candidates are chosen by area
constexpr std::size_t candidates = 12;  // planes judged
constexpr double flat = 0x1p-40;        // unit length below which a part counts as lying in a plane
constexpr float blurred = 0x1p-20f;     // what boxes and sums of floats may be off by
constexpr std::size_t bins = 256;       // for gaps
constexpr std::size_t sampled = 8192;   // parts that tell whether there may be a gap among very many
constexpr double narrow = 0x1p-18;      // unit length below which bins would be too small for floats
constexpr std::size_t gaps_from = 8;    // parts from which gaps are looked for
constexpr int steps = 4;                // from part to part, after which they are sorted

constexpr double weight_split = 8.0;  // per piece cut, as part of all
constexpr double weight_hair = 0.3;   // as part of that: one within rounding of the cut, mostly on one side
constexpr double weight_area = 1.0;   // pieces on each side, weighted by the surface of that side
constexpr double weight_cover = 1.0;  // opaque part of the cut

/// Order-preserving, both.
std::int32_t ordered(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  return bits ^ (bits >> 31 & 0x7fffffff);
}
float unordered(std::int32_t x) { return std::bit_cast<float>(x ^ (x >> 31 & 0x7fffffff)); }
std::uint32_t unsigned_order(std::int32_t x) { return static_cast<std::uint32_t>(x) ^ 0x80000000u; }
float from_unsigned(std::uint64_t x) {
  return unordered(static_cast<std::int32_t>(static_cast<std::uint32_t>(x) ^ 0x80000000u));
}

}  // namespace

void TreeChoice::take_sample(std::span<const TreePart> here) {
  step_ = here.size() / counted + 1;
  size_ = 0;
  cornered_ = false;
  for (std::size_t k = 0; k < here.size(); k += step_) {
    const RoundedBox& box = parts_.along(here[k]);
    for (int i = 0; i < 3; ++i) {
      middle_[i][size_] = (box.low[i] + box.high[i]) * 0.5f;
      half_[i][size_] = (box.high[i] - box.low[i]) * 0.5f;
    }
    area_[size_] = parts_.area(here[k]);
    plane_[size_++] = parts_.plane(here[k]);
  }
}

void TreeChoice::take_corners(std::span<const TreePart> here) {
  cornered_ = true;
  for (auto& c : corner_) c.clear();
  for (std::size_t j = 0; j < size_; ++j) {
    first_corner_[j] = static_cast<std::uint32_t>(corner_[0].size());
    parts_.for_corners(here[j * step_], [&](const glm::dvec3& p) {
      for (int k = 0; k < 3; ++k) corner_[k].push_back(p[k]);
    });
    while (corner_[0].size() % 4 != 0) {
      for (auto& c : corner_) c.push_back(c.back());
    }
  }
  first_corner_[size_] = static_cast<std::uint32_t>(corner_[0].size());
}

/// A box that a plane passes through, or comes near to, does not tell where the part lies.
void TreeChoice::count_corners(Count& n, const ApproxPlane& plane) const {
  for (std::size_t j = 0; j < size_; ++j) {
    if (sides_[j] != 3) continue;
    int behind = 0, front = 0;
    for (std::size_t k = first_corner_[j]; k < first_corner_[j + 1]; k += 4) {
      for (std::size_t i = k; i < k + 4; ++i) {
        const double s = plane.n[0] * corner_[0][i] + plane.n[1] * corner_[1][i] + plane.n[2] * corner_[2][i] - plane.d;
        behind |= s < -flat;
        front |= s > flat;
      }
    }
    if (behind == front) {  // one that is a hair beside the plane counts as cut in part
      const double cut = behind ? 1 : weight_hair;
      n.split += cut;
      n.behind += (1 - cut) / 2;
      n.front += (1 - cut) / 2;
    } else {
      (behind ? n.behind : n.front) += 1;
    }
  }
}

TreeChoice::Count TreeChoice::count(std::span<const TreePart> here, PlaneId plane, const glm::dvec3& normal) {
  const ApproxPlane& p = planes_.approx(plane);
  const auto x = static_cast<float>(normal.x), y = static_cast<float>(normal.y), z = static_cast<float>(normal.z),
             d = static_cast<float>(p.d);
  const float rx = std::abs(x), ry = std::abs(y), rz = std::abs(z);
  const bool along = rx + ry + rz < std::max({rx, ry, rz}) * (1 + 0x1p-20f);  // the frame: boxes tell all
  const float blur = along ? blurred : 0;
  int behind = 0, front = 0, on = 0, both = 0;
  for (std::size_t k = 0; k < size_; ++k) {  // no branches: the compiler takes several at a time
    const float middle = x * middle_[0][k] + y * middle_[1][k] + z * middle_[2][k] - d;
    const float reach = rx * half_[0][k] + ry * half_[1][k] + rz * half_[2][k] - blur;
    const int in = plane_[k] == plane, below = middle<reach, above = middle> - reach;
    const int sides = ((below | above << 1) & (in - 1)) | in << 2;
    sides_[k] = sides;
    behind += sides == 1;
    front += sides == 2;
    both += sides == 3;
    on += in;
  }
  Count n;
  n.behind = behind;
  n.front = front;
  n.on = on;
  for (std::size_t k = 0; on > 0 && k < size_; ++k) n.covered += sides_[k] == 4 ? static_cast<double>(area_[k]) : 0.0;
  // Those that are a hair beside a plane count as cut in part.
  const double hair = static_cast<double>(size_) - behind - front - both - on;
  n.split = hair * weight_hair;
  n.behind += hair * (1 - weight_hair) / 2;
  n.front += hair * (1 - weight_hair) / 2;
  if (along) n.split += both;
  if (along || both == 0) return n;
  if (!cornered_) take_corners(here);
  count_corners(n, p);
  return n;
}

/// `d`: how far the plane lies along `normal`.
double TreeChoice::cost(const Count& n, const glm::dvec3& normal, double d) const {
  const glm::dvec3 &size = extent_, &middle = middle_of_all_;
  const int k = main_axis(&normal.x), k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  const double at = (d - normal[k1] * middle[k1] - normal[k2] * middle[k2]) / normal[k];
  glm::dvec3 below = size, above = size;
  below[k] = std::clamp(at - box_.low[k], 0.0, size[k]);
  above[k] = size[k] - below[k];
  double behind = surface(below) / surface_of_all_, front = surface(above) / surface_of_all_;
  if (normal[k] < 0) std::swap(behind, front);
  const double total = n.behind + n.front + n.split + n.on;
  const double section = size[k1] * size[k2] / std::abs(normal[k]);
  const double cover = std::min(1.0, n.covered / section);
  return weight_split * n.split / total +
         weight_area * (behind * (n.behind + n.split) + front * (n.front + n.split)) / total - weight_cover * cover;
}

void TreeChoice::judge(int axis, double at, double before, double total, TreeCut& cut, double& least) const {
  const double low = box_.low[axis], behind = (at - low) / (box_.high[axis] - low);
  const double now = weight_area * (0.2 + 0.8 * (behind * before + (1 - behind) * (total - before)) / total);
  if (now >= least) return;
  least = now;
  cut = {none, axis, at};
}

/// Whether parts along an axis leave no gap, as far as a few steps from part to part tell: mostly a wall or a floor
/// reaches all along it.
bool TreeChoice::covered(int axis, std::size_t count) const {
  const std::int32_t *const low = low_[axis], *const high = high_[axis], end = ordered(box_.high[axis]);
  std::int32_t reached = ordered(box_.low[axis]);
  for (int step = 0; step < steps; ++step) {
    std::int32_t next = reached;
    for (std::size_t k = 0; k < count; ++k) {  // no branches: the compiler takes several at a time
      const std::int32_t to = low[k] <= reached ? high[k] : reached;
      next = to > next ? to : next;
    }
    if (next >= end) return true;
    if (next == reached) return false;
    reached = next;
  }
  return false;
}

/// One by one, by their order.
void TreeChoice::find_narrow_gaps(std::span<const TreePart> here, TreeCut& cut, double& least) {
  for (std::size_t k = 0; k < here.size(); ++k) {
    const RoundedBox& box = parts_.along(here[k]);
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis][k] = ordered(box.low[axis]);
      high_[axis][k] = ordered(box.high[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (covered(axis, here.size())) continue;
    extents_.clear();
    for (std::size_t k = 0; k < here.size(); ++k) {
      extents_.push_back(std::uint64_t{unsigned_order(low_[axis][k])} << 32 | unsigned_order(high_[axis][k]));
    }
    std::sort(extents_.begin(), extents_.end());
    auto reached = static_cast<std::uint32_t>(extents_[0]);
    for (std::size_t k = 1; k < extents_.size(); ++k) {
      const auto low = static_cast<std::uint32_t>(extents_[k] >> 32);
      if (low > reached) {
        const double at = (static_cast<double>(from_unsigned(low)) + from_unsigned(reached)) * 0.5;
        judge(axis, at, static_cast<double>(k), static_cast<double>(here.size()), cut, least);
      }
      reached = std::max(reached, static_cast<std::uint32_t>(extents_[k]));
    }
  }
}

/// Judges the gaps between the parts along the frame: few parts by their order, many by bins.
void TreeChoice::find_gaps(std::span<const TreePart> here, TreeCut& cut, double& least) {
  if (here.size() <= sorted_up_to) {
    find_narrow_gaps(here, cut, least);
    return;
  }
  // Where a part of them leaves no gap all of them leave none.
  if (here.size() > 4 * sampled) {
    double hoped = least;
    TreeCut any;
    find_wide_gaps(here, here.size() / sampled, any, hoped);
    if (hoped >= least) return;
  }
  find_wide_gaps(here, 1, cut, least);
}

/// By bins, of which an empty one between two that are covered is a gap; of every so many parts.
void TreeChoice::find_wide_gaps(std::span<const TreePart> here, std::size_t step, TreeCut& cut, double& least) {
  bins_.assign(6 * (bins + 1), 0);
  float scale[3];
  for (int k = 0; k < 3; ++k) scale[k] = static_cast<float>(bins) / (box_.high[k] - box_.low[k]);
  const std::size_t total = (here.size() - 1) / step + 1;
  for (std::size_t at = 0; at < here.size(); at += step) {
    const RoundedBox& box = parts_.along(here[at]);
    for (int k = 0; k < 3; ++k) {
      const auto bin = [&](float x) {
        return static_cast<std::uint32_t>(std::min((x - box_.low[k]) * scale[k], static_cast<float>(bins - 1)));
      };
      const auto row = static_cast<std::uint32_t>(k) * 2 * (bins + 1);
      ++bins_[row + bin(box.low[k])];
      ++bins_[row + bins + 1 + bin(box.high[k]) + 1];
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box_.high[axis] - box_.low[axis] > narrow)) continue;
    const std::uint32_t *const enter = bins_.data() + axis * 2 * (bins + 1), *const leave = enter + bins + 1;
    std::size_t begun = 0, ended = 0;
    for (std::size_t k = 0; k < bins; ++k) {
      begun += enter[k];
      ended += leave[k];
      // Whoever stands in the bin has begun and not ended.
      if (begun != ended || begun == 0 || begun == total) continue;
      const double at = box_.low[axis] + (static_cast<double>(k) + 0.5) / scale[axis];
      judge(axis, at, static_cast<double>(begun), static_cast<double>(total), cut, least);
    }
  }
}

void TreeChoice::choose_candidates() {
  candidates_.clear();
  for (std::size_t k = 0; k < size_; k += size_ / looked_at + 1) candidates_.push_back({-area_[k], plane_[k]});
  if (candidates_.size() > candidates) {
    std::nth_element(candidates_.begin(), candidates_.begin() + candidates, candidates_.end());
    candidates_.resize(candidates);
  }
  std::sort(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.second < b.second; });
  const auto last =
      std::unique(candidates_.begin(), candidates_.end(), [](auto& a, auto& b) { return a.second == b.second; });
  candidates_.erase(last, candidates_.end());
}

TreeCut TreeChoice::choose(std::span<const TreePart> here, const RoundedBox& along) {
  TreeCut best{parts_.plane(here[0]), -1, 0};
  if (here.size() == 1) return best;
  box_ = along;
  take_sample(here);
  choose_candidates();
  if (candidates_.size() == 1 && here.size() < gaps_from) return {candidates_[0].second, -1, 0};
  for (int k = 0; k < 3; ++k) {
    extent_[k] = static_cast<double>(box_.high[k]) - box_.low[k];
    middle_of_all_[k] = (static_cast<double>(box_.high[k]) + box_.low[k]) * 0.5;
  }
  surface_of_all_ = surface(extent_);
  double least = INFINITY;
  for (const auto& [negative, plane] : candidates_) {
    const ApproxPlane& p = planes_.approx(plane);
    const glm::dvec3 normal = parts_.frame().of({p.n[0], p.n[1], p.n[2]});
    const double now = cost(count(here, plane, normal), normal, p.d);
    if (now >= least) continue;
    least = now;
    best.plane = plane;
  }
  if (here.size() >= gaps_from) find_gaps(here, best, least);
  return best;
}

}  // namespace sightline
