#pragma once

#include <map>
#include <vector>

#include "engine/contacts/broad_phase.h"

/// @file
/// The largest errors of constraints so far: how deep bodies have overlapped where they touch, and
/// how far joints have come apart. They are a part of the state of a simulation, and no motion
/// depends on them.

namespace engine {

struct Contact;
struct JointFrames;

/// The largest value of a quantity so far, which is not negative.
struct Peak {
  double value = 0;  ///< Largest value so far, >= 0.
  double time = 0;   ///< When it was reached [s].

  /// Takes a value at a time [s] if it is larger.
  void raise(double new_value, double at);
};

/// The largest depth of the points at which a pair touches, at an instant.
struct Overlap {
  Pair pair;         ///< The two bodies; kWorld is the ground.
  double depth = 0;  ///< [m]
  double time = 0;   ///< [s]
};

/// Adds the overlap of each pair. @param contacts   The contacts of a pair follow each other.
void add_overlaps(const std::vector<Contact>& contacts, double time,
                  std::vector<Overlap>& overlaps);

/// The largest errors of a joint.
struct JointError {
  Peak separation;  ///< Distance of the points that should coincide [m].
  Peak turn;        ///< Between the axes or bodies, beside what the joint leaves free [rad].
};

/// The largest errors of all pairs and joints.
struct ConstraintErrors {
  /// The overlaps of pairs that have touched [m], halfway through substeps.
  std::map<Pair, Peak> overlaps;
  std::vector<JointError> joints;  ///< At the ends of steps, in the order of the specification.

  /// Adds overlaps.
  void add(const std::vector<Overlap>& found);
  /// Adds those of joints in a state. @param frames   All joints that can have an error.
  void add(const std::vector<JointFrames>& frames, const std::vector<hydro::BodyState>& states,
           double time);
};

}  // namespace engine
