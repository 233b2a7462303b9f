#include "compare/axis.hpp"

#include <algorithm>
#include <cmath>

namespace sightline::comparison {

LogAxis::LogAxis(std::span<const double> values, bool with_zero, int least) : start_(with_zero ? 0.12 : 0) {
  double low = 0, high = 0;
  for (const double v : values) {
    if (!(v > 0) || !std::isfinite(v)) continue;
    low = low == 0 ? v : std::min(low, v);
    high = std::max(high, v);
  }
  if (low == 0) low = high = 1;
  low_ = static_cast<int>(std::floor(std::log10(low)));
  high_ = std::max(static_cast<int>(std::ceil(std::log10(high))), low_ + least);
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
    const bool named = (e - low_) % step == 0;
    out.push_back({place(std::pow(10.0, e)),
                   named
                       ? (e >= -2 && e <= 3 ? (e >= 0 ? "1" + std::string(static_cast<std::size_t>(e), '0')
                                                      : "0." + std::string(static_cast<std::size_t>(-e - 1), '0') + "1")
                                            : "1e" + std::to_string(e))
                       : ""});
  }
  return out;
}

}  // namespace sightline::comparison
