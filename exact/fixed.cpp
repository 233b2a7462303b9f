#include "exact/fixed.hpp"

#include <gmp.h>

#include <algorithm>
#include <type_traits>
#include <utility>

namespace sightline::fixed_detail {

// As the unrolled product in fixed.hpp. GMP's has the processor's own instructions for long carries.
void multiply_words(std::uint64_t* r, int count, const std::uint64_t* a, int n, const std::uint64_t* b, int m) {
  static_assert(std::is_same_v<mp_limb_t, std::uint64_t>);
  mp_limb_t whole[2 * most_words];
  if (n < m) {
    std::swap(a, b);
    std::swap(n, m);
  }
  mpn_mul(whole, a, n, b, m);
  std::copy(whole, whole + count, r);
  const auto subtract = [&](const std::uint64_t* x, int from) {
    unsigned char borrow = 0;
    for (int i = from; i < count; ++i) borrow = sub_borrow(borrow, r[i], x[i - from], r[i]);
  };
  if (static_cast<std::int64_t>(a[n - 1]) < 0) subtract(b, n);
  if (static_cast<std::int64_t>(b[m - 1]) < 0) subtract(a, m);
}

}  // namespace sightline::fixed_detail
