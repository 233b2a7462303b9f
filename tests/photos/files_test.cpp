// Images, OBJ and MTL out and in again.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "photos/pack.hpp"
#include "photos/textured.hpp"
#include "scene/readers.hpp"
#include "tests/photos/shots.hpp"

namespace sightline::testing {
namespace {

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (auto& pixel : image.pixels) {
    for (auto& channel : pixel) channel = static_cast<std::uint8_t>(random());
  }
  return image;
}

TEST(Png, ReadsWhatItWrites) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(64, 100), std::pair(501, 2)}) {
    const Image image = noise(width, height, static_cast<unsigned>(width));
    EXPECT_EQ(parse_png(png(image), "x"), image);
  }
  EXPECT_THROW(png(Image(0, 5)), std::invalid_argument);
  EXPECT_THROW(png(Image(1, 32768)), std::invalid_argument);
}

TEST(Png, EveryShortenedFileIsRefusedInOneLine) {
  const std::string bytes = png(noise(20, 10, 1));
  const auto expect_refused = [](const std::string& text) {
    try {
      parse_png(text, "photo.png");
      ADD_FAILURE() << "read";
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with("photo.png: no whole PNG image: ") && what.find('\n') == std::string::npos) << what;
    }
  };
  for (std::size_t length = 0; length + 12 < bytes.size(); length += 7) expect_refused(bytes.substr(0, length));
  std::string changed = bytes;
  changed[bytes.size() / 2] = static_cast<char>(changed[bytes.size() / 2] ^ 1);  // a checksum notices
  expect_refused(changed);
  expect_refused("JFIF and so on");
  EXPECT_THROW(read_png("no such file.png"), InputError);
}

std::string from_hex(const std::string& digits) {
  std::string bytes;
  for (std::size_t k = 0; k < digits.size(); k += 2) {
    bytes += static_cast<char>(std::stoi(digits.substr(k, 2), nullptr, 16));
  }
  return bytes;
}

/// Files of 2 x 1 pixels, of other kinds than are written here.
TEST(Png, OtherKindsAreReadTransparencyIsRefused) {
  const Image grey = parse_png(from_hex(  // 16 bits: 0x1234 and 0xabcd
                                   "89504e470d0a1a0a0000000d494844520000000200000001100000000081d9fc150000000d"
                                   "4944415478da631032597d1600030c01bfb1e7d44d0000000049454e44ae426082"),
                               "x");
  EXPECT_EQ(grey.pixels, (std::vector<std::array<std::uint8_t, 3>>{{0x12, 0x12, 0x12}, {0xab, 0xab, 0xab}}));
  const Image opaque = parse_png(from_hex(  // with an alpha channel of 255
                                     "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a00000011"
                                     "4944415478da63e01291fbaf6164f31f00094102d1696760540000000049454e44ae426082"),
                                 "x");
  EXPECT_EQ(opaque.pixels, (std::vector<std::array<std::uint8_t, 3>>{{10, 20, 30}, {40, 50, 60}}));
  try {
    parse_png(from_hex(  // the second pixel's alpha is 200
                  "89504e470d0a1a0a0000000d4948445200000002000000010806000000f4227f8a00000011"
                  "4944415478da63e01291fbaf6164730200090a029ac3f861da0000000049454e44ae426082"),
              "a.png");
    ADD_FAILURE() << "read";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()), "a.png: the image is transparent in places");
  }
}

TEST(Photo, MustHaveTheCamerasAspect) {
  const Camera camera = make_camera({0, 0, 0}, {1, 0.3, 0}, {0, 0, 1}, 50, 1.5);
  for (const auto& [width, height] :
       {std::pair(150, 100), std::pair(151, 100), std::pair(3, 2), std::pair(1501, 1000)}) {
    EXPECT_NO_THROW(check_aspect(Image(width, height), camera, "0001.png")) << width;
  }
  for (const auto& [width, height] : {std::pair(100, 150), std::pair(160, 100), std::pair(1500, 1010)}) {
    try {
      check_aspect(Image(width, height), camera, "0001.png");
      ADD_FAILURE() << width << " x " << height;
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()), "0001.png: " + std::to_string(width) + " x " + std::to_string(height) +
                                               " pixels do not fit the camera's aspect of 1.5");
    }
  }
}

