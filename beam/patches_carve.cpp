// Cutting a convex figure out of a patch: only the sides that touch the figure are looked at.
#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <stdexcept>

#include "beam/patches.hpp"
#include "exact/tally.hpp"

namespace sightline {

// Which of the figure's lines a corner lies behind, and which it lies on.
std::pair<std::uint32_t, std::uint32_t> Patches::places(std::uint32_t corner) {
  constexpr double bound = 64 * 0x1p-53;  // as in side_of
  Corner& c = corners_[corner];
  if (c.stamp == stamp_) return {c.behind, c.on};
  c.stamp = stamp_;
  const auto [ahead, behind] = outline_normals_.signs(c.ray, bound);
  c.behind = behind;
  c.on = 0;
  std::uint32_t unknown = outline_normals_.all(0) & ~(ahead | behind);
  tally().filter += outline_.size() - static_cast<std::size_t>(std::popcount(unknown));
  for (; unknown != 0; unknown &= unknown - 1) {
    const std::uint32_t bit = unknown & -unknown;
    const Sign sign = exact_side(c, outline_[static_cast<std::size_t>(std::countr_zero(unknown))].line);
    if (sign < 0) c.behind |= bit;
    if (sign == 0) c.on |= bit;
  }
  return {c.behind, c.on};
}

/// The corner in which outline line k meets the one before it.
std::uint32_t Patches::outline_corner(std::size_t k) {
  OutlineLine& l = outline_[k];
  if (l.corner == none) l.corner = make_corner(outline_[k == 0 ? outline_.size() - 1 : k - 1].line, l.line);
  return l.corner;
}

/// Where on the outline a ray of it is, by the lines that it is on: 2k + 1 on line k, 2k where line k begins.
std::uint32_t Patches::outline_place(std::uint32_t on) const {
  const auto k = static_cast<std::uint32_t>(std::countr_zero(on));
  const std::uint32_t rest = on & (on - 1);
  if (rest == 0) return 2 * k + 1;
  const auto j = static_cast<std::uint32_t>(std::countr_zero(rest));
  return j == k + 1 ? 2 * j : 2 * k;
}

namespace {

/// The last (or, of refs turned round, the first) of the rays in which a side meets some lines.
struct Meeting {
  std::size_t line = 0;
  std::uint32_t on = 0;  // all lines that pass there
};

}  // namespace

/// What a side of the patch and the closed figure have in common.
void Patches::meet(std::uint32_t index) {
  const FragmentSide side = sides_[index];
  const auto [from_behind, from_on] = places(side.from);
  const auto [to_behind, to_on] = places(side.to);
  if (from_behind & to_behind) return;
  const std::uint32_t along = from_on & to_on;
  // Along N, N x v comes after N x u where det(N, v, u) > 0; it enters line L in N x L and leaves it in N x -L.
  const auto later = [&](std::size_t a, Sign sa, std::size_t b, Sign sb) {
    SightlineRef u = outline_[a].line, v = outline_[b].line;
    u.sign *= sa;
    v.sign *= sb;
    return table_->order(side.line, v, u);  // 1: b's is later
  };
  const auto extreme = [&](std::uint32_t lines, Sign sense) {
    Meeting best;
    for (std::uint32_t rest = lines; rest != 0; rest &= rest - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(rest));
      const Sign sign = best.on == 0 ? 1 : sense * later(best.line, sense, k, sense);
      if (sign > 0) best = {k, 1u << k};
      if (sign == 0) best.on |= 1u << k;
    }
    return best;
  };
  Contact c{index, side.from, side.to, Contact::through, false};
  std::uint32_t on_from = from_on, on_to = to_on;  // the outline's lines that its ends are on
  bool at_end = false, at_start = false;
  Meeting entry, exit;
  if (from_behind != 0) {
    at_end = (from_behind & to_on) != 0;
    if (!at_end) entry = extreme(from_behind, 1);
    on_from = at_end ? to_on : entry.on | along;
  }
  if (to_behind != 0) {
    at_start = (to_behind & from_on) != 0;
    if (!at_start) exit = extreme(to_behind, -1);
    on_to = at_start ? from_on : exit.on | along;
  }
  if ((at_end && to_behind != 0) || (at_start && from_behind != 0)) return;
  bool point = at_end || at_start;
  if (entry.on != 0 && exit.on != 0) {
    const Sign sign = later(entry.line, 1, exit.line, -1);
    if (sign < 0) return;
    if (sign == 0) {
      point = true;
      on_from = on_to = entry.on | exit.on;
    }
  }
  const auto corner_at = [&](const Meeting& m, Sign sense, std::uint32_t on) {
    if (along != 0) return outline_corner(outline_place(on) / 2);  // it has the side's own line in its name
    const SightlineRef across = sense > 0 ? -side.line : side.line;
    return make_corner(across, outline_[m.line].line);
  };
  if (from_behind != 0) c.from = at_end ? side.to : corner_at(entry, 1, on_from);
  if (to_behind != 0) c.to = at_start ? side.from : point && !at_end ? c.from : corner_at(exit, -1, on_to);
  c.kind = point ? Contact::point : along == 0 ? Contact::through : Contact::along;
  if (along != 0) {
    const auto k = static_cast<std::size_t>(std::countr_zero(along));
    c.same = outline_[k].line.sign == side.line.sign;
  }
  const bool through = c.kind == Contact::through;
  const auto add = [&](std::uint32_t on, std::uint32_t corner, int sense, bool minus) {
    if (on == 0 || (!through && !minus)) return;
    rim_.push_back(
        {outline_place(on), sense > 0 ? side.line : -side.line, corner, through ? sense : 0, minus ? sense : 0});
  };
  add(on_from, c.from, -1, from_behind != 0);
  add(on_to, c.to, 1, to_behind != 0);
  contacts_.push_back(c);
}

