#include "bsp/build.hpp"

#include <chrono>

#include "bsp/choose.hpp"
#include "bsp/label.hpp"

namespace sightline {
namespace {

// The bounding box and an eighth of its largest extent around it, at coordinates of few digits.
void enlarged_box(const Scene& scene, Integer lower[3], Integer upper[3]) {
  const PointTable& points = scene.points();
  Integer extent = 1;
  constexpr double rounded = 0x1p-50;  // more than two coordinates are off by
  for (int k = 0; k < 3; ++k) {
    PointId least = none, most = none;
    for (const SurfaceEdge& e : scene.all_edges()) {
      for (const PointId p : {e.a, e.b}) {
        const double at = points.approx(p)[k];
        if (least == none || (at <= points.approx(least)[k] + rounded && compare(points, p, least, k) < 0)) least = p;
        if (most == none || (at >= points.approx(most)[k] - rounded && compare(points, p, most, k) > 0)) most = p;
      }
    }
    lower[k] = least != none ? points.point(least)[static_cast<std::size_t>(k)] : Integer(0);
    upper[k] = most != none ? points.point(most)[static_cast<std::size_t>(k)] : Integer(0);
    extent = std::max<Integer>(extent, upper[k] - lower[k]);
  }
  const auto digits = mpz_sizeinbase(extent.get_mpz_t(), 2);
  const unsigned long dropped = digits > 5 ? digits - 5 : 0;
  const Integer step = Integer(1) << dropped;
  for (int k = 0; k < 3; ++k) {
    mpz_fdiv_q_2exp(lower[k].get_mpz_t(), lower[k].get_mpz_t(), dropped);
    mpz_cdiv_q_2exp(upper[k].get_mpz_t(), upper[k].get_mpz_t(), dropped);
    lower[k] = (lower[k] - 1) * step;
    upper[k] = (upper[k] + 1) * step;
  }
}

/// What a building's complex comes to, a surface: arrays that grow are copied, and hold both copies for a while.
void make_room(Complex& complex, std::size_t surfaces) {
  complex.vertices.reserve(4 * surfaces);
  complex.edges.reserve(8 * surfaces);
  complex.faces.reserve(5 * surfaces);
  complex.cells.reserve(surfaces);
  complex.pairs.reserve(24 * surfaces);
}

/// Gives back what a long list took that is short now.
template <class Item>
void trim(std::vector<Item>& list) {
  if (list.capacity() > 4096 && list.size() < list.capacity() / 4) list.shrink_to_fit();
}

class Builder {
 public:
  Builder(const Scene& scene, Complex& complex, const ChoiceWeights& weights)
      : c_(complex),
        splitter_(complex),
        labeller_(scene, complex, splitter_),
        pieces_(scene, complex.planes),
        chooser_(scene, complex.planes, pieces_, weights) {
    box_.low = complex.vertices.front().place.approx;
    box_.high = complex.vertices[7].place.approx;
    pieces_.reserve(scene.all_edges().size() * 9 / 8);  // a cut piece has corners of its own
    waiting_.reserve(scene.surfaces().size());
    for (SurfaceId s = 0; s < scene.surfaces().size(); ++s) waiting_.push_back(pieces_.whole(s));
  }

  void run() {
    tasks_.push_back({0, 0, box_});
    while (!tasks_.empty()) {
      const Task task = tasks_.back();
      tasks_.pop_back();
      if (waiting_.size() > task.first) cut(task);
    }
    labeller_.finish(pieces_);
  }
  std::uint32_t splits() const { return splits_; }

 private:
  struct Task {
    CellId cell;
    std::size_t first;  // its pieces are waiting_[first ..] when its turn comes
    Bounds bounds;
  };

  void cut(const Task& task) {
    PlaneId plane = none;
    for (const bool free_space : {true, false}) {
      const Choice choice = chooser_.choose(std::span(waiting_).subspan(task.first), task.bounds, free_space);
      plane = choice.plane != none ? choice.plane : c_.planes.add_axis(choice.axis, choice.value).id;
      distribute(task.first, plane);
      // A cut in free space that parts nothing would not bring the end nearer.
      if (!on_.empty() || (waiting_.size() > task.first && !front_.empty())) break;
      waiting_.insert(waiting_.end(), front_.begin(), front_.end());
    }
    const Splitter::CellCut cut = splitter_.cut_cell(task.cell, plane);
    labeller_.note(cut.face, on_);
    Task behind{task.cell, task.first, task.bounds}, front{cut.front, waiting_.size(), task.bounds};
    if (const int axis = c_.planes.axis(plane); axis >= 0) {
      const ApproxPlane& p = c_.planes.approx(plane);
      behind.bounds.high[axis] = front.bounds.low[axis] = p.d / p.n[axis];
    }
    tasks_.push_back(behind);
    tasks_.push_back(front);
    waiting_.insert(waiting_.end(), front_.begin(), front_.end());
    for (auto* list : {&waiting_, &on_, &front_}) trim(*list);
  }

  /// Leaves what lies behind waiting; a piece leaves at most one there, so that none is overwritten unread.
  void distribute(std::size_t first, PlaneId plane) {
    on_.clear();
    front_.clear();
    const BoxSide box_side(c_.planes.approx(plane));
    std::size_t behind = first;
    for (std::size_t k = first; k < waiting_.size(); ++k) {
      const Piece& piece = waiting_[k];
      const Sign clear = piece.plane == plane ? 0 : box_side.of(piece.low, piece.high);
      switch (clear != 0 ? (clear < 0 ? 1 : 2) : pieces_.sides(piece, plane)) {
        case 0:
          on_.push_back(piece);
          break;
        case 1:
          if (behind != k) waiting_[behind] = piece;
          ++behind;
          break;
        case 2:
          front_.push_back(piece);
          break;
        default: {
          Piece halves[2];
          pieces_.split(piece, plane, halves[0], halves[1]);
          waiting_[behind++] = halves[0];
          front_.push_back(halves[1]);
          ++splits_;
        }
      }
    }
    waiting_.resize(behind);
  }

  Complex& c_;
  Splitter splitter_;
  Labeller labeller_;
  Pieces pieces_;
  Chooser chooser_;
  std::vector<Piece> waiting_;  // pieces of all tasks, those of the next one last
  std::vector<Task> tasks_;
  std::vector<Piece> on_, front_;  // of the cut at hand
  Bounds box_;
  std::uint32_t splits_ = 0;
};

}  // namespace

std::size_t complex_bytes(const Complex& c) {
  return c.vertices.size() * sizeof(Vertex) + c.edges.size() * sizeof(Edge) + c.faces.size() * sizeof(Face) +
         c.cells.size() * sizeof(Cell) + c.pairs.size() * sizeof(Pair) +
         (c.label_first.size() + c.label_surfaces.size()) * sizeof(std::uint32_t) + c.planes.bytes();
}

Complex build(const Scene& scene, const BuildOptions& options, BuildStats* stats) {
  const auto start = std::chrono::steady_clock::now();
  Integer lower[3], upper[3];
  enlarged_box(scene, lower, upper);
  Complex complex = make_box(scene, lower, upper);
  make_room(complex, scene.surfaces().size());
  Builder builder(scene, complex, options.weights);
  builder.run();
  if (stats) {
    stats->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    stats->bytes = complex_bytes(complex);
    stats->splits = builder.splits();
  }
  return complex;
}

}  // namespace sightline
