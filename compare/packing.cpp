#include "compare/packing.hpp"

#include <unistd.h>

#include <cstring>

namespace sightline::comparison {

void Unpacker::copy(void* to, std::size_t count) {
  if (count > bytes_.size()) throw std::runtime_error("half an answer");
  if (count > 0) std::memcpy(to, bytes_.data(), count);
  bytes_.remove_prefix(count);
}

std::string packed(const Measured& measured) {
  if (!measured.why.empty()) throw std::runtime_error(measured.why);
  const auto& drawing = std::get<Drawing>(measured.answer.shown);
  Packer out;
  out.put(measured.seconds);
  out.put(measured.answer.reported);
  out.put(drawing.corners);
  out.put(drawing.edges);
  out.put(drawing.polygons);
  return std::move(out.bytes);
}

Measured unpacked(std::string_view bytes) {
  Measured out;
  auto& drawing = out.answer.shown.emplace<Drawing>();
  Unpacker in(bytes);
  in.get(out.seconds);
  in.get(out.answer.reported);
  in.get(drawing.corners);
  in.get(drawing.edges);
  in.get(drawing.polygons);
  const auto bad = [](std::uint32_t index, const auto& list) { return index >= list.size(); };
  for (const Drawing::Edge& e : drawing.edges) {
    if (bad(e.from, drawing.corners) || bad(e.to, drawing.corners) ||
        (e.left != none && bad(e.left, drawing.polygons)) || (e.right != none && bad(e.right, drawing.polygons))) {
      throw std::runtime_error("an answer that names what is not there");
    }
  }
  return out;
}

std::string packed(const Scene& scene) {
  const PolygonSoup& soup = scene.soup();
  Packer out;
  out.put(scene.options().one_sided);
  out.put(std::vector<char>(scene.options().snap.begin(), scene.options().snap.end()));
  out.put(soup.vertices);
  out.put(soup.first);
  out.put(soup.corners);
  return std::move(out.bytes);
}

Scene unpacked_scene(std::string_view bytes) {
  SceneOptions options;
  PolygonSoup soup;
  std::vector<char> snap;
  Unpacker in(bytes);
  in.get(options.one_sided);
  in.get(snap);
  in.get(soup.vertices);
  in.get(soup.first);
  in.get(soup.corners);
  options.snap.assign(snap.begin(), snap.end());
  return make_scene(std::move(soup), options);
}

bool send(int pipe, std::string_view message) {
  const std::uint64_t size = message.size();
  std::string all(reinterpret_cast<const char*>(&size), sizeof size);
  all += message;
  for (std::size_t sent = 0; sent < all.size();) {
    const ssize_t written = write(pipe, all.data() + sent, all.size() - sent);
    if (written <= 0) return false;
    sent += static_cast<std::size_t>(written);
  }
  return true;
}

namespace {

bool read_all(int pipe, char* to, std::size_t count) {
  while (count > 0) {
    const ssize_t got = read(pipe, to, count);
    if (got <= 0) return false;
    to += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

}  // namespace

bool receive(int pipe, std::string& message) {
  std::uint64_t size = 0;
  if (!read_all(pipe, reinterpret_cast<char*>(&size), sizeof size)) return false;
  message.resize(size);
  return read_all(pipe, message.data(), size);
}

}  // namespace sightline::comparison
