// The program: exit codes and what it prints.
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

struct Result {
  int code;
  std::string output;
};

Result run(const std::string& arguments) {
  Result result{-1, {}};
  FILE* pipe = popen(("'" VERIFY_PROGRAM "' " + arguments + " 2>&1").c_str(), "r");
  if (!pipe) return result;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) result.output.append(buffer.data(), n);
  const int status = pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : -2;
  return result;
}

const std::string data = VERIFY_DATA "/";

std::string write(const std::string& name, const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("sightline_verify_" + std::to_string(getpid()) + name);
  std::ofstream(path) << text;
  return path.string();
}

std::string read(const std::string& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

int lines(const std::string& text) { return static_cast<int>(std::count(text.begin(), text.end(), '\n')); }

TEST(Program, RightMapsAreOk) {
  const Result result = run(data + "two.obj " + data + "two.map.json " + data + "two.map.json");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_EQ(lines(result.output), 2) << result.output;
  EXPECT_NE(result.output.find("two.map.json: ok"), std::string::npos);
  EXPECT_EQ(run("-q " + data + "two.obj " + data + "two.map.json").output, "");
  EXPECT_EQ(run("--one-sided " + data + "one_sided.obj " + data + "one_sided.map.json").code, 0);
  EXPECT_EQ(run("--snap=0.001 " + data + "snapped.obj " + data + "snapped.map.json --threads 2").code, 0);
}

TEST(Program, FaultsAreNamed) {
  const Result other = run(data + "crossing.obj " + data + "two.map.json");
  EXPECT_EQ(other.code, 1) << other.output;
  EXPECT_NE(other.output.find("scene: "), std::string::npos) << other.output;
  const Result json = run("--json " + data + "one_sided.obj " + data + "one_sided.map.json");
  EXPECT_EQ(json.code, 1);
  EXPECT_NE(json.output.find("\"ok\":false"), std::string::npos) << json.output;
  EXPECT_NE(json.output.find("\"depth\":{\"count\":"), std::string::npos) << json.output;
  // One right map does not make up for a wrong one.
  EXPECT_EQ(run(data + "two.obj " + data + "crossing.map.json " + data + "two.map.json").code, 1);
}

TEST(Program, CamerasAreCompared) {
  const std::string right = write("right.cameras", "# eye, forward, up, angle, aspect\n0 0 0  0 1 0  0 0 1  90 1\n");
  const std::string wrong = write("wrong.cameras", "0 0 0  0 1 0  0 0 1  90 1.5\n");
  EXPECT_EQ(run(data + "two.obj " + data + "two.map.json --cameras " + right).code, 0);
  EXPECT_EQ(run(data + "two.obj " + data + "two.map.json --cameras " + wrong).code, 1);
  EXPECT_EQ(run(data + "two.obj " + data + "two.map.json " + data + "two.map.json --cameras " + right).code, 3);
  std::filesystem::remove(right);
  std::filesystem::remove(wrong);
}

TEST(Program, WrongUsage) {
  for (const std::string arguments : {"", "x.obj", "--what a b", "a b --threads", "a b --threads x", "a b -q=3"}) {
    const Result result = run(arguments);
    EXPECT_EQ(result.code, 2) << arguments << ": " << result.output;
    EXPECT_EQ(lines(result.output), 1) << result.output;
  }
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_EQ(run("--version").code, 0);
}

TEST(Program, BadInput) {
  const std::string text = read(data + "two.map.json");
  const std::string torn = write("torn.json", text.substr(0, text.size() / 2)), empty = write("empty.json", "");
  for (const std::string& map : {torn, empty, std::string("/nowhere.json"), data}) {
    const Result result = run(data + "two.obj " + map);
    EXPECT_EQ(result.code, 3) << map << ": " << result.output;
    EXPECT_EQ(lines(result.output), 1) << result.output;
  }
  const std::string scene = write("scene.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(run(scene + " " + data + "two.map.json").code, 3);
  EXPECT_EQ(run("/nowhere.obj " + data + "two.map.json").code, 3);
  EXPECT_EQ(run(data + "two.map.json " + data + "two.map.json").code, 3);
  EXPECT_EQ(run("--snap x " + data + "two.obj " + data + "two.map.json").code, 2);
  for (const std::string& file : {torn, empty, scene}) std::filesystem::remove(file);
}

}  // namespace
