// Exact signs of determinants of plane rows, at the width of their actual bits.
#include "exact/plane_row.hpp"

#include <algorithm>

namespace sightline {

Sign exact_normals_orientation(const PlaneRow& a, const PlaneRow& b, const PlaneRow& c) {
  // Six terms, each below 2^(sum of bits).
  return decide(a.normal_bits + b.normal_bits + c.normal_bits + 3, [&](auto width) -> Sign {
    constexpr int W = width();
    const int longest = std::max({a.normal_bits, b.normal_bits, c.normal_bits});
    return narrowed_to_thirds<W>(longest, [&]<int N>(Words<N>) -> Sign {
      return sign_of<W>(det3<W, N, N>(a.normal<N>(), b.normal<N>(), c.normal<N>()));
    });
  });
}

namespace {

// No axis among the rows: by Laplace, columns x, y against z, d. A term takes d from one row and n from three: at most
// the sum of the normals' bits + max over rows of (offset's - normal's); 24 terms: 5 more.
Sign exact_four(const std::array<PlaneRow, 4>& row) {
  int bits = 0, longer = 0, longest_normal = 0, longest_offset = 0;
  for (const PlaneRow& r : row) {
    bits += r.normal_bits;
    longer = std::max(longer, r.offset_bits - r.normal_bits);
    longest_normal = std::max(longest_normal, r.normal_bits);
    longest_offset = std::max(longest_offset, r.offset_bits);
  }
  return decide(bits + longer + 5, [&](auto width) -> Sign {
    constexpr int W = width();
    const auto value = [&]<int N, int M>(Words<N>, Words<M>) -> Sign {
      constexpr int A = product_words<W, N, N>, B = product_words<W, N, M>;
      std::array<Wide3<N>, 4> n;
      std::array<Wide<M>, 4> d;
      for (std::size_t i = 0; i < 4; ++i) {
        n[i] = row[i].template normal<N>();
        d[i] = row[i].template offset<M>();
      }
      const auto xy = [&](std::size_t i, std::size_t j) { return minor2<A, N, N>(n[i][0], n[i][1], n[j][0], n[j][1]); };
      const auto zd = [&](std::size_t i, std::size_t j) {
        return Wide<B>(times<B, N, M>(n[i][2], d[j]) - times<B, N, M>(n[j][2], d[i]));
      };
      const auto term = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
        return times<W, A, B>(xy(i, j), zd(k, l));
      };
      const Wide<W> plus = term(0, 1, 2, 3) + term(0, 3, 1, 2) + term(1, 2, 0, 3) + term(2, 3, 0, 1);
      const Wide<W> minus = term(0, 2, 1, 3) + term(1, 3, 0, 2);
      return sign_of<W>(Wide<W>(plus - minus));
    };
    // Planes through points of B bits have 2B+2 and 3B+2 bits in a result of 9B+12: two and three ninths.
    constexpr int N = W == 0 ? 0 : (2 * W + 8) / 9, M = W == 0 ? 0 : (3 * W + 8) / 9;
    if constexpr (W > 1 && M < W)
      if (longest_normal < 64 * N && longest_offset < 64 * M) return value(Words<N>{}, Words<M>{});
    return value(width, width);
  });
}

// d of a row once the axis rows are eliminated: d - sum of n_k d_k over their axes k.
template <int W>
Wide<W> reduced_offset(const PlaneRow& row, const PlaneRow* axes, std::size_t count) {
  Wide<W> d = row.offset<W>();
  for (std::size_t i = 0; i < count; ++i) {
    const auto less = narrowed<W>(row.normal_bits, axes[i].offset_bits, [&]<int N, int M>(Words<N>, Words<M>) {
      return times<W, N, M>(row.normal<N>(axes[i].axis), axes[i].template offset<M>());
    });
    d = Wide<W>(d - less);
  }
  return d;
}

}  // namespace

