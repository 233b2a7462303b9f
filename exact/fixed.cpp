#include "exact/fixed.hpp"

#include <algorithm>

namespace sightline::fixed_detail {

// As the unrolled product in fixed.hpp.
void multiply_words(std::uint64_t* r, int count, const std::uint64_t* a, int n, const std::uint64_t* b, int m) {
  std::fill(r, r + count, 0);
  for (int i = 0; i < std::min(n, count); ++i) {
    std::uint64_t carry = 0;
    const int end = std::min(m, count - i);
    for (int j = 0; j < end; ++j) {
      const unsigned __int128 t = static_cast<unsigned __int128>(a[i]) * b[j] + r[i + j] + carry;
      r[i + j] = static_cast<std::uint64_t>(t);
      carry = static_cast<std::uint64_t>(t >> 64);
    }
    if (i + m < count) r[i + m] = carry;
  }
  const auto subtract = [&](const std::uint64_t* x, int from) {
    unsigned char borrow = 0;
    for (int i = from; i < count; ++i) borrow = sub_borrow(borrow, r[i], x[i - from], r[i]);
  };
  if (static_cast<std::int64_t>(a[n - 1]) < 0) subtract(b, n);
  if (static_cast<std::int64_t>(b[m - 1]) < 0) subtract(a, m);
}

}  // namespace sightline::fixed_detail
