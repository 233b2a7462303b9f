#include "exact/tally.hpp"

#include <algorithm>
#include <mutex>
#include <vector>

namespace sightline {
namespace tally_detail {

constinit thread_local ThreadTally of_this_thread;

namespace {

struct Registry {
  std::mutex mutex;
  std::vector<const Tally*> running;
  Tally ended;
};

// Never destroyed: threads may end after the static objects of the program have.
Registry& registry() {
  static Registry* const instance = new Registry;
  return *instance;
}

// Adds the thread's counts to those of the ended threads when the thread ends.
struct Farewell {
  bool armed = false;
  ~Farewell() {
    if (!armed) return;
    const std::lock_guard lock(registry().mutex);
    std::erase(registry().running, &of_this_thread.counts);
    registry().ended += of_this_thread.counts;
  }
};
thread_local Farewell farewell;

}  // namespace

void register_thread() {
  const std::lock_guard lock(registry().mutex);
  registry().running.push_back(&of_this_thread.counts);
  farewell.armed = true;
  of_this_thread.registered = true;
}

}  // namespace tally_detail

Tally& Tally::operator+=(const Tally& o) {
  identity += o.identity;
  filter += o.filter;
  for (std::size_t i = 0; i < exact.size(); ++i) exact[i] += o.exact[i];
  return *this;
}

Tally Tally::operator-(const Tally& o) const {
  Tally r = *this;
  r.identity -= o.identity;
  r.filter -= o.filter;
  for (std::size_t i = 0; i < exact.size(); ++i) r.exact[i] -= o.exact[i];
  return r;
}

Tally tally_total() {
  tally_detail::Registry& all = tally_detail::registry();
  const std::lock_guard lock(all.mutex);
  Tally sum = all.ended;
  for (const Tally* t : all.running) sum += *t;
  return sum;
}

}  // namespace sightline
