#include "tests/stress/judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>

#include "beam/trace.hpp"
#include "bsp/build.hpp"
#include "clip/hybrid.hpp"
#include "exact/tally.hpp"
#include "tests/oracle/exact_map.hpp"
#include "tests/oracle/judging.hpp"
#include "verify/verify.hpp"
#include "visibility_map/write.hpp"
#include "winged_pair/check.hpp"

namespace sightline::stress {
namespace {

/// What this program has done, printed in one line at its end.
class Counts : public ::testing::Environment {
 public:
  std::uint64_t scenes = 0, maps = 0, faces = 0, by_verifier = 0, by_cells = 0, by_hybrid = 0, by_oracle = 0,
                faults = 0;
  double slowest = 0;  // of the fastest engine, a camera
  std::string slowest_case;

  std::string program() const {
    const std::string path = ::testing::internal::GetArgvs().front();
    return std::filesystem::path(path).filename().string();
  }
  void TearDown() override {
    const Tally tally = tally_total();
    std::ostringstream line;
    line << program() << ": " << scenes << " scenes, " << maps << " maps, " << faces << " faces, " << faults
         << " faults; judged by the verifier " << by_verifier << ", by the engines cells " << by_cells << " and hybrid "
         << by_hybrid << ", by the oracle " << by_oracle << "; decided by identity " << tally.identity << ", filter "
         << tally.filter << ", exact";
    for (std::size_t k = 0; k < tally.exact.size(); ++k) {
      if (tally.exact[k] == 0) continue;
      line << " " << (Tally::widths[k] == 0 ? std::string("longer") : std::to_string(Tally::widths[k])) << ": "
           << tally.exact[k];
    }
    line << "; slowest map " << slowest << " s (" << slowest_case << ")\n";
    std::cout << line.str();
  }
};

Counts& counts() {
  // Owned by GoogleTest.
  static Counts* const all = static_cast<Counts*>(::testing::AddGlobalTestEnvironment(new Counts));
  return *all;
}
[[maybe_unused]] const Counts& registered_before_main = counts();

verify::Soup plain(const PolygonSoup& soup) {
  verify::Soup out;
  for (const glm::dvec3& v : soup.vertices) out.vertices.push_back({v.x, v.y, v.z});
  out.first = soup.first;
  out.corners = soup.corners;
  return out;
}

verify::Options options_of(const SceneOptions& options) {
  verify::Options out;
  if (!options.snap.empty()) out.snap = options.snap;
  out.one_sided = options.one_sided;
  return out;
}

}  // namespace

std::uint64_t times(std::uint64_t usual) {
  const char* wanted = std::getenv("SIGHTLINE_STRESS");
  if (wanted == nullptr) return usual;
  char* end = nullptr;
  const std::uint64_t factor = std::strtoull(wanted, &end, 10);
  if (end == wanted || *end != 0 || factor < 1 || factor > 1000000) {
    throw std::runtime_error("SIGHTLINE_STRESS is to be a number from 1 to 1000000");
  }
  return usual * factor;
}

struct Court::State {
  Case sample;
  Judges judges;
  Scene scene;
  std::optional<Complex> complex;
  std::optional<BspTree> tree;
  std::optional<Tracer> cells, front_to_back;
  std::optional<HybridTracer> hybrid;
  verify::Verifier verifier;
  std::string what = "the scene";
  std::uint64_t maps = 0;
  VisibilityMap map, other;

  State(const PolygonSoup& soup, const SceneOptions& options, const Judges& who)
      : sample{soup, options, {}},
        judges(who),
        scene(make_scene(soup, options)),
        verifier(plain(soup), options_of(options)) {
    // Which side of a polygon that crosses itself is its front is not defined.
    if (options.one_sided && scene.report().self_crossing > 0) judges.oracle = false;
    tree.emplace(scene, TreeOptions{counts().scenes % 2 == 0});
    front_to_back.emplace(*tree);
    if (judges.hybrid) hybrid.emplace(scene);
    if (judges.complex) {
      complex = build(scene);
      cells.emplace(scene, *complex);
    }
  }

