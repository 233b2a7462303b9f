#include "exact/limbs.hpp"

#include <algorithm>
#include <cmath>

namespace sightline {

static_assert(GMP_LIMB_BITS == 64 && GMP_NAIL_BITS == 0, "words and GMP's limbs are the same");

std::uint32_t long_magnitude_bits(const std::uint64_t* words, std::uint32_t count) {
  const bool negative = static_cast<std::int64_t>(words[count - 1]) < 0;
  const std::uint64_t fill = negative ? ~std::uint64_t{0} : 0;
  std::uint32_t top = count;
  while (top > 0 && words[top - 1] == fill) --top;
  // For x < 0 the magnitude is ~x + 1: one bit longer than ~x just when ~x is all ones (x = -2^k).
  if (top == 0) return negative ? 1 : 0;
  const std::uint64_t lead = words[top - 1] ^ fill;
  const std::uint32_t bits = 64 * (top - 1) + static_cast<std::uint32_t>(std::bit_width(lead));
  if (!negative) return bits;
  const bool power_of_two =
      (lead & (lead + 1)) == 0 && std::all_of(words, words + top - 1, [](auto w) { return w == 0; });
  return power_of_two ? bits + 1 : bits;
}

std::uint32_t magnitude_bits(const Integer& x) {
  return x == 0 ? 0 : static_cast<std::uint32_t>(mpz_sizeinbase(x.get_mpz_t(), 2));
}

void store_words(const Integer& x, std::uint64_t* words, std::uint32_t count) {
  const mpz_srcptr z = x.get_mpz_t();
  const std::size_t size = mpz_size(z);
  for (std::uint32_t i = 0; i < count; ++i) words[i] = i < size ? mpz_limbs_read(z)[i] : 0;
  if (mpz_sgn(z) >= 0) return;
  std::uint64_t carry = 1;
  for (std::uint32_t i = 0; i < count; ++i) {
    words[i] = ~words[i] + carry;
    carry = carry != 0 && words[i] == 0 ? 1 : 0;
  }
}

void load_integer(Integer& to, const std::uint64_t* words, std::uint32_t count) {
  const bool negative = static_cast<std::int64_t>(words[count - 1]) < 0;
  mp_limb_t* const limbs = mpz_limbs_write(to.get_mpz_t(), count);
  std::uint64_t carry = negative ? 1 : 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    limbs[i] = negative ? ~words[i] + carry : words[i];
    carry = carry != 0 && limbs[i] == 0 ? 1 : 0;
  }
  const auto size = static_cast<mp_size_t>(count);
  mpz_limbs_finish(to.get_mpz_t(), negative ? -size : size);
}

Integer load_integer(const std::uint64_t* words, std::uint32_t count) {
  Integer r;
  load_integer(r, words, count);
  return r;
}

double long_words_to_double(const std::uint64_t* words, std::uint32_t count, int exponent) {
  while (count > 1 && words[count - 1] == static_cast<std::uint64_t>(static_cast<std::int64_t>(words[count - 2]) >> 63))
    --count;
  if (count == 1) return std::ldexp(static_cast<double>(static_cast<std::int64_t>(words[0])), exponent);
  // The top 64 significant bits, the sign included, as an int64; below them one sticky bit, so that the conversion to
  // double rounds as if it saw all words: at least 62 bits of magnitude are kept, and 62 > 53 + 1.
  const std::uint64_t high = words[count - 1], low = words[count - 2];
  const auto lead = static_cast<int>(std::countl_zero(static_cast<std::int64_t>(high) < 0 ? ~high : high)) - 1;
  std::uint64_t window = high << lead;
  std::uint64_t rest = low;
  if (lead > 0) {
    window |= low >> (64 - lead);
    rest = low << lead;
  }
  bool sticky = rest != 0;
  for (std::uint32_t i = 0; i + 2 < count && !sticky; ++i) sticky = words[i] != 0;
  if (sticky) window |= 1;
  const int power = exponent + 64 * static_cast<int>(count - 1) - lead;
  const auto value = static_cast<double>(static_cast<std::int64_t>(window));
  // As in words_to_double: exact within the normal range.
  if (power < -1000 || power > 900) return std::ldexp(value, power);
  return value * std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52);
}

std::uint32_t LimbStore::add(const Integer& value) {
  const std::uint32_t bits = magnitude_bits(value);
  const std::uint32_t count = words_for(bits);
  entries_.push_back({words_.size(), count, bits});
  words_.resize(words_.size() + count);
  store_words(value, words_.data() + entries_.back().first, count);
  return size() - 1;
}

Limbs LimbStore::operator[](std::uint32_t index) const {
  const Entry& e = entries_[index];
  return {words_.data() + e.first, e.count, e.bits};
}

Integer LimbStore::integer(std::uint32_t index) const {
  const Limbs l = (*this)[index];
  return load_integer(l.words, l.count);
}

void LimbStore::clear() {
  words_.clear();
  entries_.clear();
}

}  // namespace sightline
