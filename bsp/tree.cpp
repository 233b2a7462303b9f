#include "bsp/tree.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#include <array>
#include <mutex>

#include "bsp/tree_grower.hpp"

namespace sightline {
namespace {

constexpr std::size_t grown_at_once = 4096;  // parts that are left to one thread with all that comes of them

}  // namespace

struct BspTree::State {
  explicit State(const Scene& scene) : wholes(scene) {}

  void plant(const TreeOptions& options);
  void grow(tbb::task_group& group, TreeNode& node, TreeLoad& load);
  void divide(TreeNode& node);
  std::uint32_t put(TreeLoad load);
  TreeLoad take(std::uint32_t place);

  const TreeSurfaces wholes;
  TreeNode* root = nullptr;
  std::array<std::mutex, 64> doors;  // to nodes, by where these lie in memory

  mutable std::mutex mutex;  // of what follows
  std::vector<std::unique_ptr<TreeGrower>> growers;
  std::vector<TreeGrower*> idle;
  std::vector<TreeLoad> waiting;      // by TreeNode::waiting
  std::vector<std::uint32_t> vacant;  // places in it
  Size size;
};

namespace {

/// A grower of the tree's own, for one thread at a time.
template <class State>
class Loan {
 public:
  explicit Loan(State& state) : state_(state) {
    const std::lock_guard lock(state_.mutex);
    if (state_.idle.empty()) {
      state_.growers.push_back(std::make_unique<TreeGrower>(state_.wholes));
      state_.idle.push_back(state_.growers.back().get());
    }
    grower_ = state_.idle.back();
    state_.idle.pop_back();
    before_ = grower_->size();
  }
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan() {
    const BspTree::Size now = grower_->size();
    const std::lock_guard lock(state_.mutex);
    state_.size.nodes += now.nodes - before_.nodes;
    state_.size.pieces += now.pieces - before_.pieces;
    state_.size.bytes += now.bytes - before_.bytes;
    state_.idle.push_back(grower_);  // never more than it has held
  }
  TreeGrower* operator->() { return grower_; }

 private:
  State& state_;
  TreeGrower* grower_;
  BspTree::Size before_;
};

}  // namespace

std::uint32_t BspTree::State::put(TreeLoad load) {
  const std::lock_guard lock(mutex);
  if (vacant.empty()) {
    waiting.push_back(std::move(load));
    return static_cast<std::uint32_t>(waiting.size() - 1);
  }
  const std::uint32_t place = vacant.back();
  vacant.pop_back();
  waiting[place] = std::move(load);
  return place;
}

TreeLoad BspTree::State::take(std::uint32_t place) {
  const std::lock_guard lock(mutex);
  vacant.push_back(place);
  return std::exchange(waiting[place], {});
}

void BspTree::State::plant(const TreeOptions& options) {
  TreeLoad load;
  {
    Loan grower(*this);
    root = grower->plant(load);
    if (!root) return;
    if (!options.lazy && (options.threads <= 1 || load.parts.size() <= grown_at_once)) {
      grower->grow(*root, load);
      return;
    }
  }
  if (options.lazy) {
    root->waiting = put(std::move(load));
    return;
  }
  // The caller may have set a limit.
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  tbb::task_arena arena(static_cast<int>(std::min<std::size_t>(options.threads, allowed)));
  arena.execute([&] {
    tbb::task_group group;
    grow(group, *root, load);
    group.wait();
  });
}

/// Large nodes are divided one by one, and hand over to whoever has time; nobody waits for anybody on the way.
void BspTree::State::grow(tbb::task_group& group, TreeNode& node, TreeLoad& load) {
  Loan grower(*this);
  if (load.parts.size() <= grown_at_once) {
    grower->grow(node, load);
    return;
  }
  TreeLoad below[2];
  grower->divide(node, load, below);
  node.ready.store(true, std::memory_order_release);
  for (const int k : {0, 1}) {
    if (!node.child[k]) continue;
    const auto handed = std::make_shared<TreeLoad>(std::move(below[k]));
    group.run([this, &group, child = node.child[k], handed] { grow(group, *child, *handed); });
  }
}

/// Whoever comes first divides the node, the others wait for that.
void BspTree::State::divide(TreeNode& node) {
  const auto where = reinterpret_cast<std::uintptr_t>(&node) / sizeof(TreeNode);
  const std::lock_guard door(doors[where % doors.size()]);
  if (node.ready.load(std::memory_order_relaxed)) return;
  TreeLoad load = take(node.waiting), below[2];
  Loan grower(*this);
  grower->divide(node, load, below);
  for (const int k : {0, 1}) {
    if (node.child[k]) node.child[k]->waiting = put(std::move(below[k]));
  }
  node.ready.store(true, std::memory_order_release);
}

BspTree::BspTree(const Scene& scene, const TreeOptions& options) : state_(std::make_unique<State>(scene)) {
  state_->plant(options);
}
BspTree::~BspTree() = default;
BspTree::BspTree(BspTree&&) noexcept = default;
BspTree& BspTree::operator=(BspTree&&) noexcept = default;

const Scene& BspTree::scene() const { return state_->wholes.scene(); }
TreeNode* BspTree::root() const { return state_->root; }
void BspTree::divide(TreeNode& node) const { state_->divide(node); }

BspTree::Size BspTree::size() const {
  const std::lock_guard lock(state_->mutex);
  Size size = state_->size;
  size.bytes += state_->wholes.bytes();
  for (const TreeLoad& load : state_->waiting) size.bytes += load.bytes();
  return size;
}

}  // namespace sightline
