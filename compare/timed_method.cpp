#include "compare/method.hpp"

#include <algorithm>
#include <array>
#include <ctime>
#include <stdexcept>

namespace sightline::comparison {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

Measured TimedMethod::view(const Camera& camera, double) {
  Measured out;
  try {
    approach(camera);
    const auto timed = [&] {
      const double start = thread_seconds();
      look(camera);
      return thread_seconds() - start;
    };
    out.seconds = timed();
    tell(out.answer);
    if (out.seconds < 0.2) {
      std::array<double, 3> times{timed(), timed(), timed()};
      std::ranges::sort(times);
      out.seconds = times[1];
    }
  } catch (const std::exception& error) {
    out = {};
    out.why = error.what();
  }
  return out;
}

}  // namespace sightline::comparison
