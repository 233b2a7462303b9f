// Whole runs: the same bytes however they are made, reports, failing cameras.
#include "tests/app/command.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace sightline::test {
namespace {

using Json = nlohmann::json;

/// A folder with m.obj, m.cameras (all), c.cameras (the first n) and m.wp.
std::filesystem::path folder_with_model(const std::string& test, const std::string& model, int cameras) {
  const auto folder = fresh_folder(test);
  EXPECT_EQ(run(folder, {"model", model, "-o", "m.obj"}).code, 0);
  EXPECT_EQ(run(folder, {"build", "m.obj", "-o", "m.wp"}).code, 0);
  write(folder / "c.cameras", first_lines(read(folder / "m.cameras"), cameras));
  return folder;
}

TEST(Trace, SameBytesAtAnyNumberOfThreadsAndFromEitherFile) {
  const auto folder = folder_with_model("same", "city", 6);
  const auto maps = [&](const std::string& name, const std::string& input, const std::string& threads) {
    const Ended ended = run(folder, {"trace", input, "--cameras", "c.cameras", "-o", name, "--threads", threads, "-q",
                                     "--format", "map,svg,png,csv"});
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_EQ(ended.out, "");
    return files_below(folder / name);
  };
  const auto one = maps("one", "m.wp", "1");
  EXPECT_EQ(one.size(), 3u * 6 + 1);
  EXPECT_TRUE(one.contains("0000.map.json") && one.contains("0005.svg") && one.contains("0003.png") &&
              one.contains("visibility.csv"));
  EXPECT_EQ(one, maps("two", "m.wp", "2"));
  EXPECT_EQ(one, maps("scene", "m.obj", "2"));
}

TEST(Trace, ModelsAndComplexesAreTheSameEachTime) {
  const auto folder = folder_with_model("again", "rooms", 1);
  const std::string obj = read(folder / "m.obj"), cameras = read(folder / "m.cameras"), wp = read(folder / "m.wp");
  ASSERT_EQ(run(folder, {"model", "rooms", "-o", "m.obj"}).code, 0);
  ASSERT_EQ(run(folder, {"build", "m.obj", "-o", "m.wp", "--threads", "2"}).code, 0);
  EXPECT_TRUE(read(folder / "m.obj") == obj && read(folder / "m.cameras") == cameras && read(folder / "m.wp") == wp);
}

TEST(Trace, FormatsAreThoseAskedFor) {
  const auto folder = folder_with_model("formats", "rooms", 2);
  const auto names = [&](const std::string& formats) {
    std::vector<std::string> arguments{"trace", "m.wp", "--cameras", "c.cameras", "-o", "maps"};
    if (!formats.empty()) arguments.insert(arguments.end(), {"--format", formats});
    std::filesystem::remove_all(folder / "maps");
    EXPECT_EQ(run(folder, arguments).code, 0);
    std::string all;
    for (const auto& [name, text] : files_below(folder / "maps")) all += name + " ";
    return all;
  };
  EXPECT_EQ(names(""), "0000.map.json 0001.map.json ");
  EXPECT_EQ(names("csv"), "visibility.csv ");
  EXPECT_EQ(names("pdf,png"), "0000.pdf 0000.png 0001.pdf 0001.png ");
  EXPECT_EQ(names("svg,map"), "0000.map.json 0000.svg 0001.map.json 0001.svg ");
}

TEST(Trace, CsvHasOneHeader) {
  const auto folder = folder_with_model("csv", "rooms", 3);
  ASSERT_EQ(run(folder, {"trace", "m.wp", "--cameras", "c.cameras", "-o", "maps", "--format", "csv"}).code, 0);
  const std::string csv = read(folder / "maps" / "visibility.csv");
  EXPECT_TRUE(csv.starts_with("camera,polygon,status,area,fraction\n0,"));
  EXPECT_EQ(csv.find("camera", 1), std::string::npos);
  EXPECT_LT(csv.find("\n1,"), csv.find("\n2,"));
}

TEST(Trace, ReportHasTheContractsKeys) {
  const auto folder = folder_with_model("report", "rooms", 2);
  const Ended ended = run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "maps", "--threads", "1",
                                   "--report", "r.json", "--json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, read(folder / "r.json"));
  const Json report = Json::parse(ended.out);
  EXPECT_EQ(report.at("command"), "trace");
  EXPECT_EQ(report.at("threads"), 1);
  EXPECT_EQ(report.at("engine"), "front-to-back");
  EXPECT_TRUE(report.at("version").is_string());
  EXPECT_GT(report.at("peak_bytes").get<double>(), 1e6);
  for (const char* key : {"polygons", "vertices", "dropped", "nonplanar", "bits"}) {
    EXPECT_TRUE(report.at("scene").at(key).is_number()) << key;
  }
  EXPECT_EQ(report["scene"]["polygons"], 20);
  for (const char* key : {"seconds", "cells", "bytes"}) EXPECT_GT(report.at("complex").at(key).get<double>(), 0) << key;
  for (const char* key : {"faces", "edges", "vertices", "pairs"}) EXPECT_EQ(report.at("complex").at(key), 0) << key;
  ASSERT_EQ(report.at("cameras").size(), 2u);
  for (int k = 0; k < 2; ++k) {
    const Json& camera = report["cameras"][static_cast<std::size_t>(k)];
    EXPECT_EQ(camera.at("index"), k);
    for (const char* key : {"seconds", "beams", "cells", "faces", "edges", "vertices"}) {
      EXPECT_GT(camera.at(key).get<double>(), 0) << key;
    }
    const Json map = Json::parse(read(folder / "maps" / ("000" + std::to_string(k) + ".map.json")));
    EXPECT_EQ(camera["faces"], map["faces"].size());
    EXPECT_EQ(camera["edges"], map["edges"].size());
    EXPECT_EQ(camera["vertices"], map["vertices"].size());
  }
  const Json& decisions = report.at("decisions");
  EXPECT_GT(decisions.at("identity").get<double>() + decisions.at("filter").get<double>(), 0);
  for (const char* width : {"64", "128", "256", "512"}) EXPECT_TRUE(decisions.at("exact").at(width).is_number());
}

TEST(Trace, EnginesWriteTheSameMaps) {
  const auto folder = folder_with_model("engines", "maze", 20);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "one"}).code, 0);
  const Ended ended =
      run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "two", "--engine", "cells", "--report", "r.json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(files_below(folder / "one"), files_below(folder / "two"));
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "three", "--engine", "hybrid"}).code, 0);
  EXPECT_EQ(files_below(folder / "one"), files_below(folder / "three"));
  const Json report = Json::parse(read(folder / "r.json"));
  EXPECT_EQ(report.at("engine"), "cells");
  for (const char* key : {"seconds", "cells", "faces", "edges", "vertices", "pairs", "bytes"}) {
    EXPECT_GT(report.at("complex").at(key).get<double>(), 0) << key;
  }
}

