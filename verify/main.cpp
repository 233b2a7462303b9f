// sightline-verify SCENE MAP.json ..
#include "verify/exact.hpp"
#include "verify/verify.hpp"

#include <gmp.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <sstream>
#include <thread>
#include <utility>

namespace {

using namespace sightline::verify;

constexpr int all_right = 0, fault_found = 1, wrong_usage = 2, bad_input = 3, limit_reached = 5;

constexpr const char* help = R"(usage: sightline-verify SCENE MAP.json [MAP.json ..] [options]

Proves that visibility maps are right for a scene (.obj, .ply, .off, .stl), or names what is wrong.

  --snap UNIT      the maps must have been made with this snap (without it: the one that each map names)
  --one-sided      polygons are opaque only from the side from which they run counter-clockwise
  --cameras FILE   the maps must be of these cameras: 0007.map.json of the eighth; other names in their order
  --threads N      number of threads (default: all cores)
  --limit N        faults of each check that are printed (default 10)
  --json           print one JSON object a map
  -q, --quiet      print faults only
  --version, -h, --help

Exit code: 0 every map is right; 1 a fault was found; 2 wrong usage; 3 bad input; 5 out of memory.
)";

struct Usage {
  std::string what;
};

struct Arguments {
  std::string scene, cameras;
  std::vector<std::string> maps;
  Options options;
  bool quiet = false, json = false, done = false;
};

std::size_t natural(const std::string& option, const std::string& text) {
  if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos) {
    throw Usage{option + " needs a natural number, not '" + text + "'"};
  }
  return std::stoul(text);
}

std::string positive_decimal(const std::string& text) {
  try {
    if (parse_decimal(text) > 0) return text;
  } catch (const std::invalid_argument&) {
  }
  throw Usage{"--snap needs a positive decimal, not '" + text + "'"};
}

Arguments parse(int argc, char** argv) {
  Arguments out;
  out.options.threads = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::string> files;
  bool options_end = false;
  for (int i = 1; i < argc; ++i) {
    std::string word = argv[i];
    if (options_end || word.size() < 2 || word[0] != '-') {
      files.push_back(word);
      continue;
    }
    std::optional<std::string> attached;
    if (const auto equal = word.find('='); word.starts_with("--") && equal != std::string::npos) {
      attached = word.substr(equal + 1);
      word.resize(equal);
    }
    const auto value = [&]() -> std::string {
      if (attached) return *std::exchange(attached, std::nullopt);
      if (i + 1 == argc) throw Usage{word + " needs a value"};
      return argv[++i];
    };
    if (word == "--") {
      options_end = true;
    } else if (word == "--snap") {
      out.options.snap = positive_decimal(value());
    } else if (word == "--one-sided") {
      out.options.one_sided = true;
    } else if (word == "--cameras") {
      out.cameras = value();
    } else if (word == "--threads") {
      out.options.threads = static_cast<unsigned>(std::min<std::size_t>(natural(word, value()), 256));
      if (out.options.threads == 0) throw Usage{"--threads needs at least 1"};
    } else if (word == "--limit") {
      out.options.limit = natural(word, value());
    } else if (word == "--json") {
      out.json = true;
    } else if (word == "-q" || word == "--quiet") {
      out.quiet = true;
    } else if (word == "-h" || word == "--help") {
      std::cout << help;
      out.done = true;
      return out;
    } else if (word == "--version") {
      std::cout << "sightline-verify " << SIGHTLINE_VERSION << "\n";
      out.done = true;
      return out;
    } else {
      throw Usage{"there is no option " + word};
    }
    if (attached) throw Usage{word + " takes no value"};
  }
  if (files.size() < 2) throw Usage{"SCENE and MAP.json are needed (see sightline-verify --help)"};
  out.scene = files[0];
  out.maps.assign(files.begin() + 1, files.end());
  return out;
}

std::string quoted(const std::string& text) {
  std::ostringstream out;
  out << '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') out << '\\';
    if (static_cast<unsigned char>(c) < ' ') {
      out << "\\u00"
          << "0123456789abcdef"[c >> 4] << "0123456789abcdef"[c & 15];
    } else {
      out << c;
    }
  }
  out << '"';
  return out.str();
}

