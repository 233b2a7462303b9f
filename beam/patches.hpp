// Patches of the view, bounded by pieces of sightlines. Internal to beam/.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "beam/cone.hpp"
#include "beam/frame.hpp"
#include "beam/places.hpp"
#include "beam/vector_pairs.hpp"
#include "visibility_map/fragment.hpp"

namespace sightline {

/// A region of the view that need be neither convex nor connected, by its boundary: sides in no order, each with its
/// inner side on the left as seen from the eye. No side passes through a corner of another.
struct Patch {
  std::uint32_t first = 0, count = 0;  // of Patches::sides
  std::uint32_t room = 0;              // how many sides it may have where it is
  FrameBox bounds;
  bool empty() const { return count == 0; }
};

/// The patches of one eye, which lie within an open half space before it. What is decided is the sign of three
/// sightlines, exactly; the boxes of corners and sides are conservative and spare most of it.
///
/// Corners that are one ray are known as such (`root`) within every patch: whichever cut makes a corner where the patch
/// has another finds that by its signs.
class Patches {
 public:
  /// Forgets all patches.
  void begin(const Scene& scene, SightlineTable& table, const Frame& frame, const ViewScale& scale);
  /// A convex patch by its lines, normals pointing inwards, in counter-clockwise order.
  Patch convex(std::span<const SightlineRef> lines);

  enum class Place { outside, inside, touched };
  /// Tells what a line was made of.
  void name_line(SightlineId line, const LineName& name);
  /// Where lies what is seen of a figure, its boundary aside? `touched`: it may be anywhere; `inside`: with its
  /// boundary. `bounds` hold it.
  Place look(const Patch& patch, const FrameBox& bounds, Cone& figure);
  Place look(const Patch& patch, const FrameBox& bounds, const TreeBox& figure) const;
  /// Cuts a convex figure out, the one just looked at, given by lines with normals pointing into it in
  /// counter-clockwise order: `inside` is what the two have in common, `outside` the rest. False: they have no interior
  /// in common. Else the patch is gone: its sides go over to the two.
  bool carve(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside);
  /// The same for a figure that is known to lie in the patch's interior, its lines in counter-clockwise order.
  void carve_within(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside);
  /// The parts in front of a line and behind it. False: one of them has no interior, and nothing was made.
  bool split(const Patch& patch, SightlineRef line, Patch& front, Patch& behind);
  /// That of the patch's lines which has the corners most evenly on its two sides, as far as doubles tell.
  SightlineRef middle_line(const Patch& patch) const;
  /// Is it one region whose boundary is a single loop? Else `other` is a side (of the patch, from 0) along which to
  /// split it first: one that is not on the loop of side 0 if there is one.
  bool simple(const Patch& patch, std::uint32_t& other);

  /// Its connected parts, holes and all. False where doubles do not tell which loop is a hole, and in what.
  bool connected_parts(const Patch& patch, std::vector<Patch>& parts);

  /// Takes away the parts that lie between a line and another that is less than `angle` (radians, below 0.01) off, as
  /// far as they are loops by themselves, and appends them to `slivers`. Gives a bound on their solid angle.
  double part_slivers(Patch& patch, double angle, std::vector<Patch>& slivers);

  std::span<const FragmentSide> sides(const Patch& p) const { return std::span(sides_).subspan(p.first, p.count); }
  const FrameBox& box(std::uint32_t side) const { return boxes_[side]; }

  /// Adds a simple patch to the fragments.
  void see(const Patch& patch, std::span<const SurfaceId> on, Fragments& out);
  /// Tells the fragments which of the corners that they were given are one ray.
  void tell_same(Fragments& out);

 private:
  struct Corner {
    FragmentCorner name;
    PlaceName place;  // which is seen here
    glm::dvec3 ray;   // the product of the rounded normals
    FrameBox box;
    std::uint32_t parent;              // towards the root of its ray
    std::uint32_t stamp = 0;           // the line, or outline, last looked at
    Sign sign = 0;                     // its side of that line
    std::uint32_t behind = 0, on = 0;  // which lines of that outline it is behind, and on: a bit each
    std::uint32_t walk = 0, at = 0;    // the walk last looked at, and the side that begins here
    std::uint32_t out = none;          // in the fragments
  };
  /// A piece of a side of the patch at hand, or (origin none) of a line that cuts it.
  struct Part {
    SightlineRef line;
    std::uint32_t from, to;
    std::uint32_t origin;
    Sign at_from, at_to;
  };
  /// Where the boundary of the patch at hand meets a line: the ray n_line x n_across. `plus` and `minus` tell what
  /// begins (1) or ends (-1) here, along the line, of the patch in front of it and behind it.
  struct Event {
    SightlineRef across;
    std::uint32_t corner;
    bool named;  // the corner has the line in its name
    int plus, minus;
  };
  struct Crossing {
    std::uint32_t corner, origin;
  };

