// What the peers share that are handed convex pieces and run each view in a process of its own.
#pragma once

#include "bench/compare/method.hpp"
#include "bench/compare/pieces.hpp"

namespace sightline::peers {

class PiecewisePeer : public Method {
 public:
  explicit PiecewisePeer(std::string name) : Method(std::move(name), Kind::peer) {}
  bool in_child() const override { return true; }

  Cost prepare(const Scene& scene) override {
    scene_ = &scene;
    pieces_ = pieces_of(scene);
    return {};
  }
  void release() override { pieces_ = {}; }

 protected:
  const Scene* scene_ = nullptr;
  Pieces pieces_;
};

}  // namespace sightline::peers
