// What is in each pixel: the renderer's areas, and the pixels that show one polygon alone.
#include <gtest/gtest.h>

#include "tests/photos/shots.hpp"
#include "visibility_map/locate.hpp"

namespace sightline::testing {
namespace {

constexpr int width = 96, height = 72;

std::size_t index(int i, int j) { return static_cast<std::size_t>(j * width + i); }

TEST(Render, AreasOfFacesAndPixelsAddUp) {
  const Shots shots = model_shots("maze", 0, 20, 4);
  for (const VisibilityMap& map : shots.maps) {
    std::vector<double> of_pixel(width * height, 0), of_face(map.faces.size(), 0);
    visit_parts(map, width, height, [&](const FacePart& part) {
      EXPECT_TRUE(part.area > 0 && part.area <= 1);
      EXPECT_TRUE(std::abs(part.centre.x - part.i - 0.5) <= 0.5 && std::abs(part.centre.y - part.j - 0.5) <= 0.5);
      of_pixel[index(part.i, part.j)] += part.area;
      of_face[part.face] += part.area / (width * height);
    });
    for (const double area : of_pixel) EXPECT_NEAR(area, 1, 1e-9);
    for (std::size_t f = 0; f < map.faces.size(); ++f) EXPECT_NEAR(of_face[f], map.faces[f].area, 1e-9);
  }
}

/// A square of the wall y = 10 from x = 0 on to the right, seen by a camera that looks along y: left of it is sky.
Shots half_a_wall(double from) {
  PolygonSoup soup;
  soup.vertices = {{from, 10, -20}, {20, 10, -20}, {20, 10, 20}, {from, 10, 20}};
  soup.corners = {0, 1, 2, 3};
  soup.first = {0, 4};
  return {make_scene(std::move(soup)), {Camera{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}};
}

TEST(Render, MixesByArea) {
  // The window is 10 wide at the wall: with 10 pixels the wall's border lies at 5 + from pixels.
  for (const double from : {0.25, 0.5, 0.875}) {
    const Shots shots = half_a_wall(from);
    const auto white = [](PolygonId, const glm::dvec3&) { return glm::dvec3(255); };
    const Image image = render(shots.maps[0], shots.scene, 10, 10, white, {0, 55, 0});
    EXPECT_EQ(image.at(4, 3), (std::array<std::uint8_t, 3>{0, 55, 0}));
    EXPECT_EQ(image.at(5, 3), stored(glm::dvec3(255, 255, 255) * (1 - from) + glm::dvec3(0, 55, 0) * from));
    EXPECT_EQ(image.at(6, 3), (std::array<std::uint8_t, 3>{255, 255, 255}));
  }
}

TEST(Render, ShadesPointsOfThePolygonWhereTheyAreSeen) {
  const Shots shots = model_shots("rooms", 0, 9, 3);
  for (std::size_t c = 0; c < shots.cameras.size(); ++c) {
    const PhotoFrame frame(shots.scene, shots.cameras[c], width, height);
    render(shots.maps[c], shots.scene, width, height, [&](PolygonId p, const glm::dvec3& x) {
      const ApproxPlane& plane = shots.scene.planes().approx(shots.scene.surfaces(p)[0].plane);
      const glm::dvec3 unit = shots.scene.grid().unit(x);
      EXPECT_NEAR(plane.n[0] * unit.x + plane.n[1] * unit.y + plane.n[2] * unit.z, plane.d, 1e-12);
      const auto place = frame.place(x);
      EXPECT_TRUE(place && place->x >= 0 && place->x <= width && place->y >= 0 && place->y <= height);
      return glm::dvec3(0);
    });
  }
}

TEST(PixelOwners, WithAGuardPixelsShowTheirOwnerAlone) {
  for (const Shots& shots : {model_shots("maze", 3, 20, 4), model_shots("tower", 0, 8, 3)}) {
    std::size_t owned = 0, mixed = 0;
    for (const VisibilityMap& map : shots.maps) {
      const PixelOwners owners = pixel_owners(map, shots.scene, width, height, 1);
      std::vector<int> parts(width * height, 0);
      visit_parts(map, width, height, [&](const FacePart& part) {
        ++parts[index(part.i, part.j)];
        const PolygonId owner = owners.at(part.i, part.j);
        if (owner == none) return;
        ++owned;
        EXPECT_EQ(map.faces[part.face].polygon, owner);
        EXPECT_NEAR(part.area, 1, 1e-9);
      });
      for (const int count : parts) mixed += count > 1;
      EXPECT_EQ(owners.at(-1, 0), none);
      EXPECT_EQ(owners.at(0, height), none);
    }
    EXPECT_GT(owned, 1000u);
    EXPECT_GT(mixed, 100u);
  }
}

TEST(PixelOwners, WithoutAGuardTheCentreDecides) {
  const Shots shots = model_shots("maze", 5, 30, 3);
  for (const VisibilityMap& map : shots.maps) {
    const PixelOwners owners = pixel_owners(map, shots.scene, width, height, 0);
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        const MapPlace place = locate(map, shots.scene, {(i + 0.5) / width, 1 - (j + 0.5) / height});
        EXPECT_EQ(owners.at(i, j), place.kind == MapPlace::face ? map.faces[place.index].polygon : none);
      }
    }
  }
}

TEST(PixelOwners, AWiderGuardKeepsFurtherOffSilhouettesOnly) {
  const Shots shots = model_shots("rooms", 0, 9, 6);
  for (const VisibilityMap& map : shots.maps) {
    const PixelOwners one = pixel_owners(map, shots.scene, width, height, 1);
    // The pixels that silhouettes touch: by an independent, slow look at each edge.
    std::vector<char> touched(width * height, 0);
    for (const MapEdge& edge : map.edges) {
      if (edge.kind != EdgeKind::silhouette) continue;
      const glm::dvec2 size(width, height), a = map.vertices[edge.vertex[0]].st * size,
                                            b = map.vertices[edge.vertex[1]].st * size;
      for (int k = 0; k <= 4000; ++k) {
        const glm::dvec2 p = a + (b - a) * (k / 4000.0);
        const int i = std::clamp(static_cast<int>(p.x), 0, width - 1);
        const int j = std::clamp(static_cast<int>(height - p.y), 0, height - 1);
        touched[index(i, j)] = 1;
      }
    }
    for (const int guard : {2, 3, 5, 200}) {
      const PixelOwners more = pixel_owners(map, shots.scene, width, height, guard);
      for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
          bool near = false;  // surely
          for (int b = std::max(0, j - guard + 1); b <= std::min(height - 1, j + guard - 1); ++b) {
            for (int a = std::max(0, i - guard + 1); a <= std::min(width - 1, i + guard - 1); ++a) {
              near = near || touched[index(a, b)];
            }
          }
          if (near) {
            EXPECT_EQ(more.at(i, j), none) << i << " " << j << " guard " << guard;
          }
          if (more.at(i, j) != none) {
            EXPECT_EQ(more.at(i, j), one.at(i, j));
          }
        }
      }
    }
    const PixelOwners wide = pixel_owners(map, shots.scene, width, height, 3);
    std::size_t lost = 0, kept = 0;
    for (std::size_t k = 0; k < one.polygon.size(); ++k) {
      kept += wide.polygon[k] != none;
      lost += one.polygon[k] != none && wide.polygon[k] == none;
    }
    EXPECT_GT(kept, 1000u);
    EXPECT_LT(lost, 2500u);
  }
}

