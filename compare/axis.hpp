// A logarithmic axis with a place for zero. For this folder's own use.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sightline::comparison {

struct Tick {
  double at;         // along the axis, 0 to 1
  std::string text;  // empty: a line without a number
};

/// Whole powers of ten around the values; zeros lie on a line of their own at 0, below a gap.
class LogAxis {
 public:
  /// `least`: at least this many powers of ten.
  LogAxis(std::span<const double> values, bool with_zero, int least);
  /// 0 to 1.
  double place(double value) const;
  std::vector<Tick> ticks() const;

 private:
  int low_ = 0, high_ = 1;  // exponents
  double start_ = 0;        // where the powers begin
};

}  // namespace sightline::comparison
