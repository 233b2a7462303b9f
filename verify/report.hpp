// What is found wrong.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace sightline::verify {

struct Fault {
  std::string item;  // "edge 12"
  std::string what;
};

/// Faults by check; of each check only the first few are kept, all are counted.
class Report {
 public:
  explicit Report(std::size_t limit = 10) : limit_(limit) {}

  void fault(const std::string& check, std::string item, std::string what) {
    Entry& entry = checks_[check];
    if (entry.first.size() < limit_) entry.first.push_back({std::move(item), std::move(what)});
    ++entry.count;
  }
  bool ok() const { return checks_.empty(); }
  std::size_t count() const {
    std::size_t sum = 0;
    for (const auto& [name, entry] : checks_) sum += entry.count;
    return sum;
  }

  struct Entry {
    std::vector<Fault> first;
    std::size_t count = 0;
  };
  const std::map<std::string, Entry>& checks() const { return checks_; }
  /// Checks that were left out because of faults in those that they rest on.
  std::string left_out;

 private:
  std::size_t limit_;
  std::map<std::string, Entry> checks_;
};

inline std::string named(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

}  // namespace sightline::verify