TEST(Trace, AFailingCameraLeavesTheOthers) {
  const auto folder = folder_with_model("failing", "rooms", 3);
  std::filesystem::create_directories(folder / "maps" / "0001.map.json" / "in the way");
  const Ended ended =
      run(folder, {"trace", "m.wp", "--cameras", "c.cameras", "-o", "maps", "-q", "--report", "r.json"});
  EXPECT_EQ(ended.code, 4);
  EXPECT_TRUE(one_complaint(ended.err)) << ended.err;
  EXPECT_NE(ended.err.find("camera 1 failed"), std::string::npos) << ended.err;
  const auto files = files_below(folder / "maps");
  EXPECT_EQ(files.size(), 2u);
  EXPECT_TRUE(files.contains("0000.map.json") && files.contains("0002.map.json"));
  const Json report = Json::parse(read(folder / "r.json"));
  EXPECT_TRUE(report["cameras"][1].contains("error"));
  EXPECT_FALSE(report["cameras"][2].contains("error"));
}

/// Runs the command on cameras that come through a pipe; gives how it ended and its peak of memory in kilobytes.
std::pair<Ended, long> run_with_pipe(const std::filesystem::path& folder, const std::string& cameras, int times,
                                     const std::string& maps) {
  const auto pipe = folder / "pipe";
  std::filesystem::remove(pipe);
  if (mkfifo(pipe.c_str(), 0600) != 0) throw std::runtime_error("mkfifo");
  const pid_t child = start(folder, {"trace", "m.obj", "--cameras", "pipe", "-o", maps, "--format", "csv", "-q"});
  std::FILE* out = std::fopen(pipe.c_str(), "w");
  for (int k = 0; k < times; ++k) std::fwrite(cameras.data(), 1, cameras.size(), out);
  std::fclose(out);
  const Ended ended = wait(folder, child);
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return {ended, usage.ru_maxrss};
}

// RUSAGE_CHILDREN keeps the largest of all children so far, so the short run comes first.
TEST(Trace, CamerasFromAPipeInConstantMemory) {
  const auto folder = folder_with_model("pipe", "rooms", 50);
  const std::string cameras = read(folder / "c.cameras");
  const auto [few, little] = run_with_pipe(folder, cameras, 20, "few");
  const auto [many, much] = run_with_pipe(folder, cameras, 120, "many");
  EXPECT_EQ(few.code, 0) << few.err;
  EXPECT_EQ(many.code, 0) << many.err;
  if (!sanitized) {
    EXPECT_LT(much - little, 2000);  // kilobytes; the table alone has 700 more
  }
  std::string repeated;
  for (int k = 0; k < 20; ++k) repeated += cameras;
  write(folder / "repeated.cameras", repeated);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "repeated.cameras", "-o", "file", "--format", "csv"}).code, 0);
  EXPECT_EQ(read(folder / "few/visibility.csv"), read(folder / "file/visibility.csv"));
}

