#include "engine/record/constraint_errors.h"

#include <algorithm>

#include "engine/constraints/joint_rows.h"
#include "engine/contacts/contacts.h"

namespace engine {

void Peak::raise(double new_value, double at) {
  if (new_value > value) *this = {.value = new_value, .time = at};
}

void add_overlaps(const std::vector<Contact>& contacts, double time,
                  std::vector<Overlap>& overlaps) {
  const Pair* last = nullptr;
  for (const Contact& contact : contacts) {
    if (!last || *last != contact.pair) overlaps.push_back({.pair = contact.pair, .time = time});
    last = &contact.pair;
    overlaps.back().depth = std::max(overlaps.back().depth, contact.point.depth);
  }
}

void ConstraintErrors::add(const std::vector<Overlap>& found) {
  for (const Overlap& overlap : found) overlaps[overlap.pair].raise(overlap.depth, overlap.time);
}

void ConstraintErrors::add(const std::vector<JointFrames>& frames,
                           const std::vector<hydro::BodyState>& states, double time) {
  const auto state = [&](BodyId id) { return id == kWorld ? hydro::BodyState{} : states[id]; };
  for (const JointFrames& frame : frames) {
    const JointGap gap = gap_of(frame, state(frame.bodies[0]), state(frame.bodies[1]));
    JointError& joint = joints[frame.index];
    joint.separation.raise(gap.separation, time);
    joint.turn.raise(gap.turn, time);
  }
}

}  // namespace engine
