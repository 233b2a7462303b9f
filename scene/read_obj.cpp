#include "scene/readers.hpp"
#include "scene/text_scanner.hpp"

#include <unordered_map>

namespace sightline {
namespace {

class ObjReader {
 public:
  ObjReader(const std::string& file, std::string_view text)
      : file_(file), in_(file, text, {.comments = true, .continuations = true}) {
    soup_.vertices.reserve(text.size() / 48);
    soup_.corners.reserve(text.size() / 24);
    soup_.first.reserve(text.size() / 96);
  }

  PolygonSoup read() {
    for (; in_.find_token(); in_.next_line()) {
      const std::string_view keyword = in_.token();
      if (keyword == "v") {
        vertex();
      } else if (keyword == "f") {
        face();
      } else if (keyword == "o" || keyword == "g") {
        name(in_.rest_of_line());
      }
    }
    for (const Forward& f : forward_) {
      if (f.index >= soup_.vertices.size()) {
        fail_input(file_, f.line, {"polygon", f.polygon}, out_of_range(static_cast<std::int64_t>(f.index) + 1));
      }
    }
    if (soup_.objects.empty()) soup_.object_of.clear();
    return std::move(soup_);
  }

 private:
  struct Forward {  // an index of a vertex that had not come yet
    std::size_t line, polygon;
    std::uint64_t index;
  };

  std::string out_of_range(std::int64_t written) const {
    return "vertex " + std::to_string(written) + " is out of range, the file has " +
           std::to_string(soup_.vertices.size());
  }

  void vertex() {
    const Item item{"vertex", soup_.vertices.size()};
    if (item.index >= none) in_.fail(item, "is one too many");
    glm::dvec3 v;
    v.x = in_.number(item, "x");
    v.y = in_.number(item, "y");
    v.z = in_.number(item, "z");
    while (!in_.at_line_end()) in_.skip_number(item);  // a weight, or a colour
    soup_.vertices.push_back(v);
  }

  void face() {
    const Item item{"polygon", soup_.first.size() - 1};
    while (!in_.at_line_end()) {
      const std::int64_t written = in_.integer(item, "vertex", '/');
      for (int part = 0; part < 2 && in_.take('/'); ++part) {  // texture and normal, either may be left out
        if (!in_.at_token_end() && !(part == 0 && in_.next_is('/'))) in_.integer(item, "index", part == 0 ? '/' : '\0');
      }
      const auto count = static_cast<std::int64_t>(soup_.vertices.size());
      if (written == 0) in_.fail(item, "vertex 0 is out of range, they are numbered from 1");
      const std::int64_t index = written > 0 ? written - 1 : written >= -count ? count + written : -1;
      if (index < 0 || index >= none) in_.fail(item, out_of_range(written));
      if (index >= count) forward_.push_back({in_.line(), item.index, static_cast<std::uint64_t>(index)});
      soup_.corners.push_back(static_cast<std::uint32_t>(index));
    }
    if (soup_.corners.size() >= none) in_.fail(item, "is one too many");
    if (soup_.corners.size() < soup_.first.back() + std::size_t{3}) in_.fail(item, "has fewer than 3 vertices");
    soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.object_of.push_back(object_);
  }

  void name(std::string_view text) {
    object_ = none;
    if (text.empty()) return;
    const auto [entry, is_new] = names_.try_emplace(std::string(text), static_cast<std::uint32_t>(names_.size()));
    if (is_new) soup_.objects.emplace_back(text);
    object_ = entry->second;
  }

  const std::string& file_;
  TextScanner in_;
  PolygonSoup soup_;
  std::vector<Forward> forward_;
  std::unordered_map<std::string, std::uint32_t> names_;
  std::uint32_t object_ = none;
};

}  // namespace

PolygonSoup read_obj(const std::string& file, std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark
  return ObjReader(file, text).read();
}

}  // namespace sightline