/// Sorts what happens along the outline; what happens in one ray becomes one event. False: it cannot be told which
/// stretches of the outline lie in the patch.
bool Patches::settle_rim(int& plus, int& minus) {
  const auto before = [&](const RimEvent& a, const RimEvent& b) {
    if (a.place != b.place) return a.place < b.place;
    if (a.place % 2 == 0 || a.corner == b.corner || root(a.corner) == root(b.corner)) return false;
    return table_->order(outline_[a.place / 2].line, b.across, a.across) > 0;
  };
  for (std::size_t k = 1; k < rim_.size(); ++k) {
    const RimEvent event = rim_[k];
    std::size_t j = k;
    for (; j > 0 && before(event, rim_[j - 1]); --j) rim_[j] = rim_[j - 1];
    rim_[j] = event;
  }
  std::size_t kept = 0;
  for (const RimEvent& event : rim_) {
    if (kept != 0 && !before(rim_[kept - 1], event)) {
      RimEvent& last = rim_[kept - 1];
      if (last.corner != event.corner) unite(last.corner, event.corner);
      last.plus += event.plus;
      last.minus += event.minus;
    } else {
      rim_[kept++] = event;
    }
  }
  rim_.resize(kept);
  plus = minus = uncertain;
  for (const RimEvent& event : rim_) {
    if (event.plus != 0) plus = event.plus > 0 ? 1 : 0;
    if (event.minus != 0) minus = event.minus > 0 ? 1 : 0;
  }
  for (const Contact& c : contacts_) {
    if (c.kind != Contact::along) continue;
    if (plus == uncertain) plus = c.same ? 1 : 0;
    if (minus == uncertain) minus = c.same ? 0 : 1;
  }
  return plus != uncertain && minus != uncertain;
}

/// The corner of an event for sides along line k.
std::uint32_t Patches::rim_corner(RimEvent& event, std::size_t k) {
  if (event.place % 2 == 0) {
    const std::uint32_t corner = outline_corner(event.place / 2);
    unite(corner, event.corner);
    return corner;
  }
  const SightlineRef line = outline_[k].line;
  const FragmentCorner& name = corners_[event.corner].name;
  if (name.low == line.id || name.high == line.id) return event.corner;
  const std::uint32_t corner = make_corner(event.across, line);
  unite(corner, event.corner);
  return event.corner = corner;
}

/// For an outline that no side crosses or runs along: is all of it in the patch? By a corner that no side comes near.
bool Patches::outline_within(const Patch& patch, bool& known) {
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    const std::uint32_t corner = outline_corner(k);
    const bool within = odd(patch, corners_[corner].ray, known);
    if (known) return within;
  }
  return false;
}

/// Closes along the outline what lies in the patch on both sides of it.
void Patches::add_rim(int plus, int minus) {
  const std::size_t lines = outline_.size();
  if (rim_.empty() && plus > 0 && minus > 0) {
    for (std::size_t k = 0; k < lines; ++k) {
      const std::uint32_t from = outline_corner(k);
      caps_.push_back({outline_[k].line, from, outline_corner(k + 1 == lines ? 0 : k + 1)});
    }
  }
  for (std::size_t e = 0; e < rim_.size(); ++e) {
    RimEvent& here = rim_[e];
    RimEvent& next = rim_[e + 1 == rim_.size() ? 0 : e + 1];
    plus += here.plus;
    minus += here.minus;
    if (plus < 0 || plus > 1 || minus < 0 || minus > 1) throw std::logic_error("trace: a patch that is not closed");
    if (plus == 0 || minus == 0) continue;
    std::size_t k = here.place / 2;
    std::uint32_t from = rim_corner(here, k);
    // On the event's own line as far as its end, and so on to the line that the next event is on or ends; all the way
    // round if that is the same line and the next event is the first one, at the line's beginning excepted.
    const std::size_t last = next.place % 2 == 1 ? next.place / 2 : (next.place / 2 + lines - 1) % lines;
    const bool around = k == last && e + 1 == rim_.size() && next.place != 0;
    for (bool first = true; k != last || (first && around); k = k + 1 == lines ? 0 : k + 1, first = false) {
      const std::uint32_t to = outline_corner(k + 1 == lines ? 0 : k + 1);
      caps_.push_back({outline_[k].line, from, to});
      from = to;
    }
    caps_.push_back({outline_[k].line, from, rim_corner(next, k)});
  }
}