  /// What is wrong with the map, a line each.
  std::string judged() {
    std::string all;
    TraceStats stats;
    front_to_back->trace(sample.camera, map, &stats);
    if (stats.seconds > counts().slowest) {
      counts().slowest = stats.seconds;
      counts().slowest_case = what;
    }
    const std::string json = map_json(map, scene);
    if (cells) {
      ++counts().by_cells;
      cells->trace(sample.camera, other);
      if (map_json(other, scene) != json) all += "the engine cells gives another map\n";
    }
    if (hybrid) {
      ++counts().by_hybrid;
      hybrid->trace(sample.camera, other);
      if (map_json(other, scene) != json) all += "the engine hybrid gives another map\n";
    }
    if (sample.options.one_sided && scene.report().self_crossing > 0) return all;
    if (maps++ % judges.verifier == 0) {
      ++counts().by_verifier;
      const verify::Report report = verifier.check("map", json);
      for (const auto& [name, entry] : report.checks()) {
        for (const verify::Fault& f : entry.first) all += "verifier: " + name + ": " + f.item + ": " + f.what + "\n";
      }
    }
    if (judges.oracle) {
      ++counts().by_oracle;
      const auto lines = differences(oracle::oracle_map(scene, sample.camera), oracle::exact_map(scene, map));
      for (const std::string& line : lines) all += "oracle: " + line + "\n";
    }
    return all;
  }
};

Court::Court(const PolygonSoup& soup, const SceneOptions& options, const Judges& judges)
    : state_(std::make_unique<State>(soup, options, judges)) {
  ++counts().scenes;
  if (!state_->complex) return;
  for (const std::string& line : sightline::check(*state_->complex, state_->scene)) fault("complex: " + line);
}
Court::~Court() = default;

const Scene& Court::scene() const { return state_->scene; }

const VisibilityMap& Court::check(const Camera& camera, const std::string& what) {
  state_->sample.camera = camera;
  state_->what = what;
  state_->map = {};
  std::string wrong;
  try {
    wrong = state_->judged();
  } catch (const std::exception& error) {
    wrong = std::string("exception: ") + error.what() + "\n";
  }
  ++counts().maps;
  counts().faces += state_->map.faces.size();
  if (!wrong.empty()) fault(wrong);
  return state_->map;
}

void Court::fault(const std::string& what) {
  constexpr std::uint64_t most_files = 20;
  std::string file = "no file, there are enough";
  if (counts().faults < most_files) {
    file = counts().program() + "-" + std::to_string(counts().faults) + ".obj";
    oracle::write_case(file, state_->sample, state_->what + "\n" + what);
  }
  ++counts().faults;
  ADD_FAILURE() << state_->what << " (" << file << ")\n" << what;
}

void check(const Case& sample, const std::string& what, const Judges& judges) {
  Court(sample.soup, sample.options, judges).check(sample.camera, what);
}

Camera aimed(const glm::dvec3& eye, const glm::dvec3& target, double width) {
  glm::dvec3 forward = target - eye;
  const double size = std::max({std::abs(forward.x), std::abs(forward.y), std::abs(forward.z)});
  if (size == 0 || !std::isfinite(size)) {
    forward = {1, 2, -1};
  } else {  // by a power of two: nothing is rounded that does not underflow
    int exponent = 0;
    std::frexp(size, &exponent);
    for (int axis = 0; axis < 3; ++axis) forward[axis] = std::ldexp(forward[axis], -exponent);
  }
  const glm::dvec3 hint = std::abs(forward.z) > std::abs(forward.x) ? glm::dvec3{1, 0, 0} : glm::dvec3{0, 0, 1};
  const glm::dvec3 right = glm::cross(forward, hint), up = glm::cross(right, forward);
  return {eye, forward, right * width, up * (width / 2)};
}

}  // namespace sightline::stress
