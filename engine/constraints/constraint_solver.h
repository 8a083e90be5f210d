#pragma once

#include <vector>

#include "engine/constraints/constraint_block.h"

/// @file
/// Impulses of the joints, contacts, lines and drives of an island, with the whole 6×6 inertia of
/// each body.
///
/// Without impulses the bodies have the velocities u₀ after an update, with them
///
///     u = u₀ + S⁻¹ Σ Jᵀ p,                                                              (E36)
///
/// S⁻¹ being the inverse of the inertia in the velocities that locks leave to a body. The impulses
/// p are those with which (E8) holds for every block. Two ways are taken in turn:
///
///   a sweep       solves the blocks one after the other, in this order and in the next sweep in
///                 the opposite one, each exactly with its bounds (Gauss–Seidel);
///   a Newton step takes from the last impulses which rows are at a bound, and which way contacts
///                 slide, and solves the equations of all rows that follow from that at once.
///
/// Sweeps take a time that grows with the number of blocks and get nearer at a rate that falls with
/// the length of chains and the ratio of masses; a Newton step is exact as soon as it starts with
/// the right rows, whatever the masses, in a time that grows faster. So all islands but heaps of
/// more than kMostContactRows take a Newton step after the first sweep.
/// A Newton step counts only if the sweep after it moves the impulses by less than the sweep before
/// it. The measure of that is the energy of the change of velocities: impulses that keep each other
/// in balance, as those of many points of one face may, do not count. Nothing is random, and
/// islands do not know of each other.

namespace engine {

/// A body for the constraint solver.
struct ConstrainedBody {
  BodyId body = 0;
  Matrix6d inertia = Matrix6d::Zero();   ///< S, in W about the centre of mass.
  Matrix6d mobility = Matrix6d::Zero();  ///< S⁻¹
  Vector6d velocity = Vector6d::Zero();  ///< u₀
};

struct ConstraintSolution {
  std::vector<Vector6d> velocities;       ///< u
  std::vector<Eigen::Vector3d> impulses;  ///< p of the blocks.
  int sweeps = 0;
  bool converged = false;  ///< The last sweep changed the impulses by less than the tolerance.
};

/// @param bodies         Ascending. A block of which neither body is here has no effect.
/// @param start          Impulses to start from, as many as blocks; empty: none.
/// @param size           Root of the energy of the motion, which errors are measured by [√J].
ConstraintSolution solve_constraints(const std::vector<ConstrainedBody>& bodies,
                                     const std::vector<ConstraintBlock>& blocks,
                                     const std::vector<Eigen::Vector3d>& start, double size);

}  // namespace engine
