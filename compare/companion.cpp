#include "compare/companion.hpp"

#include <unistd.h>

#include <stdexcept>

namespace sightline::comparison {

std::filesystem::path companion(const std::string& program) {
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& folder : {here, here.parent_path() / SIGHTLINE_LIBEXEC / "sightline"}) {
    if (access((folder / program).c_str(), X_OK) == 0) return folder / program;
  }
  throw std::runtime_error(program + " is neither in " + here.string() + " nor in " + SIGHTLINE_LIBEXEC +
                           "/sightline of the installation");
}

}  // namespace sightline::comparison