TEST(PixelOwners, RegionsAndBadNumbers) {
  const Shots shots = half_a_wall(-20);
  const TextureRegion left{true, {{0, 0}, {0.45, 0}, {0.45, 1}, {0, 1}}};
  const TextureRegion tip{false, {{0.15, 0.5}, {0.35, 0.25}, {0.35, 0.75}}};
  const TextureRegion both[] = {left, tip};
  const PixelOwners owners = pixel_owners(shots.maps[0], shots.scene, 10, 10, 1, both);
  const char* const expected[] = {"xxxx......", "xxxx......", "xxx.......", "xx........", "x.........",
                                  "x.........", "xx........", "xxx.......", "xxxx......", "xxxx......"};
  for (int j = 0; j < 10; ++j) {
    std::string row;
    for (int i = 0; i < 10; ++i) row += owners.at(i, j) == 0 ? 'x' : '.';
    EXPECT_EQ(row, expected[j]) << j;
  }
  EXPECT_THROW(pixel_owners(shots.maps[0], shots.scene, 0, 10, 1), std::invalid_argument);
  EXPECT_THROW(pixel_owners(shots.maps[0], shots.scene, 10, 40000, 1), std::invalid_argument);
  EXPECT_THROW(pixel_owners(shots.maps[0], shots.scene, 10, 10, -1), std::invalid_argument);
  EXPECT_THROW(render(shots.maps[0], shots.scene, 10, 0, Pattern::at), std::invalid_argument);
}

}  // namespace
}  // namespace sightline::testing
