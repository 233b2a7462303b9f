// An ID buffer, rasterised.
#include "compare/memory.hpp"
#include "compare/method.hpp"
#include "sample/id_buffer.hpp"

namespace sightline::comparison {
namespace {

class Ids : public TimedMethod, public TellsMemory {
 public:
  Ids(const Scene& scene, unsigned size) : buffer_(scene, size) {}
  MethodMemory memory() const override { return {buffer_.bytes(), 0}; }

 private:
  void look(const Camera& camera) override { items_ = buffer_.draw(camera); }

  void tell(Answer& answer) override {
    answer.reported.assign(items_.begin(), items_.end());
    answer.shown = Pixels{buffer_.size(), answer.reported};
    tidy(answer.reported);
  }

  IdBuffer buffer_;
  std::span<const PolygonId> items_;
};

}  // namespace

std::unique_ptr<Method> make_ids(const Scene& scene, unsigned size) { return std::make_unique<Ids>(scene, size); }

}  // namespace sightline::comparison