bool Patches::carve(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside) {
  outline_.clear();
  for (const SightlineRef line : lines) {
    if (!outline_.empty() && outline_.back().line.id == line.id) continue;
    outline_.push_back({line, none});
  }
  if (outline_.front().line.id == outline_.back().line.id) outline_.pop_back();
  outline_normals_.resize(outline_.size());
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    const SightlineRef line = outline_[k].line;
    outline_normals_.set(k, table_->approx(line.id) * static_cast<double>(line.sign));
  }
  if (outline_.size() > 32) return carve_by_lines(patch, lines, inside, outside);
  ++stamp_;
  contacts_.clear();
  rim_.clear();
  caps_.clear();
  for (const std::uint32_t side : near_) meet(side);
  int plus = 0, minus = 0;
  if (!settle_rim(plus, minus)) {
    bool known = plus == uncertain && minus == uncertain;
    if (known) plus = minus = outline_within(patch, known) ? 1 : 0;
    if (!known) return carve_by_lines(patch, lines, inside, outside);
  }
  add_rim(plus, minus);
  auto first = static_cast<std::uint32_t>(sides_.size());
  for (const Contact& c : contacts_) {
    if (c.kind == Contact::through || (c.kind == Contact::along && c.same)) {
      add_side(sides_[c.side].line, c.from, c.to);
    }
  }
  for (const FragmentSide& cap : caps_) add_side(cap.line, cap.from, cap.to);
  inside = since(first);
  if (inside.empty()) return false;
  outside = rest(patch);
  return true;
}

/// What the figure at hand leaves: the patch's own sides, but for those that touch it, in place where there is room.
Patch Patches::rest(Patch patch) {
  added_.clear();
  // Backwards, so that what comes from the end into a gap is a side that has been dealt with.
  for (auto contact = contacts_.rbegin(); contact != contacts_.rend(); ++contact) {
    const FragmentSide side = sides_[contact->side];
    bool kept = false;
    const auto keep = [&](std::uint32_t from, std::uint32_t to) {
      if (kept) {
        added_.push_back({side.line, from, to});
      } else {
        set_side(contact->side, {side.line, from, to});
        kept = true;
      }
    };
    // No side passes through a corner of another: it ends where it touches the figure, too.
    if (contact->from != side.from) keep(side.from, contact->from);
    if (contact->kind == Contact::along && !contact->same) keep(contact->from, contact->to);
    if (contact->to != side.to) keep(contact->to, side.to);
    if (kept) continue;
    const std::uint32_t last = patch.first + --patch.count;
    sides_[contact->side] = sides_[last];
    boxes_[contact->side] = boxes_[last];
  }
  for (const FragmentSide& cap : caps_) added_.push_back({-cap.line, cap.to, cap.from});
  const auto count = patch.count + static_cast<std::uint32_t>(added_.size());
  if (count > patch.room) {
    const auto first = static_cast<std::uint32_t>(sides_.size());
    patch.room = count + count / 2 + 8;
    sides_.resize(first + patch.room);
    boxes_.resize(first + patch.room);
    std::copy_n(sides_.begin() + patch.first, patch.count, sides_.begin() + first);
    std::copy_n(boxes_.begin() + patch.first, patch.count, boxes_.begin() + first);
    patch.first = first;
  }
  for (const FragmentSide& side : added_) set_side(patch.first + patch.count++, side);
  bound(patch);
  return patch;
}

/// The figure touches no side: it is cut out of the patch's interior.
void Patches::carve_within(const Patch& patch, std::span<const SightlineRef> lines, Patch& inside, Patch& outside) {
  caps_.clear();
  contacts_.clear();
  for (const SightlineRef line : lines) {
    if (caps_.empty() || caps_.back().line.id != line.id) caps_.push_back({line, none, none});
  }
  if (caps_.front().line.id == caps_.back().line.id) caps_.pop_back();
  for (std::size_t k = 0; k < caps_.size(); ++k) {
    FragmentSide& next = caps_[k + 1 == caps_.size() ? 0 : k + 1];
    caps_[k].to = next.from = make_corner(caps_[k].line, next.line);
  }
  const auto first = static_cast<std::uint32_t>(sides_.size());
  for (const FragmentSide& cap : caps_) add_side(cap.line, cap.from, cap.to);
  inside = since(first);
  outside = rest(patch);
}

}  // namespace sightline
