#pragma once

#include <functional>
#include <span>
#include <vector>

#include "engine/contacts/contacts.h"
#include "hydro/spatial.h"

/// @file
/// The forces of contacts from one substep to the next: the constraint solver starts from them.
/// A body at rest on another then needs no more than a sweep.

namespace engine {

/// A force of the last substep at a point of contact.
struct ContactForce {
  Pair pair;
  Eigen::Vector3d place_B =
      Eigen::Vector3d::Zero();  ///< In the axes of the pair's second body [m].
  Eigen::Vector3d force_B = Eigen::Vector3d::Zero();  ///< On the first body, in the same axes [N].
};

/// The remembered forces of one pair.
/// @param memory   Its pairs ascend.
std::span<const ContactForce> forces_of(const Pair& pair, const std::vector<ContactForce>& memory);

/// State of a body; of one that cannot move any.
using StateOf = std::function<hydro::BodyState(BodyId)>;

/// The forces of contacts to remember for the next substep.
std::vector<ContactForce> remembered(const std::vector<Contact>& contacts, const StateOf& state_of);

/// Gives each contact the force that the nearest point of its pair had, or a part of that where the
/// pair has more points now; none to those of pairs that did not touch.
/// @param memory   Its pairs ascend, as those of the contacts do.
void recall(const std::vector<ContactForce>& memory, const StateOf& state_of,
            std::vector<Contact>& contacts);

}  // namespace engine