  bool odd(const Patch& patch, const glm::dvec3& ray, bool& known) const;
  bool keeps_away(const FragmentSide& side, Cone& figure, bool& within) const;
  bool parted(const FragmentSide& side, Cone& figure) const;
  Sign exact_side(const Corner& corner, SightlineRef line) const;
  Sign exact_side(const Corner& corner, Cone& figure, std::uint32_t k) const;
  /// A line of the figure's outline; `corner`, once it is needed, is where it begins.
  struct OutlineLine {
    SightlineRef line;
    std::uint32_t corner;
  };
  /// What a side of the patch and the closed figure have in common: its part between two corners.
  struct Contact {
    std::uint32_t side, from, to;
    enum Kind : std::uint8_t { point, along, through } kind;
    bool same;  // along: the patch lies on the figure's side of it
  };
  /// Where a side of the patch meets the outline; otherwise as Event.
  struct RimEvent {
    std::uint32_t place;
    SightlineRef across;
    std::uint32_t corner;
    int plus, minus;
  };
  /// A loop of a patch's boundary. Narrow: within `width` (a sine) of `line`, and no longer than `length` (radians).
  struct Loop {
    std::uint32_t first, count;  // in loop_sides_
    double width = 0, length = 0;
    SightlineRef line{};
    enum Kind : std::uint8_t { wide, narrow, narrow_hole, parted } kind = wide;
  };
  bool index_sides(const Patch& patch, std::uint32_t& again);
  bool find_loops(const Patch& patch);
  void add_loop(const Loop& loop);
  double loop_area(const Loop& loop) const;
  std::size_t loop_around(const Loop& hole, std::span<const Patch> outer) const;
  void measure(Loop& loop, double narrow);
  bool in_strip(const Loop& loop, const Loop& strip) const;
  std::pair<std::uint32_t, std::uint32_t> places(std::uint32_t corner);
  std::uint32_t outline_corner(std::size_t k);
  std::uint32_t outline_place(std::uint32_t on) const;
  void meet(std::uint32_t side);
  bool settle_rim(int& plus, int& minus);
  bool outline_within(const Patch& patch, bool& known);
  std::uint32_t rim_corner(RimEvent& event, std::size_t k);
  void add_rim(int plus, int minus);
  bool carve_by_lines(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside);

  std::uint32_t root(std::uint32_t corner);
  void unite(std::uint32_t a, std::uint32_t b);
  std::uint32_t make_corner(SightlineRef across, SightlineRef line);
  Sign side_of(std::uint32_t corner, SightlineRef line, const glm::dvec3& normal);
  void take_up(const Patch& patch);
  int classify(SightlineRef line);
  void clip(SightlineRef line, std::vector<Part>* behind);
  void add_event(const Part& part, SightlineRef line, bool begins, std::uint32_t corner, bool plus, bool minus);
  void add_caps(SightlineRef line);
  void add_sorted_caps(SightlineRef line);
  std::uint32_t named_corner(std::size_t first, std::size_t end, SightlineRef line);
  void add_side(SightlineRef line, std::uint32_t from, std::uint32_t to);
  void set_side(std::uint32_t at, const FragmentSide& side);
  Patch rest(Patch patch);
  void bound(Patch& patch) const;
  void add_stops();
  void add_remainder(const FragmentSide& side, const FrameBox& box, std::uint32_t origin);
  Patch since(std::uint32_t first) const;

  const Scene* scene_ = nullptr;
  SightlineTable* table_ = nullptr;
  const Frame* frame_ = nullptr;
  ViewScale scale_;
  std::vector<Corner> corners_;
  std::vector<LineName> line_names_;  // by line
  std::vector<FragmentSide> sides_;
  std::vector<FrameBox> boxes_;  // of the sides
  std::uint32_t stamp_ = 0, walk_ = 0;
  std::vector<Loop> loops_, holes_;  // of the patch at hand
  std::vector<double> outer_area_;
  std::vector<std::size_t> owner_;  // of the holes
  std::vector<std::uint32_t> loop_sides_;
  // The figure at hand.
  std::vector<std::uint32_t> near_;  // sides of the patch that may touch it
  std::vector<OutlineLine> outline_;
  VectorPairs outline_normals_;
  std::vector<Contact> contacts_;
  std::vector<RimEvent> rim_;
  std::vector<FragmentSide> caps_, added_;
  // The cut at hand.
  std::vector<Part> parts_;
  std::vector<Event> events_;
  std::vector<Crossing> crossings_;
  std::vector<Part> behind_;
  std::vector<std::uint32_t> part_of_;  // by side of the patch
  std::vector<Crossing> stops_;         // where a side outside must end all the same
  bool ties_ = false;                   // corners were found to be one ray
  std::vector<std::uint32_t> given_;    // corners that are in the fragments
};

}  // namespace sightline
