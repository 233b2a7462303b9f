#include "exact/plane_table.hpp"

#include "exact/wide.hpp"

#include <algorithm>
#include <stdexcept>

namespace sightline {
namespace {

std::uint64_t mix(std::uint64_t h, std::uint64_t x) {
  h ^= x;
  h *= 0x9e3779b97f4a7c15u;
  return h ^ (h >> 29);
}

}  // namespace

PlaneTable::Interned PlaneTable::add_points(PointId a, PointId b, PointId c) {
  const auto p = points_->point(a), q = points_->point(b), r = points_->point(c);
  Wide3<0> u, v;
  for (std::size_t k = 0; k < 3; ++k) {
    u[k] = q[k] - p[k];
    v[k] = r[k] - p[k];
  }
  const Wide3<0> n = cross<0, 0>(u, v);
  return intern(n, dot<0, 0, 0>(n, p), {PlaneSource::points, a, b, c});
}

PlaneTable::Interned PlaneTable::add_axis(int axis, const Integer& value) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("no such axis");
  std::array<Integer, 3> n{0, 0, 0};
  n[static_cast<std::size_t>(axis)] = 1;
  return intern(n, value, {PlaneSource::axis, static_cast<std::uint32_t>(axis), 0, 0});
}

PlaneTable::Interned PlaneTable::add_wall(PointId a, PointId b, int axis) {
  if (axis < 0 || axis > 2) throw std::invalid_argument("no such axis");
  const auto p = points_->point(a), q = points_->point(b);
  // u x e_k: component k+1 is u_{k+2}, component k+2 is -u_{k+1}.
  const auto k = static_cast<std::size_t>(axis), k1 = (k + 1) % 3, k2 = (k + 2) % 3;
  Wide3<0> n;
  n[k1] = q[k2] - p[k2];
  n[k2] = p[k1] - q[k1];
  return intern(n, dot<0, 0, 0>(n, p), {PlaneSource::wall, a, b, static_cast<std::uint32_t>(axis)});
}

PlaneTable::Interned PlaneTable::intern(const std::array<Integer, 3>& n, const Integer& d, const PlaneSource& source) {
  Integer divisor = gcd(gcd(n[0], n[1]), n[2]);
  if (divisor == 0) return {};
  divisor = gcd(divisor, d);
  const bool flipped = sgn(n[0]) != 0 ? sgn(n[0]) < 0 : sgn(n[1]) != 0 ? sgn(n[1]) < 0 : sgn(n[2]) < 0;
  if (flipped) divisor = -divisor;
  std::array<Integer, 4> canonical{n[0] / divisor, n[1] / divisor, n[2] / divisor, d / divisor};
  std::uint32_t normal_bits = 0;
  for (std::size_t k = 0; k < 3; ++k) normal_bits = std::max(normal_bits, magnitude_bits(canonical[k]));
  const std::uint32_t offset_bits = magnitude_bits(canonical[3]);
  const std::uint32_t stride = words_for(normal_bits);
  std::vector<std::uint64_t> words(3 * stride + words_for(offset_bits));
  for (std::uint32_t k = 0; k < 3; ++k) store_words(canonical[k], words.data() + k * stride, stride);
  store_words(canonical[3], words.data() + 3 * stride, words_for(offset_bits));
  return intern_words(words.data(), normal_bits, offset_bits, flipped, source);
}

PlaneTable::Interned PlaneTable::intern_words(const std::uint64_t* words, std::uint32_t normal_bits,
                                              std::uint32_t offset_bits, bool flipped, const PlaneSource& source) {
  const std::uint32_t stride = words_for(normal_bits), count = 3 * stride + words_for(offset_bits);
  std::uint64_t hash = mix(normal_bits, offset_bits);
  for (std::uint32_t i = 0; i < count; ++i) hash = mix(hash, words[i]);
  if (2 * (hash_.size() + 1) > index_.size()) grow_index();
  const std::size_t mask = index_.size() - 1;
  std::size_t slot = hash & mask;
  for (; index_[slot] != none; slot = (slot + 1) & mask) {
    const PlaneId id = index_[slot];
    const Record& r = record_[id];
    if (hash_[id] == hash && r.normal_bits == normal_bits && r.offset_bits == offset_bits &&
        std::equal(words, words + count, words_.data() + r.first))
      return {id, flipped};
  }
  const PlaneId id = size();
  index_[slot] = id;
  hash_.push_back(hash);
  record_.push_back({words_.size(), normal_bits, offset_bits});
  words_.insert(words_.end(), words, words + count);
  source_.push_back(source);
  // All four numbers times 2^-normal_bits; the offset's unit is the grid's, n.u = d 2^-unit_bits.
  const int scale = -static_cast<int>(normal_bits);
  ApproxPlane approx{};
  int nonzero = 0, last = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    approx.n[k] = words_to_double(words + k * stride, stride, scale);
    if (sign_of_words(words + k * stride, stride) != 0) {
      ++nonzero;
      last = static_cast<int>(k);
    }
  }
  approx.d = words_to_double(words + 3 * stride, words_for(offset_bits), scale - points_->grid().unit_bits());
  approx_.push_back(approx);
  axis_.push_back(static_cast<std::int8_t>(nonzero == 1 && normal_bits == 1 ? last : -1));
  return {id, flipped};
}

void PlaneTable::grow_index() {
  index_.assign(std::max<std::size_t>(64, 2 * index_.size()), none);
  const std::size_t mask = index_.size() - 1;
  for (PlaneId id = 0; id < hash_.size(); ++id) {
    std::size_t slot = hash_[id] & mask;
    while (index_[slot] != none) slot = (slot + 1) & mask;
    index_[slot] = id;
  }
}

Limbs PlaneTable::component(PlaneId p, int k) const {
  const Record& r = record_[p];
  const std::uint32_t stride = words_for(r.normal_bits);
  const std::uint64_t* const w = words_.data() + r.first + static_cast<std::uint32_t>(k) * stride;
  const std::uint32_t count = k < 3 ? stride : words_for(r.offset_bits);
  return {w, count, magnitude_bits(w, count)};
}

Integer PlaneTable::integer(PlaneId p, int k) const {
  const Limbs l = component(p, k);
  return load_integer(l.words, l.count);
}

}  // namespace sightline
