// sightline-double: the engine `front-to-back` without exact stages, for `sightline compare`. Reads a scene and then
// cameras from its standard input, a socket, and answers each there: + and the answer, or - and the reason why not.
#include "beam/trace.hpp"
#include "bsp/tree.hpp"
#include "compare/guard.hpp"
#include "compare/packing.hpp"
#include "compare/plain/predicates.hpp"
#include "exact/tally.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

namespace {

using namespace sightline;
using namespace sightline::comparison;

class Plain : public TimedMethod {
 public:
  /// `before`: the decisions up to here that may have been exact.
  Plain(const BspTree& tree, const Tally& before) : tracer_(tree), before_(before) {}

 private:
  void look(const Camera& camera) override { tracer_.trace(camera, map_); }
  void tell(Answer& answer) override {
    for (const std::uint64_t decisions : (tally() - before_).exact) {
      if (decisions != 0) throw std::logic_error("an exact stage was reached");
    }
    answer.reported.clear();
    for (const MapFace& f : map_.faces) answer.reported.push_back(f.polygon);
    tidy(answer.reported);
    draw(map_, answer.shown.emplace<Drawing>());
  }

  Tracer tracer_;
  Tally before_;
  VisibilityMap map_;
};

bool reply(const Guarded& ended) { return send(STDIN_FILENO, ended.why.empty() ? '+' + ended.bytes : '-' + ended.why); }

}  // namespace

int main() {
  std::signal(SIGPIPE, SIG_IGN);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // however the command ends
  std::string message;
  if (!receive(STDIN_FILENO, message)) return 1;
  const Scene scene = unpacked_scene(message);
  const double start = thread_seconds();
  const BspTree tree(scene);
  const double seconds = thread_seconds() - start;
  comparison::prepares = false;
  Plain method(tree, tally());
  if (!reply({std::string(reinterpret_cast<const char*>(&seconds), sizeof seconds), {}})) return 1;
  while (receive(STDIN_FILENO, message)) {
    Request request;
    if (message.size() != sizeof request) return 1;
    std::memcpy(&request, message.data(), sizeof request);
    const auto work = [&] { return packed(method.view(request.camera, 0)); };
    if (!reply(run_guarded(work, {request.seconds, 12}))) return 1;
  }
  return 0;
}
