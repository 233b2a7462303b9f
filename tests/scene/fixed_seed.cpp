// The same random cases at every run, unless RC_PARAMS asks for others.
#include <cstdlib>

namespace {

[[maybe_unused]] const int seeded = ::setenv("RC_PARAMS", "seed=20240229", 0);

}  // namespace
