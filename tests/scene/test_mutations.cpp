// Thousands of damaged files: each is read, or refused by one clear line. Nothing else may happen.
#include "binary_files.hpp"
#include "scene/read.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

namespace sightline::test {
namespace {

struct Original {
  const char* name;
  std::string content;
};

std::vector<Original> originals() {
  return {{"a.obj",
           "# made by hand\no table\nv 0 0 0\nv 1.5 0 0 1\nv 1.5 1e0 0\nv 0 1 0.25 1 0.5 0\nvn 0 0 1\nvt 0 0\n"
           "f 1/1/1 2//1 3/1 \\\n 4\nf -4 -3 -2\ng leg\nf 1 2 3 4 2\nusemtl wood\nf 4 3 2 1\nl 1 2\n"},
          {"b.ply",
           "ply\nformat ascii 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\n"
           "property uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
           "0 0 0 255\n1 0 0 255\n1 1 0.5 0\n0 1 0 7\n4 0 1 2 3\n3 0 1 2\n"},
          {"c.ply", binary_ply(false)},
          {"d.ply", binary_ply(true)},
          {"e.off", "OFF\n# a square\n4 2 0\n0 0 0\n1 0 0\n1 1 0.1\n0 1 0\n4 0 1 2 3 255 0 0\n3 0 1 2\n"},
          {"f.stl",
           "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0.5\nendloop\nendfacet\n"
           "facet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 1 0 1\nvertex 0 1 1\nendloop\nendfacet\nendsolid a\n"},
          {"g.stl", binary_stl()},
          {"h.cameras", "# one\n0.5 0.5 2  0 0.1 -1  0 1 0  60 1.5\n0 0 1  1 0 0  0 0 1  90 1\n"}};
}

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : random_(seed) {}

  std::string mutated(std::string text) {
    for (std::size_t times = 1 + below(2); times > 0; --times) mutate(text);
    return text;
  }

 private:
  std::size_t below(std::size_t n) { return n == 0 ? 0 : random_() % n; }

  void mutate(std::string& text) {
    static const std::array<std::string, 20> pieces{"nan",
                                                    "inf",
                                                    "-1",
                                                    "0",
                                                    "1e999",
                                                    "1e-999",
                                                    "1e300",
                                                    "4294967295",
                                                    "4294967296",
                                                    "18446744073709551616",
                                                    "-9223372036854775808",
                                                    "\\\n",
                                                    "\\",
                                                    "\n",
                                                    "#",
                                                    "\r",
                                                    "f 1 2 3\n",
                                                    "v 1 2\n",
                                                    "/",
                                                    std::string(1, '\0')};
    const std::size_t at = below(text.size() + 1), length = std::min(below(12), text.size() - at);
    switch (below(8)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(random_());
        break;
      case 1:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 2:
        text.insert(at, 1, static_cast<char>(random_()));
        break;
      case 3:
        text.erase(at, length);
        break;
      case 4:
        text.insert(at, text.substr(below(text.size()), below(40)));
        break;
      case 5:
        text.resize(at);
        break;
      case 6:
        text.replace(at, length, pieces[below(pieces.size())]);
        break;
      default: {  // a whole number
        const std::size_t first = text.find_first_of("0123456789", at);
        if (first == std::string::npos) break;
        const std::size_t last = std::min(text.find_first_not_of("0123456789", first), text.size());
        text.replace(first, last - first, pieces[below(pieces.size())]);
      }
    }
  }

  std::mt19937 random_;
};

/// A scene whose every part can be asked for.
void expect_sound(const Scene& scene) {
  std::size_t edges = 0;
  for (PolygonId p = 0; p < scene.polygon_count(); ++p) {
    for (const Surface& s : scene.surfaces(p)) {
      EXPECT_EQ(s.polygon, p);
      EXPECT_GE(s.edge_count, 3u);
      EXPECT_LT(s.plane, scene.planes().size());
      edges += scene.edges(s).size();
    }
  }
  EXPECT_EQ(edges, scene.all_edges().size());
  for (const SurfaceEdge& e : scene.all_edges()) {
    EXPECT_LT(e.wall, scene.planes().size());
    EXPECT_NE(e.inside, 0);
  }
}

TEST(Mutations, AreReadOrRefusedByOneLine) {
  const TemporaryFolder folder;
  const std::vector<Original> all = originals();
  for (const Original& o : all) {
    const auto file = folder.write(o.name, o.content);
    if (file.extension() == ".cameras") {
      EXPECT_NO_THROW(read_cameras(file));
    } else {
      EXPECT_NO_THROW(expect_sound(make_scene(read_polygons(file))));
    }
  }
  Mutator mutator(20240229);
  int refused = 0;
  constexpr int times = 10000;
  for (int k = 0; k < times; ++k) {
    const Original& original = all[static_cast<std::size_t>(k) % all.size()];
    const std::string content = mutator.mutated(original.content);
    const auto file = folder.write(original.name, content);
    try {
      if (file.extension() == ".cameras") {
        read_cameras(file);
      } else {
        expect_sound(make_scene(read_polygons(file)));
      }
    } catch (const InputError& e) {
      ++refused;
      const std::string message = e.what();
      EXPECT_TRUE(message.starts_with(file.string() + ":")) << message;
      EXPECT_LT(message.size(), file.string().size() + 150) << message;
      EXPECT_TRUE(std::all_of(message.begin(), message.end(), [](char c) { return c >= ' ' && c <= '~'; })) << message;
    } catch (const std::exception& e) {
      ADD_FAILURE() << original.name << " " << k << ": " << e.what();
    }
  }
  EXPECT_GT(refused, times / 10);
  EXPECT_LT(refused, times * 95 / 100);
}

/// Files of nothing but random bytes, of every length.
TEST(Mutations, GarbageIsRefused) {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl", "a.cameras"}) {
    for (std::size_t length = 0; length < 300; length += 3) {
      std::string bytes(length, '\0');
      std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<char>(random()); });
      const auto file = folder.write(name, bytes);
      if (file.extension() == ".cameras") {
        EXPECT_THROW(read_cameras(file), InputError);
      } else {
        EXPECT_THROW(read_polygons(file), InputError);
      }
    }
  }
}

/// Every prefix of a binary or counted file lacks something.
TEST(Mutations, TruncatedFilesAreRefused) {
  const TemporaryFolder folder;
  for (const Original& o : originals()) {
    const std::string name = o.name;
    if (name == "a.obj" || name == "h.cameras") continue;  // a part of these may well be a file
    const std::size_t whole = o.content.find_last_not_of("\n") + 1;
    for (std::size_t length = 0; length < whole; ++length) {
      // What ends within the last number or name, or in a colour behind the last polygon, cannot be told from a file.
      if (name == "f.stl" && length >= whole - 2) continue;
      const auto file = folder.write(name, o.content.substr(0, length));
      EXPECT_THROW(read_polygons(file), InputError) << name << " " << length << " of " << whole;
    }
  }
}

}  // namespace
}  // namespace sightline::test
