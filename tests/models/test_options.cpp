// Seeds, rotated copies, and what is refused.
#include "models/model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>

namespace sightline {
namespace {

/// FNV-1a over everything that a model holds.
std::uint64_t fingerprint(const Model& model) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t word) {
    for (int k = 0; k < 8; ++k) hash = (hash ^ (word >> (8 * k) & 0xff)) * 0x100000001b3u;
  };
  const auto add_vector = [&](const glm::dvec3& v) {
    for (int k = 0; k < 3; ++k) add(std::bit_cast<std::uint64_t>(v[k] + 0.0));
  };
  for (const glm::dvec3& v : model.soup.vertices) add_vector(v);
  for (const std::uint32_t i : model.soup.corners) add(i);
  for (const std::uint32_t i : model.soup.first) add(i);
  for (const std::uint32_t i : model.soup.object_of) add(i);
  for (const std::string& name : model.soup.objects) {
    for (const char c : name) add(static_cast<unsigned char>(c));
  }
  for (const CameraLine& camera : model.cameras) {
    add_vector(camera.eye);
    add_vector(camera.forward);
    add_vector(camera.up);
  }
  return hash;
}

TEST(ModelOptions, SameSeedSameModel) {
  for (const std::string& name : model_names()) {
    EXPECT_EQ(fingerprint(make_model(name)), fingerprint(make_model(name))) << name;
  }
}

/// The models are the same to the last bit wherever they are made. Whoever changes a generator writes the new number
/// here.
TEST(ModelOptions, SameModelOnEveryPlatform) {
  const std::map<std::string, std::uint64_t> expected{
      {"rooms", 0x71728cd938e6ec34u}, {"maze", 0xf48d3ca688128c17u},   {"arena", 0xc8c0d063e8d7b9b6u},
      {"city", 0x01b3e3adbf4eee25u},  {"floor", 0x0603ce6ebef175e2u},  {"building", 0xce6398ef53c29c2bu},
      {"tower", 0x0832b128e427cef2u}, {"campus", 0x3099d3939d0211fbu}, {"random", 0x85f09213236d592eu}};
  for (const std::string& name : model_names()) {
    EXPECT_EQ(fingerprint(make_model(name)), expected.at(name)) << name;
  }
}

TEST(ModelOptions, AnotherSeedAnotherModel) {
  for (const char* name : {"maze", "city", "floor", "building", "campus", "random"}) {
    EXPECT_NE(fingerprint(make_model(name)), fingerprint(make_model(name, {.seed = 2}))) << name;
  }
}

/// Law 6.
TEST(ModelOptions, RotatedCopiesKeepLengthsAndPolygons) {
  const auto length = [](const glm::dvec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); };
  for (const std::string& name : model_names()) {
    const Model plain = make_model(name), turned = make_model(name, {.rotate_degrees = 33});
    EXPECT_EQ(plain.soup.corners, turned.soup.corners) << name;
    EXPECT_EQ(plain.soup.first, turned.soup.first) << name;
    EXPECT_EQ(plain.soup.object_of, turned.soup.object_of) << name;
    const auto& before = plain.soup.vertices;
    const auto& after = turned.soup.vertices;
    ASSERT_EQ(before.size(), after.size());
    bool moved = false;
    for (std::size_t k = 0; k < before.size(); ++k) {
      const std::size_t other = (k * 7 + 3) % before.size();
      EXPECT_NEAR(length(before[k] - before[other]), length(after[k] - after[other]), 1e-12 * (1 + length(before[k])));
      // The axis stays where it is.
      const auto along_axis = [](const glm::dvec3& v) { return v.x + 2 * v.y + 3 * v.z; };
      EXPECT_NEAR(along_axis(before[k]), along_axis(after[k]), 1e-11 * (1 + length(before[k])));
      moved = moved || before[k] != after[k];
    }
    EXPECT_TRUE(moved);
    for (std::size_t k = 0; k < plain.cameras.size(); ++k) {
      EXPECT_NEAR(length(plain.cameras[k].eye - before[0]), length(turned.cameras[k].eye - after[0]), 1e-10);
      EXPECT_NEAR(length(plain.cameras[k].forward), length(turned.cameras[k].forward), 1e-14);
      EXPECT_NEAR(length(plain.cameras[k].forward - plain.cameras[k].up),
                  length(turned.cameras[k].forward - turned.cameras[k].up), 1e-14);
    }
  }
}

TEST(ModelOptions, RefusalsNameTheModel) {
  const auto message = [](const std::string& name, const ModelOptions& options) -> std::string {
    try {
      make_model(name, options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("palace", {}).find("palace"), std::string::npos);
  EXPECT_NE(message("", {}), "");
  for (const char* name : {"rooms", "arena", "tower", "campus"}) {
    EXPECT_NE(message(name, {.polygons = 12345}).find(name), std::string::npos);
  }
  for (const char* name : {"maze", "city", "floor", "building"}) {
    EXPECT_NE(message(name, {.polygons = 5}).find(name), std::string::npos);
  }
  for (const char* name : {"maze", "city", "floor", "building", "random"}) {
    EXPECT_NE(message(name, {.polygons = 4'000'000'000u}).find(name), std::string::npos);
  }
  EXPECT_NE(message("maze", {.rotate_degrees = std::numeric_limits<double>::infinity()}).find("maze"),
            std::string::npos);
}

}  // namespace
}  // namespace sightline