void print_json(const std::string& file, const Report& report, double seconds) {
  std::cout << "{\"map\":" << quoted(file) << ",\"ok\":" << (report.ok() ? "true" : "false")
            << ",\"count\":" << report.count() << ",\"seconds\":" << seconds
            << ",\"left_out\":" << quoted(report.left_out) << ",\"checks\":{";
  bool first_check = true;
  for (const auto& [check, entry] : report.checks()) {
    std::cout << (first_check ? "" : ",") << quoted(check) << ":{\"count\":" << entry.count << ",\"faults\":[";
    first_check = false;
    for (std::size_t i = 0; i < entry.first.size(); ++i) {
      std::cout << (i > 0 ? "," : "") << "{\"item\":" << quoted(entry.first[i].item)
                << ",\"what\":" << quoted(entry.first[i].what) << "}";
    }
    std::cout << "]}";
  }
  std::cout << "}}\n";
}

void print_text(const std::string& file, const Report& report, double seconds, bool quiet) {
  if (report.ok()) {
    if (!quiet) std::cout << file << ": ok (" << seconds << " s)\n";
    return;
  }
  for (const auto& [check, entry] : report.checks()) {
    for (const Fault& fault : entry.first) {
      std::cout << file << ": " << check << ": " << fault.item << ": " << fault.what << "\n";
    }
    if (entry.count > entry.first.size()) {
      std::cout << file << ": " << check << ": " << entry.count - entry.first.size() << " more\n";
    }
  }
  std::cout << file << ": " << report.count() << (report.count() == 1 ? " fault" : " faults");
  if (!report.left_out.empty()) std::cout << "; left out: " << report.left_out;
  std::cout << "\n";
}

/// The camera of a map: by the number with which its name begins, else by its place.
const CameraLine& camera_of(const std::vector<CameraLine>& cameras, const std::string& map, std::size_t place) {
  const std::string name = std::filesystem::path(map).filename().string();
  const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
  const std::size_t number = digits > 0 && digits < 9 ? std::stoul(name.substr(0, digits)) : place;
  if (number >= cameras.size()) throw InputError(map + ": there is no camera " + std::to_string(number));
  return cameras[number];
}

int run(const Arguments& arguments) {
  std::vector<CameraLine> cameras;
  if (!arguments.cameras.empty()) cameras = read_cameras(arguments.cameras);
  Verifier verifier(read_scene(arguments.scene), arguments.options);
  bool right = true;
  for (std::size_t i = 0; i < arguments.maps.size(); ++i) {
    const std::string& file = arguments.maps[i];
    const auto start = std::chrono::steady_clock::now();
    const CameraLine* camera = arguments.cameras.empty() ? nullptr : &camera_of(cameras, file, i);
    const Report report = verifier.check(file, load_file(file), camera);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (arguments.json) {
      print_json(file, report, seconds);
    } else {
      print_text(file, report, seconds, arguments.quiet);
    }
    right = right && report.ok();
  }
  std::cout.flush();
  return right ? all_right : fault_found;
}

/// Ends the process wherever it is: GMP's own functions would abort it.
[[noreturn]] void out_of_memory() {
  constexpr char line[] = "sightline-verify: out of memory\n";
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line, sizeof line - 1);
  _exit(limit_reached);
}
void* allocated(void* memory) {
  if (memory == nullptr) out_of_memory();
  return memory;
}
void watch_memory() {
  std::set_new_handler(out_of_memory);
  mp_set_memory_functions([](std::size_t bytes) { return allocated(std::malloc(bytes)); },
                          [](void* old, std::size_t, std::size_t bytes) { return allocated(std::realloc(old, bytes)); },
                          [](void* memory, std::size_t) { std::free(memory); });
}

}  // namespace

int main(int argc, char** argv) {
  watch_memory();
  try {
    const Arguments arguments = parse(argc, argv);
    return arguments.done ? all_right : run(arguments);
  } catch (const Usage& usage) {
    std::cerr << "sightline-verify: " << usage.what << "\n";
    return wrong_usage;
  } catch (const std::exception& error) {
    std::cout.flush();
    std::cerr << "sightline-verify: " << error.what() << "\n";
    return bad_input;
  }
}
