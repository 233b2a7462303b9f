// gl2ps: a painter's order of the view's polygons by a binary space partition in floats, and what remains of them when
// the hidden are culled. It needs no OpenGL context here: its primitives are handed to it directly, already clipped and
// mapped, which OpenGL's feedback buffer would do otherwise (and whose cost it is spared).
#include <gl2ps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "bench/compare/piecewise.hpp"

namespace sightline::peers {
namespace {

constexpr int width = 1024;

class Page : public PiecewisePeer {
 public:
  explicit Page(bool cull) : PiecewisePeer(cull ? "gl2ps-cull" : "gl2ps-sort"), cull_(cull) {}

  Outcome map(const Camera& camera, Want want) override {
    const bool list = cull_ && want == Want::visible;
    Outcome out;
    char* text = nullptr;
    std::size_t length = 0;
    std::FILE* stream = list ? open_memstream(&text, &length) : std::fopen("/dev/null", "w");
    if (stream == nullptr) return failure("no stream");
    const double start = cpu_seconds();
    project(*scene_, pieces_, camera, view_);
    GLint viewport[4] = {0, 0, width, width};
    const GLint options = GL2PS_BEST_ROOT | GL2PS_SILENT | GL2PS_NO_OPENGL_CONTEXT | GL2PS_NO_BLENDING |
                          GL2PS_NO_PS3_SHADING | (cull_ ? GL2PS_OCCLUSION_CULL : 0);
    // What is timed is the sorting: its LaTeX writer sorts as the others do and then writes text alone, of which there
    // is none.
    gl2psBeginPage("view", "compare", viewport, list ? GL2PS_SVG : GL2PS_TEX, GL2PS_BSP_SORT, options, GL_RGBA, 0,
                   nullptr, 0, 0, 0, 1 << 20, stream, "view");
    for (std::uint32_t k = 0; k < view_.size(); ++k) add(k);
    const GLint code = gl2psEndPage();
    out.seconds = cpu_seconds() - start;
    std::fclose(stream);
    if (code != GL2PS_SUCCESS) {
      out.status = Status::failed;
      out.note = "gl2ps's code " + std::to_string(code);
    } else if (list) {
      out.gives_visible = true;
      out.visible = colours({text, length});
    }
    std::free(text);
    return out;
  }

 private:
  void add(std::uint32_t k) const {
    const auto loop = view_.of(k);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      GL2PSvertex triangle[3];
      const glm::dvec3* corner[3] = {&loop[0], &loop[i], &loop[i + 1]};
      for (int c = 0; c < 3; ++c) {
        // As after OpenGL's transformation: pixels, and depth from 0 (near) to 1.
        triangle[c].xyz[0] = static_cast<float>(corner[c]->x * width);
        triangle[c].xyz[1] = static_cast<float>(corner[c]->y * width);
        triangle[c].xyz[2] = static_cast<float>(1 - corner[c]->z / view_.nearest);
        const PolygonId id = view_.polygon[k];
        for (unsigned byte = 0; byte < 3; ++byte) {
          triangle[c].rgba[byte] = (static_cast<float>((id >> (8 * byte)) & 255) + 0.5F) / 255.F;
        }
        triangle[c].rgba[3] = 1;
      }
      gl2psAddPolyPrimitive(GL2PS_TRIANGLE, 3, triangle, 0, 0, 0, 0, 0, 1, 0, 0, 0);
    }
  }

  /// The polygons of a page, told by their fills.
  static std::vector<PolygonId> colours(std::string_view svg) {
    constexpr std::string_view key = "<polygon fill=\"#";
    std::vector<PolygonId> out;
    for (std::size_t at = svg.find(key); at != std::string_view::npos; at = svg.find(key, at + 1)) {
      const unsigned long rgb = std::strtoul(std::string(svg.substr(at + key.size(), 6)).c_str(), nullptr, 16);
      out.push_back(static_cast<PolygonId>((rgb >> 16) | (rgb & 0xff00) | ((rgb & 0xff) << 16)));
    }
    std::ranges::sort(out);
    out.erase(std::ranges::unique(out).begin(), out.end());
    return out;
  }

  bool cull_;
  Projected view_;
};

}  // namespace

Methods make_gl2ps() {
  Methods all;
  all.push_back(std::make_unique<Page>(false));
  all.push_back(std::make_unique<Page>(true));
  return all;
}

}  // namespace sightline::peers
