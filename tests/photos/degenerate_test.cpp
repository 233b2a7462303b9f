// Scenes in which nothing is in general position, photographed in flat colours: whatever is textured has its polygon's
// colour and no other. SIGHTLINE_CASES=n makes n cases instead of the usual few, SIGHTLINE_FIRST=k begins with seed k.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/clip/shots.hpp"
#include "tests/photos/shots.hpp"

namespace sightline::testing {
namespace {

std::uint64_t setting(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : usual;
}

TEST(DegeneratePhotos, HaveTheirPolygonsColours) {
  const std::uint64_t first = setting("SIGHTLINE_FIRST", 0), count = setting("SIGHTLINE_CASES", 60);
  std::array<std::uint64_t, 6> pieces{};
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    SCOPED_TRACE(seed);
    Shot shot = degenerate(seed);
    ClipOptions options;
    options.threshold = seed % 3 == 0 ? 0.5 : 0;  // some pieces are seen in part
    const Shots shots(std::move(shot.scene), std::move(shot.cameras), options);
    const int guard = 1 + static_cast<int>(seed % 2);
    std::vector<Photograph> photographs;
    for (std::size_t c = 0; c < shots.cameras.size(); ++c) {
      const auto flat = [](PolygonId p, const glm::dvec3&) { return Pattern::base(p); };
      photographs.emplace_back(shots.scene, shots.cameras[c],
                               render(shots.maps[c], shots.scene, 48, 36, flat, {9, 9, 9}),
                               pixel_owners(shots.maps[c], shots.scene, 48, 36, guard));
    }
    PhotoOptions photo_options;
    photo_options.reach = guard + 1;
    const PhotoTextures textures = map_photos(shots.scene, shots.clipped, photographs, photo_options);
    for (std::size_t k = 0; k < textures.pieces.size(); ++k) {
      const PieceTexture& t = textures.pieces[k];
      ++pieces[t.source];
      const bool known = t.source <= PieceTexture::polygon;
      const auto own = stored(known ? Pattern::base(shots.clipped.pieces[k].polygon) : glm::dvec3(128));
      std::size_t wrong = 0;
      for (int j = -texture_padding; j < t.height + texture_padding; ++j) {
        for (int i = -texture_padding; i < t.width + texture_padding; ++i) {
          wrong += textures.pages[t.page].at(t.x + i, t.y + j) != own;
        }
      }
      EXPECT_EQ(wrong, 0u) << "piece " << k << " of " << t.width << " x " << t.height << " texels";
    }
  }
  if (count < 60) return;
  EXPECT_GT(pieces[PieceTexture::best], 100u);
  EXPECT_GT(pieces[PieceTexture::polygon], 0u);
}

}  // namespace
}  // namespace sightline::testing