Sign exact_rows_orientation(std::array<PlaneRow, 4> rows) {
  // Axis rows first; every exchange of neighbours changes the sign.
  Sign parity = 1;
  std::size_t axes = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    if (rows[i].axis < 0) continue;
    for (std::size_t j = 0; j < axes; ++j)
      if (rows[j].axis == rows[i].axis) {  // parallel planes: in the other order the sign of the difference of offsets
        // Subtract row j from row i: (0, d_i - d_j); what is left is (d_i - d_j) times the minor of the other normals.
        const Sign difference = decide(std::max(rows[i].offset_bits, rows[j].offset_bits) + 1, [&](auto width) -> Sign {
          constexpr int W = width();
          return sign_of<W>(Wide<W>(rows[i].offset<W>() - rows[j].offset<W>()));
        });
        if (difference == 0) return 0;
        std::array<const PlaneRow*, 3> other{};
        std::size_t count = 0;
        for (std::size_t k = 0; k < 4; ++k)
          if (k != i) other[count++] = &rows[k];
        // Cofactor of (i, 3): (-1)^(i + 3).
        return parity * (i % 2 == 1 ? 1 : -1) * difference * exact_normals_orientation(*other[0], *other[1], *other[2]);
      }
    for (std::size_t j = i; j > axes; --j) {
      std::swap(rows[j], rows[j - 1]);
      parity = -parity;
    }
    ++axes;
  }
  if (axes == 0) return exact_four(rows);

  // Columns: the axes' first, then the others in order. The block of the axes is then the identity.
  std::array<int, 3> column{};
  std::size_t count = 0;
  for (; count < axes; ++count) column[count] = rows[count].axis;
  for (int k = 0; k < 3; ++k)
    if (std::find(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(axes), k) ==
        column.begin() + static_cast<std::ptrdiff_t>(axes))
      column[count++] = k;
  const bool even = (column[1] - column[0] + 3) % 3 == 1;  // a cyclic order
  if (!even) parity = -parity;

  int axis_bits = 0;
  for (std::size_t i = 0; i < axes; ++i) axis_bits = std::max(axis_bits, rows[i].offset_bits);
  // Reduced offsets: `axes` products and the offset, at most 2^2 times the largest.
  int normals = 0, longer = 0;
  for (std::size_t i = axes; i < 4; ++i) {
    normals += rows[i].normal_bits;
    longer = std::max(longer, std::max(rows[i].offset_bits, rows[i].normal_bits + axis_bits) + 2 - rows[i].normal_bits);
  }
  // What is left has 4 - axes rows and a term takes the reduced offset from one: up to six terms, 3 more bits.
  return parity * decide(normals + longer + 3, [&](auto width) -> Sign {
           constexpr int W = width();
           const auto d = [&](std::size_t i) { return reduced_offset<W>(rows[i], rows.data(), axes); };
           if (axes == 3) return sign_of<W>(d(3));
           const auto n = [&](std::size_t i, std::size_t c) { return rows[i].template normal<W>(column[c]); };
           if (axes == 2) return sign_of<W>(Wide<W>(times<W, W, W>(n(2, 2), d(3)) - times<W, W, W>(n(3, 2), d(2))));
           const auto minor = [&](std::size_t i, std::size_t j) {
             const int bits = std::max(rows[i].normal_bits, rows[j].normal_bits);
             return narrowed<W>(bits, bits, [&]<int N, int M>(Words<N>, Words<M>) {
               const auto at = [&](std::size_t row, std::size_t c) { return rows[row].template normal<N>(column[c]); };
               return minor2<W, N, N>(at(i, 1), at(i, 2), at(j, 1), at(j, 2));
             });
           };
           return sign_of<W>(Wide<W>(times<W, W, W>(minor(1, 2), d(3)) - times<W, W, W>(minor(1, 3), d(2)) +
                                     times<W, W, W>(minor(2, 3), d(1))));
         });
}

}  // namespace sightline
