// A plane's four integers, ready to be loaded at any width; and the determinants of normals.
#pragma once

#include "exact/plane_table.hpp"
#include "exact/wide.hpp"

#include <algorithm>

namespace sightline {

struct PlaneRow {
  const std::uint64_t* words;
  std::uint32_t normal_words, offset_words;
  int normal_bits, offset_bits;
  int axis;

  PlaneRow() = default;
  PlaneRow(const PlaneTable& planes, PlaneId p)
      : words(planes.words(p)),
        normal_words(words_for(planes.normal_bits(p))),
        offset_words(words_for(planes.offset_bits(p))),
        normal_bits(static_cast<int>(planes.normal_bits(p))),
        offset_bits(static_cast<int>(planes.offset_bits(p))),
        axis(planes.axis(p)) {}

  template <int W>
  Wide3<W> normal() const {
    return load3<W>(words, normal_words);
  }
  template <int W>
  Wide<W> normal(int k) const {
    return load<W>(words + static_cast<std::uint32_t>(k) * normal_words, normal_words);
  }
  template <int W>
  Wide<W> offset() const {
    return load<W>(words + 3 * normal_words, offset_words);
  }
};

/// n.p - d in W words, for a point of the table that has it.
template <int W>
inline Wide<W> value_at(const PlaneRow& q, const PointTable& points, PointId p) {
  const auto value = [&]<int N, int M>(Words<N>, Words<M>) {
    return Wide<W>(dot<W, N, M>(q.normal<N>(), load3<M>(points.words(p), points.stride())) - q.offset<W>());
  };
  if constexpr (W > 1) {  // a point is the shorter by far
    constexpr int half = (W + 1) / 2;
    if (points.bits() < 64 && q.normal_bits < 64 * half) return value(Words<half>{}, Words<1>{});
  }
  return narrowed<W>(q.normal_bits, points.bits(), value);
}
/// Bits of n.p - d: three products of nbits + B, so nbits + B + 2, and d: one more.
inline int value_bits(const PlaneRow& q, const PointTable& points) {
  return std::max(q.normal_bits + points.bits() + 2, q.offset_bits) + 1;
}

/// Sign of det(n_a, n_b, n_c), exactly.
Sign exact_normals_orientation(const PlaneRow& a, const PlaneRow& b, const PlaneRow& c);
/// Sign of the determinant of the four rows (n_i, d_i), exactly; rows along axes are eliminated without arithmetic.
Sign exact_rows_orientation(std::array<PlaneRow, 4> rows);

}  // namespace sightline
