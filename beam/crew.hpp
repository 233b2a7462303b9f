// Engines that share the work of one eye. Internal to beam/.
#pragma once

#include <tbb/task_arena.h>

#include <functional>
#include <memory>
#include <vector>

#include "beam/view.hpp"

namespace sightline {

/// Copies of an engine, each with sightlines of its own, that fill disjoint parts of the view at the same time. What
/// they find is told to the first engine part by part, so that it does not depend on who was faster.
class Crew {
 public:
  explicit Crew(unsigned threads) : threads_(threads), arena_(static_cast<int>(threads)) {}
  unsigned threads() const { return threads_; }

  /// Calls fill_part(engine, k) for every k below `parts`, each with an engine that has begun with the first one's eye,
  /// and hands over to `first` what they have seen.
  void fill(Engine& first, unsigned parts, const std::function<void(Engine&, unsigned)>& fill_part);

 private:
  unsigned threads_;
  tbb::task_arena arena_;
  std::vector<std::unique_ptr<Engine>> engines_;  // by part
};

}  // namespace sightline
