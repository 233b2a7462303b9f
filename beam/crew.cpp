#include "beam/crew.hpp"

#include <tbb/parallel_for.h>

namespace sightline {

void Crew::fill(Engine& first, unsigned parts, const std::function<void(Engine&, unsigned)>& fill_part) {
  while (engines_.size() < parts) engines_.push_back(first.copy());
  arena_.execute([&] {
    tbb::parallel_for(
        0u, parts,
        [&](unsigned k) {
          Engine& engine = *engines_[k];
          engine.start(first.view.table.eye());
          fill_part(engine, k);
        },
        tbb::simple_partitioner());
  });
  for (unsigned k = 0; k < parts; ++k) {
    const View& part = engines_[k]->view;
    first.view.fragments.append(part.fragments, part.table, first.view.table);
    first.view.beams += part.beams;
    first.view.cells += part.cells;
    first.view.left_out += part.left_out;
  }
}

}  // namespace sightline
