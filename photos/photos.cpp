#include "photos/photos.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

#include "photos/pack.hpp"
#include "photos/tile.hpp"

namespace sightline {

namespace {

using Source = PieceTexture::Source;

/// What has been found out about a piece.
struct Choice {
  Source source = Source::hidden;
  std::uint32_t camera = none;
  Image texture;      // with padding; one texel of it where the colour is uniform
  glm::dvec3 sum{0};  // of usable colours, and how many: of the texture, or of all photographs where none has enough
  std::size_t count = 0;
  std::size_t direct = 0, borrowed = 0, continued = 0;
};

Image texture_of(const Tile& tile) {
  Image image(tile.full_width(), tile.full_height());
  std::ranges::transform(tile.colour, image.pixels.begin(), stored);
  return image;
}

/// One texel of a colour, with padding.
Image one_texel(const glm::dvec3& colour) { return {1 + 2 * texture_padding, 1 + 2 * texture_padding, stored(colour)}; }

Choice choose(const Scene& scene, const ClipResult& clipped, const ClipPiece& piece,
              std::span<const Photograph> photographs, const PhotoOptions& options) {
  const auto named = std::span(clipped.cameras).subspan(piece.first_camera, piece.camera_count + piece.partly_count);
  Choice choice;
  if (named.empty()) return choice;
  struct Candidate {
    bool partly;
    double area;
    std::uint32_t camera;
  };
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < named.size(); ++k) {
    candidates.push_back({k >= piece.camera_count, pixels(clipped, piece, photographs[named[k]].frame()), named[k]});
  }
  std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
    return a.partly != b.partly ? b.partly : a.area > b.area;
  });
  const PieceFrame frame(scene, clipped, piece);
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const std::uint32_t camera = candidates[k].camera;
    Tile tile = make_tile(frame, piece, photographs[camera], options);
    if (tile.enough()) {
      continue_colours(tile);
      return {k == 0 ? Source::best : Source::next, camera,      texture_of(tile), tile.sum,
              tile.direct + tile.borrowed,          tile.direct, tile.borrowed,    tile.bare};
    }
    choice.sum += tile.sum;
    choice.count += tile.direct + tile.borrowed;
  }
  choice.source = choice.count > 0 ? Source::uniform : Source::unknown;
  return choice;
}

/// Gives pieces without a texture their colour: their own mean, their polygon's, or the stated one.
void colour_the_rest(const ClipResult& clipped, const PhotoOptions& options, std::vector<Choice>& choices) {
  std::map<PolygonId, std::pair<glm::dvec3, std::size_t>> polygons;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    auto& [sum, count] = polygons.try_emplace(clipped.pieces[k].polygon, glm::dvec3(0), 0).first->second;
    sum += choices[k].sum;
    count += choices[k].count;
  }
  const glm::dvec3 unseen(options.unseen[0], options.unseen[1], options.unseen[2]);
  for (std::size_t k = 0; k < choices.size(); ++k) {
    Choice& choice = choices[k];
    if (choice.source == Source::uniform) {
      choice.texture = one_texel(choice.sum / static_cast<double>(choice.count));
    } else if (choice.source == Source::unknown) {
      const auto& [sum, count] = polygons[clipped.pieces[k].polygon];
      if (count > 0) choice.source = Source::polygon;
      choice.texture = one_texel(count > 0 ? sum / static_cast<double>(count) : unseen);
    } else if (choice.source == Source::hidden) {
      choice.texture = one_texel(unseen);
    }
  }
}

void draw(const Image& texture, const PackedRectangle& place, Image& page) {
  for (int j = 0; j < texture.height; ++j) {
    for (int i = 0; i < texture.width; ++i) page.at(place.x + i, place.y + j) = texture.at(i, j);
  }
}

/// Puts all textures on pages, those of one colour once.
void lay_out(const Scene& scene, const ClipResult& clipped, const PhotoOptions& options,
             const std::vector<Choice>& choices, PhotoTextures& result) {
  std::map<std::array<std::uint8_t, 3>, std::size_t> of_colour;
  std::vector<PackedRectangle> rectangles;
  std::vector<std::size_t> rectangle_of, choice_of;
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const Image& texture = choices[k].texture;
    rectangle_of.push_back(rectangles.size());
    if (choices[k].camera == none) {
      const auto [entry, is_new] = of_colour.try_emplace(texture.pixels[0], rectangles.size());
      rectangle_of.back() = entry->second;
      if (!is_new) continue;
    }
    rectangles.push_back({texture.width, texture.height});
    choice_of.push_back(k);
  }
  for (const PageSize& size : pack(rectangles, options.page)) {
    result.pages.emplace_back(size.width, size.height, options.unseen);
  }
  for (std::size_t r = 0; r < rectangles.size(); ++r) {
    draw(choices[choice_of[r]].texture, rectangles[r], result.pages[rectangles[r].page]);
  }
  for (std::size_t k = 0; k < choices.size(); ++k) {
    const Choice& choice = choices[k];
    const ClipPiece& piece = clipped.pieces[k];
    const PackedRectangle& r = rectangles[rectangle_of[k]];
    const PieceTexture t{choice.source,
                         choice.camera,
                         r.page,
                         r.x + texture_padding,
                         r.y + texture_padding,
                         r.width - 2 * texture_padding,
                         r.height - 2 * texture_padding};
    result.pieces.push_back(t);
    const PieceFrame frame(scene, clipped, piece);
    for (const glm::dvec2& corner : frame.corner) {
      const bool flat = choice.camera == none;  // of one colour
      const auto along = [&](double at, double size, int texels) {
        return flat || !(size > 0) ? texels / 2.0 : std::clamp(at / size, 0.0, 1.0) * texels;
      };
      result.places.emplace_back(t.x + along(corner.x, frame.size.x, t.width),
                                 t.y + along(corner.y, frame.size.y, t.height));
    }
    ++result.stats.pieces[choice.source];
    result.stats.direct += choice.direct;
    result.stats.borrowed += choice.borrowed;
    result.stats.continued += choice.continued;
  }
}

}  // namespace

PhotoTextures map_photos(const Scene& scene, const ClipResult& clipped, std::span<const Photograph> photographs,
                         const PhotoOptions& options) {
  if (options.reach < 0 || !(options.density > 0) || !std::isfinite(options.density) || options.page < 16 ||
      options.page > 32767) {
    throw std::invalid_argument("reach, density or page of textures out of range");
  }
  if (std::ranges::any_of(clipped.cameras, [&](std::uint32_t c) { return c >= photographs.size(); })) {
    throw std::invalid_argument("not every camera has a photograph");
  }
  const auto start = std::chrono::steady_clock::now();
  std::vector<Choice> choices(clipped.pieces.size());
  tbb::task_arena arena(static_cast<int>(std::max(1u, options.threads)));
  arena.execute([&] {
    tbb::parallel_for(std::size_t{0}, choices.size(), [&](std::size_t k) {
      choices[k] = choose(scene, clipped, clipped.pieces[k], photographs, options);
    });
  });
  colour_the_rest(clipped, options, choices);
  PhotoTextures result;
  lay_out(scene, clipped, options, choices, result);
  result.stats.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

}  // namespace sightline
