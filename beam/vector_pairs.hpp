// Signs of many products with one vector. Internal to beam/.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace sightline {

/// Vectors, two by two, so that two products are made at a time.
class VectorPairs {
 public:
  /// A bit each for 32 vectors: is the product above the bound, or below its negative?
  struct Signs {
    std::uint32_t above = 0, below = 0;
  };

  void resize(std::size_t count) {
    count_ = count;
    if (pairs_.size() < (count + 1) / 2) pairs_.resize((count + 1) / 2);
  }
  void set(std::size_t k, const glm::dvec3& v) {
    Pair& p = pairs_[k / 2];
    p.x[k % 2] = v.x;
    p.y[k % 2] = v.y;
    p.z[k % 2] = v.z;
  }
  glm::dvec3 operator[](std::size_t k) const {
    const Pair& p = pairs_[k / 2];
    return {p.x[k % 2], p.y[k % 2], p.z[k % 2]};
  }
  std::size_t size() const { return count_; }
  /// The bits of the vectors from `first`, a multiple of 32, on.
  std::uint32_t all(std::size_t first) const { return count_ - first >= 32 ? ~0u : (1u << (count_ - first)) - 1; }
  /// Products are rounded as x x' + y y' + z z' from the left. Vectors from `first` on.
  Signs signs(const glm::dvec3& n, double bound, std::size_t first = 0) const {
    Signs s;
    const std::size_t here = (count_ + 1) / 2, end = here < first / 2 + 16 ? here : first / 2 + 16;
    unsigned shift = 0;
#ifdef __SSE2__
    const __m128d x = _mm_set1_pd(n.x), y = _mm_set1_pd(n.y), z = _mm_set1_pd(n.z);
    const __m128d most = _mm_set1_pd(bound), least = _mm_set1_pd(-bound);
    for (std::size_t k = first / 2; k < end; ++k, shift += 2) {
      const Pair& p = pairs_[k];
      const __m128d product = _mm_add_pd(_mm_add_pd(_mm_mul_pd(x, _mm_load_pd(p.x)), _mm_mul_pd(y, _mm_load_pd(p.y))),
                                         _mm_mul_pd(z, _mm_load_pd(p.z)));
      s.above |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmpgt_pd(product, most))) << shift;
      s.below |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmplt_pd(product, least))) << shift;
    }
#else
    for (std::size_t k = first / 2; k < end; ++k) {
      for (int i = 0; i < 2; ++i, ++shift) {
        const double product = n.x * pairs_[k].x[i] + n.y * pairs_[k].y[i] + n.z * pairs_[k].z[i];
        s.above |= (product > bound ? 1u : 0u) << shift;
        s.below |= (product < -bound ? 1u : 0u) << shift;
      }
    }
#endif
    const std::uint32_t those = all(first);
    return {s.above & those, s.below & those};
  }

 private:
  struct alignas(16) Pair {
    double x[2] = {0, 0}, y[2] = {0, 0}, z[2] = {0, 0};
  };
  std::vector<Pair> pairs_;
  std::size_t count_ = 0;
};

}  // namespace sightline
