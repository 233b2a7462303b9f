#include "clip/carve.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <numeric>

namespace sightline {
namespace {

/// A box around the corners, which are within 2^-48 of their doubles.
void box_of(const Outline& outline, glm::dvec3& low, glm::dvec3& high) {
  low = high = outline.corner[0];
  for (const glm::dvec3& c : outline.corner) {
    low = glm::min(low, c);
    high = glm::max(high, c);
  }
  low -= 0x1p-47;
  high += 0x1p-47;
}

}  // namespace

bool Carver::carve(const Outline& outline, std::span<const OutlineSide> frame, std::span<const Shadow> shadows,
                   std::vector<CarvedPart>& parts) {
  shadows_ = shadows;
  std::vector<std::uint32_t> all(shadows.size());
  std::iota(all.begin(), all.end(), 0u);
  const std::size_t before = parts.size();
  Outline inside;
  std::vector<Outline> outside;
  if (!cut(outline, frame, inside, outside)) {
    parts.push_back({outline, Sight::hidden});
    return false;
  }
  const bool small = outlines_.area(outline) < threshold_;
  if (carve(inside, all, small, parts)) {
    if (outside.empty()) return true;
    if (!small) {
      for (Outline& o : outside) parts.push_back({std::move(o), Sight::hidden});
    } else {
      parts.resize(before);
      parts.push_back({outline, Sight::partly});
    }
    return true;
  }
  parts.resize(before);
  parts.push_back({outline, Sight::hidden});
  return false;
}

bool Carver::carve(const Outline& outline, std::span<const std::uint32_t> candidates, bool small,
                   std::vector<CarvedPart>& parts) {
  small = small || outlines_.area(outline) < threshold_;
  struct Candidate {
    double overlap;
    std::uint32_t shadow;
  };
  std::vector<Candidate> near;
  glm::dvec3 low, high;
  box_of(outline, low, high);
  for (const std::uint32_t k : candidates) {
    const Shadow& s = shadows_[k];
    if (glm::any(glm::lessThan(high, s.low)) || glm::any(glm::lessThan(s.high, low))) continue;
    if (!apart(outline, shadows_[k])) near.push_back({overlap(outline, shadows_[k]), k});
  }
  std::sort(near.begin(), near.end(), [](const Candidate& a, const Candidate& b) {
    return a.overlap > b.overlap || (a.overlap == b.overlap && a.shadow < b.shadow);
  });
  Outline inside;
  std::vector<Outline> outside;
  std::size_t next = 0;
  while (next < near.size() && !cut(outline, shadows_[near[next].shadow].lines, inside, outside)) ++next;
  if (next == near.size()) {
    parts.push_back({outline, Sight::visible});
    return true;
  }
  const std::size_t before = parts.size();
  bool seen = false;
  if (!outside.empty()) {
    std::vector<std::uint32_t> rest;
    for (std::size_t k = next + 1; k < near.size(); ++k) rest.push_back(near[k].shadow);
    std::sort(rest.begin(), rest.end());
    parts.push_back({std::move(inside), Sight::hidden});
    for (const Outline& o : outside) {
      if (!(small && seen)) seen = carve(o, rest, small, parts) || seen;
    }
  }
  if (seen && !small) return true;
  parts.resize(before);
  parts.push_back({outline, seen ? Sight::partly : Sight::hidden});
  return seen;
}

/// The part within all lines and, disjoint, those without; false, and nothing of use, if nothing is within.
bool Carver::cut(const Outline& outline, std::span<const OutlineSide> lines, Outline& inside,
                 std::vector<Outline>& outside) {
  outside.clear();
  inside = outline;
  for (const OutlineSide& line : lines) {
    const int where = outlines_.sides(inside, line.line);
    if (where == 1) return false;
    if (where != 3) continue;
    ++cuts_;
    Outline in;
    outside.emplace_back();
    outlines_.split(inside, line, outside.back(), in);
    inside = std::move(in);
  }
  return true;
}

bool Carver::meets(const Outline& outline, const Shadow& figure) {
  Outline inside;
  std::vector<Outline> outside;
  return cut(outline, figure.lines, inside, outside);
}

void Carver::bound(const Outline& whole, std::vector<Shadow>& shadows) {
  Outline inside;
  std::vector<Outline> outside;
  std::size_t kept = 0;
  for (Shadow& shadow : shadows) {
    if (!cut(whole, shadow.lines, inside, outside)) continue;
    box_of(inside, shadow.low, shadow.high);
    if (&shadows[kept] != &shadow) shadows[kept] = std::move(shadow);
    ++kept;
  }
  shadows.resize(kept);
}

/// Does a line of the shadow separate them? Where not, they may still be apart.
bool Carver::apart(const Outline& outline, const Shadow& shadow) {
  return std::any_of(shadow.lines.begin(), shadow.lines.end(), [&](const OutlineSide& line) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
      if (outlines_.side(outline, k, line.line) > 0) return false;
    }
    return true;
  });
}

/// The area that they share, up to a factor for the surface, in doubles. It only orders the work, but decides which
/// pieces come out: it is found from the corners' nearest doubles and the scene alone, so that it is always the same.
double Carver::overlap(const Outline& outline, const Shadow& shadow) {
  const int i = (outlines_.lines().axis() + 1) % 3, j = (outlines_.lines().axis() + 2) % 3;
  figure_.clear();
  for (const glm::dvec3& c : outline.corner) figure_.emplace_back(c[i], c[j]);
  for (const glm::dvec3& line : shadow.rough) {
    clipped_.clear();
    for (std::size_t k = 0; k < figure_.size(); ++k) {
      const glm::dvec2 p = figure_[k], q = figure_[k + 1 == figure_.size() ? 0 : k + 1];
      const double a = line.x * p.x + line.y * p.y + line.z, b = line.x * q.x + line.y * q.y + line.z;
      if (a >= 0) clipped_.push_back(p);
      if ((a > 0 && b < 0) || (a < 0 && b > 0)) clipped_.push_back(p + (q - p) * (a / (a - b)));
    }
    figure_.swap(clipped_);
    if (figure_.size() < 3) return 0;
  }
  double twice = 0;
  for (std::size_t k = 2; k < figure_.size(); ++k) {
    const glm::dvec2 a = figure_[k - 1] - figure_[0], b = figure_[k] - figure_[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice > 0 ? twice / 2 : 0;
}

}  // namespace sightline