TEST(Trace, WhatComesThroughAPipeBeforeAFaultIsDone) {
  const auto folder = folder_with_model("pipe_fault", "rooms", 30);
  const std::string cameras = read(folder / "c.cameras");
  const Ended ended = run_with_pipe(folder, cameras + "1 2 x\n" + cameras, 1, "maps").first;
  EXPECT_EQ(ended.code, 3);
  EXPECT_EQ(ended.err, "sightline: pipe:31: camera 30: 'x' is not a number\n");
  write(folder / "c.cameras", cameras);
  ASSERT_EQ(run(folder, {"trace", "m.obj", "--cameras", "c.cameras", "-o", "file", "--format", "csv"}).code, 0);
  EXPECT_EQ(files_below(folder / "maps"), files_below(folder / "file"));
}

TEST(Trace, WhatIsLeftOutIsReported) {
  const auto folder = fresh_folder("min_angle");
  ASSERT_EQ(run(folder, {"model", "rooms", "--rotate", "17", "-o", "m.obj"}).code, 0);
  for (const char* angle : {"0", "1e-3"}) {
    const Ended ended = run(
        folder, {"trace", "m.obj", "--cameras", "m.cameras", "-o", "maps", "--min-angle", angle, "--report", "r.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    double left_out = 0;
    const Json report = Json::parse(read(folder / "r.json"));
    for (const Json& camera : report.at("cameras")) left_out += camera.at("left_out").get<double>();
    EXPECT_EQ(left_out > 0, std::string(angle) != "0");
  }
}

TEST(Trace, WhatIsFarIsLeftOut) {
  const auto folder = folder_with_model("max_distance", "city", 1);
  std::size_t faces[3];
  for (const std::size_t k : {0u, 1u, 2u}) {
    const char* const distance[] = {"1e-3", "4", "1e9"};
    const Ended ended = run(folder, {"trace", "m.wp", "--cameras", "c.cameras", "-o", "maps", "--threads", "2",
                                     "--max-distance", distance[k], "--report", "r.json"});
    ASSERT_EQ(ended.code, 0) << ended.err;
    faces[k] = Json::parse(read(folder / "r.json")).at("cameras")[0].at("faces").get<std::size_t>();
  }
  EXPECT_EQ(faces[0], 1u);  // the empty window
  EXPECT_LT(faces[1], faces[2]);
}

TEST(Trace, SnapIsReported) {
  const auto folder = fresh_folder("snap");
  write(folder / "s.obj", "v 0.1 0 0\nv 1.1 0 0\nv 1.1 1 0\nv 0.1 1.2 0\nf 1 2 3 4\n");
  const Ended ended = run(folder, {"build", "s.obj", "-o", "s.wp", "--snap", "0.5", "--report", "r.json"});
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.err.find("snapped to 0.5"), std::string::npos) << ended.err;
  const Json report = Json::parse(read(folder / "r.json"));
  EXPECT_NEAR(report.at("scene").at("largest_displacement").get<double>(), 0.2236, 1e-3);
}

TEST(Trace, VerifyAgrees) {
  const auto folder = folder_with_model("verify", "rooms", 2);
  if (!std::filesystem::exists(std::filesystem::path(SIGHTLINE_COMMAND).parent_path() / "sightline-verify")) {
    GTEST_SKIP() << "sightline-verify is not built";
  }
  ASSERT_EQ(run(folder, {"trace", "m.wp", "--cameras", "c.cameras", "-o", "maps"}).code, 0);
  EXPECT_EQ(run(folder, {"verify", "m.obj", "maps/0000.map.json", "maps/0001.map.json"}).code, 0);
  std::string damaged = read(folder / "maps" / "0000.map.json");
  const std::size_t kind = damaged.find("\"silhouette\"");
  ASSERT_NE(kind, std::string::npos);
  damaged.replace(kind, 12, "\"seam\"");
  write(folder / "damaged.map.json", damaged);
  EXPECT_EQ(run(folder, {"verify", "m.obj", "damaged.map.json"}).code, 1);
  EXPECT_EQ(run(folder, {"verify", "m.obj", "missing.map.json"}).code, 3);
}

}  // namespace
}  // namespace sightline::test
