// Textures from photographs: every texel against the pattern of its own polygon.
#include "photos/textured.hpp"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numeric>

#include "photos/tile.hpp"
#include "tests/photos/shots.hpp"

namespace sightline::testing {
namespace {

/// How far from a place's point the points may lie whose colours are in a sample there: of pixels whose centres are up
/// to `reach` pixels away in x and y, or of the next ones for a direct sample, half a pixel more for their own extent.
/// Nothing where the plane is not in view all over there.
std::optional<double> farthest(const PhotoFrame& frame, SurfaceId surface, const glm::dvec3& point, double reach) {
  const auto place = frame.place(point);
  if (!place) return {};
  double distance = 0;
  for (const glm::dvec2& d : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    const auto corner = frame.on_plane(surface, *place + (reach + 0.5) * d);
    if (!corner) return {};
    distance = std::max(distance, glm::distance(*corner, point));
  }
  return distance;
}

struct Wrong {
  std::size_t looked_at = 0, count = 0;
  double largest = 0;  // difference beyond what resampling may do
};

/// Compares every texel within the pieces that have a texture with the pattern of the piece's own polygon.
Wrong wrong_texels(const Shots& shots, std::span<const Photograph> photographs, const PhotoTextures& textures,
                   int reach) {
  Wrong wrong;
  for (std::size_t k = 0; k < textures.pieces.size(); ++k) {
    const PieceTexture& t = textures.pieces[k];
    const ClipPiece& piece = shots.clipped.pieces[k];
    const PieceFrame frame(shots.scene, shots.clipped, piece);
    for (int j = 0; j < t.height; ++j) {
      for (int i = 0; i < t.width && t.camera != none; ++i) {
        const glm::dvec2 at(frame.size.x * (i + 0.5) / t.width, frame.size.y * (j + 0.5) / t.height);
        if (!frame.holds(at)) continue;
        const glm::dvec3 point = frame.point(at);
        const PhotoFrame& photo = photographs[t.camera].frame();
        const auto place = photo.place(point);
        const PhotoSample sample = place ? photographs[t.camera].sample(piece.polygon, *place, reach) : PhotoSample{};
        const auto distance = farthest(photo, piece.surface, point, sample.kind == PhotoSample::direct ? 1 : reach + 1);
        const bool bounded = sample.kind != PhotoSample::nothing && distance;
        // Two roundings to whole numbers, of the photograph and of the texture.
        const double allowed = 1 + (bounded ? Pattern::change(*distance) : 2 * Pattern::amplitude);
        const double off =
            difference(textures.pages[t.page].colour(t.x + i, t.y + j), Pattern::at(piece.polygon, point)) - allowed;
        ++wrong.looked_at;
        wrong.count += off > 0;
        wrong.largest = std::max(wrong.largest, off);
      }
    }
  }
  return wrong;
}

PhotoTextures textures_of(const Shots& shots, std::span<const Photograph> photographs, int guard) {
  PhotoOptions options;
  options.reach = guard + 1;
  return map_photos(shots.scene, shots.clipped, photographs, options);
}

TEST(PhotoTextures, WithTheGuardEveryTexelIsItsPolygonsWithoutItSomeAreNot) {
  for (const Shots& shots : {model_shots("rooms", 0, 9, 8), model_shots("tower", 0, 6, 4)}) {
    for (const int guard : {1, 3}) {
      const auto photographs = shots.photographs(160, 120, guard);
      const PhotoTextures textures = textures_of(shots, photographs, guard);
      const Wrong wrong = wrong_texels(shots, photographs, textures, guard + 1);
      EXPECT_GT(wrong.looked_at, 5000u);
      EXPECT_EQ(wrong.count, 0u) << "of " << wrong.looked_at << ", by up to " << wrong.largest;
      EXPECT_GT(textures.stats.borrowed, 0u);
      EXPECT_GT(textures.stats.direct, 2 * textures.stats.borrowed);
    }
    const auto photographs = shots.photographs(160, 120, 0);
    const Wrong wrong = wrong_texels(shots, photographs, textures_of(shots, photographs, 0), 1);
    EXPECT_GT(wrong.count, 50u) << "of " << wrong.looked_at;
    EXPECT_GT(wrong.largest, 20);
  }
}

/// Where a piece has no texture its colour is its polygon's own all the same, or the stated one.
TEST(PhotoTextures, OneColourIsThePolygonsOwn) {
  const Shots shots = model_shots("tower", 0, 4, 6);
  const auto photographs = shots.photographs(80, 60, 2);
  const PhotoTextures textures = textures_of(shots, photographs, 2);
  std::array<std::uint64_t, 6> pieces{};
  for (std::size_t k = 0; k < textures.pieces.size(); ++k) {
    const PieceTexture& t = textures.pieces[k];
    ++pieces[t.source];
    EXPECT_EQ(t.camera == none, t.source > PieceTexture::next);
    EXPECT_EQ(t.source == PieceTexture::hidden, shots.clipped.pieces[k].camera_count == 0);
    if (t.camera != none) continue;
    EXPECT_EQ(t.width * t.height, 1);
    const glm::dvec3 colour = textures.pages[t.page].colour(t.x, t.y);
    if (t.source == PieceTexture::unknown || t.source == PieceTexture::hidden) {
      EXPECT_EQ(colour, glm::dvec3(128));
    } else {
      EXPECT_LE(difference(colour, Pattern::base(shots.clipped.pieces[k].polygon)), Pattern::amplitude + 1);
    }
  }
  EXPECT_EQ(pieces, textures.stats.pieces);
  for (const PieceTexture::Source source : {PieceTexture::best, PieceTexture::next, PieceTexture::uniform,
                                            PieceTexture::polygon, PieceTexture::unknown, PieceTexture::hidden}) {
    EXPECT_GT(pieces[source], 0u) << source;
  }
}

TEST(PhotoTextures, CamerasAreTriedByTheAreaTheySeeAndByWhatTheyMayUse) {
  // A square wall, seen by a far camera and by a near one.
  PolygonSoup soup;
  soup.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
  soup.corners = {0, 1, 2, 3};
  soup.first = {0, 4};
  const Camera far{{0, -8, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, near{{0, -4, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  const Shots shots(make_scene(std::move(soup)), {far, near});
  ASSERT_EQ(shots.clipped.pieces.size(), 1u);
  const std::array<std::uint8_t, 3> red{200, 0, 0}, blue{0, 0, 200};
  const auto texture = [&](int far_owned, int near_owned) {  // so many of 32 rows may be used
    std::vector<Photograph> photographs;
    for (std::size_t c = 0; c < 2; ++c) {
      PixelOwners owners{32, 32, std::vector<PolygonId>(32 * 32, none)};
      const int rows = c == 0 ? far_owned : near_owned;
      std::fill(owners.polygon.begin(), owners.polygon.begin() + 32 * rows, 0u);
      photographs.emplace_back(shots.scene, shots.cameras[c], Image(32, 32, c == 0 ? red : blue), owners);
    }
    return map_photos(shots.scene, shots.clipped, photographs, {});
  };
  const auto expect = [&](const PhotoTextures& textures, PieceTexture::Source source, std::uint32_t camera,
                          std::array<std::uint8_t, 3> colour) {
    const PieceTexture& t = textures.pieces[0];
    EXPECT_EQ(t.source, source);
    EXPECT_EQ(t.camera, camera);
    for (int j = -texture_padding; j < t.height + texture_padding; ++j) {
      for (int i = -texture_padding; i < t.width + texture_padding; ++i) {
        EXPECT_EQ(textures.pages[t.page].at(t.x + i, t.y + j), colour) << i << " " << j;
      }
    }
  };
  // Of the 32 rows the near camera sees the wall in those from 8 to 24, the far one from 12 to 20.
  expect(texture(32, 32), PieceTexture::best, 1, blue);
  expect(texture(32, 17), PieceTexture::best, 1, blue);
  expect(texture(32, 14), PieceTexture::next, 0, red);
  expect(texture(16, 12), PieceTexture::next, 0, red);
  const auto both = texture(14, 14);
  EXPECT_EQ(both.pieces[0].source, PieceTexture::uniform);
  const auto mixed = both.pages[0].at(both.pieces[0].x, both.pieces[0].y);
  EXPECT_TRUE(mixed[0] > 0 && mixed[2] > 0 && mixed[0] + mixed[2] == 200 && mixed[1] == 0);
  expect(texture(13, 6), PieceTexture::uniform, none, red);
  expect(texture(5, 5), PieceTexture::unknown, none, {128, 128, 128});
}

TEST(PhotoTextures, PiecesHaveTexelsOfTheirOwnAndThreadsChangeNothing) {
  const Shots shots = model_shots("rooms", 3, 12, 6);
  const auto photographs = shots.photographs(120, 90, 1);
  PhotoOptions options;
  options.page = 256;
  const PhotoTextures textures = map_photos(shots.scene, shots.clipped, photographs, options);
  EXPECT_GT(textures.pages.size(), 1u);
  std::vector<std::vector<std::uint32_t>> taken;
  for (const Image& page : textures.pages) {
    EXPECT_TRUE(page.width <= 256 && page.height <= 256);
    taken.emplace_back(page.pixels.size(), none);
  }
  for (std::uint32_t k = 0; k < textures.pieces.size(); ++k) {
    const PieceTexture& t = textures.pieces[k];
    const Image& page = textures.pages[t.page];
    const ClipPiece& piece = shots.clipped.pieces[k];
    for (std::uint32_t c = piece.first_corner; c < piece.first_corner + piece.corner_count; ++c) {
      const glm::dvec2& at = textures.places[c];
      EXPECT_TRUE(at.x >= t.x && at.y >= t.y && at.x <= t.x + t.width && at.y <= t.y + t.height);
    }
    ASSERT_TRUE(t.x >= texture_padding && t.x + t.width + texture_padding <= page.width);
    ASSERT_TRUE(t.y >= texture_padding && t.y + t.height + texture_padding <= page.height);
    if (t.camera == none) continue;
    for (int j = t.y - texture_padding; j < t.y + t.height + texture_padding; ++j) {
      for (int i = t.x - texture_padding; i < t.x + t.width + texture_padding; ++i) {
        std::uint32_t& owner = taken[t.page][static_cast<std::size_t>(j * page.width + i)];
        ASSERT_EQ(owner, none) << "pieces " << owner << " and " << k;
        owner = k;
      }
    }
  }
  options.threads = 3;
  const PhotoTextures again = map_photos(shots.scene, shots.clipped, photographs, options);
  EXPECT_EQ(again.pages, textures.pages);
  EXPECT_EQ(again.places, textures.places);
}

/// Bilinear look-ups all over the pieces, their corners and sides included, find nothing of another polygon.
TEST(PhotoTextures, LookUpsDoNotBleed) {
  const Shots shots = model_shots("rooms", 0, 12, 6);
  const auto photographs = shots.photographs(160, 120, 1);
  const PhotoTextures textures = textures_of(shots, photographs, 1);
  const TextureLookup lookup(shots.scene, shots.clipped, textures);
  std::size_t looked_at = 0;
  for (std::uint32_t k = 0; k < textures.pieces.size(); ++k) {
    const ClipPiece& piece = shots.clipped.pieces[k];
    if (textures.pieces[k].source > PieceTexture::polygon) continue;
    const PieceFrame frame(shots.scene, shots.clipped, piece);
    for (std::size_t a = 0; a < frame.corner.size(); ++a) {
      for (std::size_t b = 0; b < frame.corner.size(); ++b) {
        for (const double part : {0.0, 0.01, 0.4}) {
          const glm::dvec3 point = frame.point(frame.corner[a] + part * (frame.corner[b] - frame.corner[a]));
          const glm::dvec3 colour = lookup.colour(textures.pieces[k].page, lookup.place(k, point));
          EXPECT_LE(difference(colour, Pattern::base(piece.polygon)), Pattern::amplitude + 1);
          ++looked_at;
        }
      }
      // Corners are where their `places` say.
      const glm::dvec2 place = lookup.place(k, frame.point(frame.corner[a]));
      EXPECT_LE(glm::distance(place, textures.places[piece.first_corner + a]), 1e-6);
    }
    const glm::dvec3 centre = frame.point(frame.centre());
    const std::uint32_t found = lookup.piece_at(piece.polygon, centre);
    EXPECT_TRUE(found == k || frame.size.x < 1e-6 || frame.size.y < 1e-6);
  }
  EXPECT_GT(looked_at, 1000u);
}

/// Figure 1 of Funkhouser 1999: through a doorway a photograph shows a room behind. Mapped without a guard, the far
/// room gets pixels that are partly of the wall with the door; from aside they are a line on the far room's walls.
TEST(PhotoTextures, TheLineOfTheDoorFrameIsGoneWithTheGuard) {
  PolygonSoup soup;
  const auto wall = [&](std::initializer_list<glm::dvec3> corners) {
    for (const glm::dvec3& c : corners) {
      soup.corners.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(c);
    }
    soup.first.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  };
  wall({{-4, 4, 0}, {-1, 4, 0}, {-1, 4, 3}, {-4, 4, 3}});  // left of the doorway
  wall({{1, 4, 0}, {4, 4, 0}, {4, 4, 3}, {1, 4, 3}});      // right of it
  wall({{-4, 8, 0}, {4, 8, 0}, {4, 8, 3}, {-4, 8, 3}});    // the far wall
  wall({{-4, 0, 0}, {4, 0, 0}, {4, 8, 0}, {-4, 8, 0}});    // floor
  wall({{-4, 0, 3}, {4, 0, 3}, {4, 8, 3}, {-4, 8, 3}});    // ceiling
  constexpr PolygonId left = 0, right = 1;
  const auto paint = [](PolygonId p, const glm::dvec3&) {
    return p == left || p == right ? glm::dvec3(250, 220, 0) : glm::dvec3(60 + 20.0 * p, 80, 140);
  };
  // The doorway's right side is seen in six tenths of a pixel, whose centre shows the far room.
  const Camera camera = make_camera({0.088, 0.3, 1.6}, {0, 1, 0}, {0, 0, 1}, 60, 4.0 / 3);
  const Shots shots(make_scene(std::move(soup)), {camera});
  const Camera aside = make_camera({-0.9, 3, 1.5}, {0.5, 1, 0}, {0, 0, 1}, 60, 4.0 / 3);
  const VisibilityMap seen = shots.map(aside);
  constexpr int width = 160, height = 120;
  const auto wrong_behind = [&](int guard) {
    std::vector<Photograph> photographs;
    photographs.emplace_back(shots.scene, camera, render(shots.maps[0], shots.scene, width, height, paint),
                             pixel_owners(shots.maps[0], shots.scene, width, height, guard));
    const PhotoTextures textures = textures_of(shots, photographs, guard);
    const TextureLookup lookup(shots.scene, shots.clipped, textures);
    const Image image =
        render(seen, shots.scene, width, height, [&](PolygonId p, const glm::dvec3& x) { return lookup.at(p, x); });
    // Only the stated grey and the far room's own colours, and mixtures of a colour and the grey, belong into pixels
    // that show one polygon of the far room alone.
    const PixelOwners owners = pixel_owners(seen, shots.scene, image.width, image.height, 1);
    std::size_t count = 0;
    for (int j = 0; j < image.height; ++j) {
      for (int i = 0; i < image.width; ++i) {
        const PolygonId p = owners.at(i, j);
        if (p == none || p == left || p == right) continue;
        const glm::dvec3 own = paint(p, {}), off = image.colour(i, j) - own, grey = glm::dvec3(128) - own;
        const double share = std::clamp(glm::dot(off, grey) / glm::dot(grey, grey), 0.0, 1.0);
        count += difference(off, share * grey) > 10;
      }
    }
    return count;
  };
  EXPECT_GT(wrong_behind(0), 50u);
  EXPECT_EQ(wrong_behind(1), 0u);
  EXPECT_EQ(wrong_behind(2), 0u);
}

TEST(PhotoTextures, RefusesWhatDoesNotFit) {
  const Shots shots = model_shots("rooms", 0, 50, 2);
  auto photographs = shots.photographs(40, 30, 1);
  PhotoOptions options;
  options.page = 8;
  EXPECT_THROW(map_photos(shots.scene, shots.clipped, photographs, options), std::invalid_argument);
  options = {};
  options.density = 0;
  EXPECT_THROW(map_photos(shots.scene, shots.clipped, photographs, options), std::invalid_argument);
  photographs.pop_back();
  EXPECT_THROW(map_photos(shots.scene, shots.clipped, photographs, {}), std::invalid_argument);
  EXPECT_THROW(Photograph(shots.scene, shots.cameras[0], Image(40, 31), photographs[0].owners()),
               std::invalid_argument);
}

}  // namespace
}  // namespace sightline::testing
