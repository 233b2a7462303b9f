#include "compare/axis.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::comparison {
namespace {

std::string power_of_ten(int e) {
  if (e < -2 || e > 4) return "1e" + std::to_string(e);
  const std::string zeros(static_cast<std::size_t>(std::abs(e)), '0');
  return e >= 0 ? "1" + zeros : "0." + zeros.substr(1) + "1";
}

}  // namespace

LogAxis::LogAxis(std::span<const double> values, bool with_zero, int least) : start_(with_zero ? 0.12 : 0) {
  double low = 0, high = 0;
  for (const double v : values) {
    if (!(v > 0) || !std::isfinite(v)) continue;
    low = low == 0 ? v : std::min(low, v);
    high = std::max(high, v);
  }
  if (low == 0) low = high = 1;
  low_ = static_cast<int>(std::floor(std::log10(low)));
  constexpr double room = 0.3;  // for what is written above the highest
  high_ = std::max(static_cast<int>(std::ceil(std::log10(high) + room)), low_ + least);
}

double LogAxis::place(double value) const {
  if (!(value > 0)) return 0;
  return start_ + (1 - start_) * (std::log10(value) - low_) / (high_ - low_);
}

std::vector<Tick> LogAxis::ticks() const {
  std::vector<Tick> out;
  if (start_ > 0) out.push_back({0, "0"});
  const int step = high_ - low_ > 8 ? 2 : 1;
  for (int e = low_; e <= high_; ++e) {
    out.push_back({place(std::pow(10.0, e)), (e - low_) % step == 0 ? power_of_ten(e) : ""});
  }
  return out;
}

}  // namespace sightline::comparison
