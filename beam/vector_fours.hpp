// Signs of many products with one vector, in floats. Internal to beam/.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace sightline {

/// Vectors, four by four, of a length of their own each, so that four products are made at a time. What floats leave
/// open is for doubles: no sign is told that is not certain.
///
/// A vector is divided by its largest component; then all are at most 1, and within u = 2^-24. With a factor whose
/// components are at most N and within u N: three products within 3 u N each, two sums of at most 2 N and 3 N: 14 u N
/// in all, and u^2 here and there.
class VectorFours {
 public:
  /// The largest component that factors may have.
  static constexpr double most = 2;
  /// Of four vectors, a bit each: is the product certainly positive, or negative?
  struct Signs {
    int above, below;
  };
  static constexpr int all = 15;

  /// The factor, ready for many products.
  struct Factor {
#ifdef __SSE2__
    __m128 x, y, z;
    explicit Factor(const glm::dvec3& v) {
      const __m128 xy = _mm_cvtpd_ps(_mm_loadu_pd(&v.x)), zz = _mm_cvtpd_ps(_mm_set1_pd(v.z));
      x = _mm_shuffle_ps(xy, xy, _MM_SHUFFLE(0, 0, 0, 0));
      y = _mm_shuffle_ps(xy, xy, _MM_SHUFFLE(1, 1, 1, 1));
      z = _mm_shuffle_ps(zz, zz, _MM_SHUFFLE(0, 0, 0, 0));
    }
#else
    float x, y, z;
    explicit Factor(const glm::dvec3& v)
        : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
#endif
  };

  /// How many fours there are.
  std::size_t size() const { return size_; }
  /// Room for so many vectors.
  void resize(std::size_t count) {
    size_ = (count + 3) / 4;
    if (fours_.size() < size_) fours_.resize(size_);
  }
  /// Vector k, all of whose products with factors are within `doubt` of the true ones as doubles.
  void set(std::size_t k, const glm::dvec3& v, double doubt) {
    const double part = 1 / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    Four& four = fours_[k / 4];
    four.x[k % 4] = static_cast<float>(v.x * part);
    four.y[k % 4] = static_cast<float>(v.y * part);
    four.z[k % 4] = static_cast<float>(v.z * part);
    four.bound[k % 4] = static_cast<float>(most * 0x1p-20 + 1.001 * doubt * part);
  }
  /// After the last vector, k: what is left of its four is that vector again.
  void close(std::size_t k) {
    Four& four = fours_[k / 4];
    for (std::size_t i = k % 4 + 1; i < 4; ++i) {
      four.x[i] = four.x[i - 1];
      four.y[i] = four.y[i - 1];
      four.z[i] = four.z[i - 1];
      four.bound[i] = four.bound[i - 1];
    }
  }
  Signs signs(const Factor& n, std::size_t four) const {
    const Four& f = fours_[four];
#ifdef __SSE2__
    const __m128 product = _mm_add_ps(_mm_add_ps(_mm_mul_ps(n.x, _mm_load_ps(f.x)), _mm_mul_ps(n.y, _mm_load_ps(f.y))),
                                      _mm_mul_ps(n.z, _mm_load_ps(f.z)));
    const __m128 bound = _mm_load_ps(f.bound);
    return {_mm_movemask_ps(_mm_cmpgt_ps(product, bound)),
            _mm_movemask_ps(_mm_cmplt_ps(product, _mm_xor_ps(bound, _mm_set1_ps(-0.0f))))};
#else
    Signs s{0, 0};
    for (int k = 0; k < 4; ++k) {
      const float product = n.x * f.x[k] + n.y * f.y[k] + n.z * f.z[k];
      s.above |= (product > f.bound[k] ? 1 : 0) << k;
      s.below |= (product < -f.bound[k] ? 1 : 0) << k;
    }
    return s;
#endif
  }

 private:
  struct alignas(16) Four {
    float x[4], y[4], z[4], bound[4];
  };
  std::vector<Four> fours_;
  std::size_t size_ = 0;
};

}  // namespace sightline
