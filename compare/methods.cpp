// Which methods there are.
#include "compare/method.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace sightline::comparison {

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"front-to-back", false, make_front_to_back},
      {"cells", false, make_cells},
      {"hybrid", false, make_hybrid},
      {"double", false, make_double},
      {"rays", true, make_rays},
      {"ids", true, make_ids},
  };
  return all;
}

namespace {

std::string known_names() {
  std::string names;
  for (const Kind& k : kinds()) names += (names.empty() ? "" : ", ") + k.name + (k.sized ? ":N" : "");
  return names;
}

MethodName parse(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto kind = std::ranges::find(kinds(), text.substr(0, colon), &Kind::name);
  if (kind == kinds().end()) throw std::invalid_argument("'" + text + "': no such method (" + known_names() + ")");
  unsigned size = 0;
  if (kind->sized) {
    const std::string digits = colon == std::string::npos ? "" : text.substr(colon + 1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), size);
    if (error != std::errc() || end != digits.data() + digits.size() || size < 1 || size > 16384) {
      throw std::invalid_argument("'" + text + "': " + kind->name + ":N wants a number of pixels from 1 to 16384");
    }
  } else if (colon != std::string::npos) {
    throw std::invalid_argument("'" + text + "': " + kind->name + " takes no number");
  }
  return {text, &*kind, size};
}

}  // namespace

std::vector<MethodName> parse_methods(const std::string& list) {
  std::vector<MethodName> methods;
  std::istringstream names(list + ",");
  for (std::string name; std::getline(names, name, ',');) {
    if (std::ranges::find(methods, name, &MethodName::text) != methods.end()) {
      throw std::invalid_argument("'" + name + "' stands there twice");
    }
    methods.push_back(parse(name));
  }
  return methods;
}

}  // namespace sightline::comparison