TEST(Pack, RectanglesDoNotOverlap) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<PackedRectangle> rectangles;
    for (int k = 0; k < 200; ++k) {
      rectangles.push_back(
          {1 + static_cast<int>(random() % (round % 2 ? 60u : 9u)), 1 + static_cast<int>(random() % 60)});
    }
    const std::vector<PageSize> pages = pack(rectangles, 64 + 20 * round);
    std::vector<std::vector<char>> taken;
    double area = 0, of_pages = 0;
    for (const PageSize& p : pages) {
      EXPECT_TRUE(p.width <= 64 + 20 * round && p.height <= 64 + 20 * round);
      taken.emplace_back(static_cast<std::size_t>(p.width * p.height), 0);
      of_pages += p.width * p.height;
    }
    for (const PackedRectangle& r : rectangles) {
      ASSERT_LT(r.page, pages.size());
      const PageSize& p = pages[r.page];
      ASSERT_TRUE(r.x >= 0 && r.y >= 0 && r.x + r.width <= p.width && r.y + r.height <= p.height);
      area += r.width * r.height;
      for (int j = r.y; j < r.y + r.height; ++j) {
        for (int i = r.x; i < r.x + r.width; ++i) {
          char& pixel = taken[r.page][static_cast<std::size_t>(j * p.width + i)];
          EXPECT_EQ(pixel, 0);
          pixel = 1;
        }
      }
    }
    EXPECT_GT(area, 0.5 * of_pages);  // and do not waste the pages
  }
  EXPECT_TRUE(pack({}, 100).empty());
}

TEST(TexturedObj, ReadsBackWithPiecesPlacesAndMaterials) {
  const Shots shots = model_shots("rooms", 0, 20, 4);
  PhotoOptions options;
  options.page = 200;
  const PhotoTextures textures = map_photos(shots.scene, shots.clipped, shots.photographs(80, 60, 1), options);
  ASSERT_GT(textures.pages.size(), 1u);
  const std::string obj = textured_obj(shots.scene, shots.clipped, textures, "out.mtl");

  const PolygonSoup soup = read_obj("out.obj", obj);
  ASSERT_EQ(soup.first.size(), shots.clipped.pieces.size() + 1);
  std::vector<glm::dvec2> places;
  std::vector<std::string> materials;  // of faces
  std::vector<std::vector<std::size_t>> place_of;
  std::istringstream lines(obj);
  std::string material, library;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "mtllib") words >> library;
    if (word == "usemtl") words >> material;
    if (word == "vt") {
      glm::dvec2& at = places.emplace_back();
      words >> at.x >> at.y;
    }
    if (word != "f") continue;
    materials.push_back(material);
    place_of.emplace_back();
    while (words >> word) place_of.back().push_back(std::stoul(word.substr(word.find('/') + 1)) - 1);
  }
  EXPECT_EQ(library, "out.mtl");
  for (std::size_t k = 0; k < shots.clipped.pieces.size(); ++k) {
    const ClipPiece& piece = shots.clipped.pieces[k];
    const PieceTexture& t = textures.pieces[k];
    EXPECT_EQ(soup.objects[soup.object_of[k]], "polygon_" + std::to_string(piece.polygon));
    EXPECT_EQ(materials[k], "page_" + std::to_string(t.page));
    ASSERT_EQ(soup.first[k + 1] - soup.first[k], piece.corner_count);
    ASSERT_EQ(place_of[k].size(), piece.corner_count);
    const bool flipped = shots.scene.surfaces()[piece.surface].flipped;
    for (std::uint32_t i = 0; i < piece.corner_count; ++i) {
      const std::uint32_t c = piece.first_corner + (flipped ? piece.corner_count - 1 - i : i);
      const auto& at = shots.clipped.corners[c].at;
      EXPECT_EQ(soup.vertices[soup.corners[soup.first[k] + i]], glm::dvec3(at[0], at[1], at[2]));
      const glm::dvec2 place = places[place_of[k][i]];
      const Image& page = textures.pages[t.page];
      EXPECT_NEAR(place.x * page.width, textures.places[c].x, 1e-6);
      EXPECT_NEAR((1 - place.y) * page.height, textures.places[c].y, 1e-6);
    }
  }
  const std::string images[] = {"out-0.png", "out-1.png"};
  EXPECT_EQ(textured_mtl(images),
            "newmtl page_0\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd out-0.png\n"
            "newmtl page_1\nKa 0 0 0\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd out-1.png\n");
}

}  // namespace
}  // namespace sightline::testing
