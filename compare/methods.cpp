// Which methods there are.
#include "compare/method.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

namespace sightline::comparison {

namespace {

template <std::unique_ptr<Method> (*make)(const Scene&)>
MakeMethod plain(const std::string&) {
  return make;
}

template <std::unique_ptr<Method> (*make)(const Scene&, unsigned)>
MakeMethod of_pixels(const std::string& setting) {
  const auto size = setting_number(setting, 1, 16384);
  if (!size) throw std::invalid_argument("a number of pixels from 1 to 16384");
  return [size](const Scene& scene) { return make(scene, *size); };
}

}  // namespace

const std::vector<Kind>& kinds() {
  static const std::vector<Kind> all{
      {"front-to-back", "", plain<make_front_to_back>},
      {"cells", "", plain<make_cells>},
      {"hybrid", "", plain<make_hybrid>},
      {"double", "", plain<make_double>},
      {"rays", "N", of_pixels<make_rays>},
      {"ids", "N", of_pixels<make_ids>},
      {"field", "UxVxSxT:IDS", parse_field},
      {"bitfield", "N", parse_bitfield_method},
      {"bitfield-exact", "N", parse_exact_bitfield_method},
  };
  return all;
}

namespace {

std::string known_name(const Kind& kind) { return kind.name + (kind.form.empty() ? "" : ":" + kind.form); }

MethodName parse(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto kind = std::ranges::find(kinds(), text.substr(0, colon), &Kind::name);
  if (kind == kinds().end()) throw std::invalid_argument("'" + text + "': no such method (" + known_methods() + ")");
  if (kind->form.empty() && colon != std::string::npos) {
    throw std::invalid_argument("'" + text + "': " + kind->name + " takes no number");
  }
  try {
    return {text, &*kind, kind->parse(colon == std::string::npos ? "" : text.substr(colon + 1))};
  } catch (const std::invalid_argument& wanted) {
    throw std::invalid_argument("'" + text + "': " + known_name(*kind) + " wants " + wanted.what());
  }
}

}  // namespace

std::string known_methods() {
  std::string names;
  for (const Kind& k : kinds()) names += (names.empty() ? "" : ", ") + known_name(k);
  return names;
}

std::optional<unsigned> setting_number(std::string_view text, unsigned least, unsigned most) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < least || number > most) return {};
  return number;
}

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
