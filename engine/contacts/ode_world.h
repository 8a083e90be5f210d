#pragma once

#include <functional>

#include "engine/contacts/contacts.h"
#include "engine/contacts/ode_handles.h"
#include "hydro/spatial.h"

/// @file
/// Bodies and contacts in a world of ODE, and its own step.

namespace engine {

/// Joins two bodies by a contact; null stands for what does not move.
void add_contact(dxWorld* world, dxJointGroup* group, const Contact& contact, dxBody* first,
                 dxBody* second);

/// Puts an ODE body in a state.
void place(dxBody* body, const hydro::BodyState& state);

/// Sets the mass of an ODE body, and its inertia in B about the centre of mass.
void set_mass(dxBody* body, double mass, const Eigen::Matrix3d& inertia_B);

/// Takes a step of an ODE world by the exact solver. Where constraints contradict each other, it
/// gives up, and the iterative solver finds a compromise.
/// @param restart   Makes the bodies ready for the step once more.
/// @return true for a compromise.
/// @throws OdeFault
bool step_or_fall_back(dxWorld* world, const std::function<void()>& restart, double step);

}  // namespace engine
