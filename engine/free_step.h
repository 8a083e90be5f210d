#pragma once

#include "engine/body.h"

/// @file
/// The step of a body that nothing holds, or one joint along a way (guide.h), and that touches
/// nothing.
///
/// A piece of length h is half a drift, a kick and half a drift (free_motion.h or guide.h; kick.h),
/// the added mass taken anew halfway (added_inertia.h): symmetric in time and of second order but
/// for impacts. Each part alone never adds energy, up to the difference between a load's work over
/// the piece and its value halfway. So a step is cut in pieces
/// - in which a body that crosses the water surface moves by no more than half its own height, and
///   turns by no more than half a radian while it is wet;
/// - in halves, if loads throw the body through the surface by more than kLongestLeap of its
/// height;
/// - in which a body that bobs or rocks goes through no more than a quarter of a radian of that;
/// - in still water, if the energy comes to be more than the lowest so far by twice kEnergyGain of
///   the greatest so far: in halves, down to kShortestHalf, and at the end the motion is slowed by
///   what is too much; each half is looked at again. Above once that, or where the body turns round
///   and round in a piece, the motion is slowed without more pieces. Where lift or applied loads
///   drive the body the energy is compared with that of the piece's start. Looked at are pieces in
///   which loads change suddenly or are stiff, and those of a wet body that turns far.
///
/// Equation (1) of kick.h makes pieces of second order, but for loads that hang on the pose alone
/// of the shape P N P⁻¹ with N of fourth order [R91]. Between two pieces P⁻¹ and P cancel; what is
/// left is to see the state after P. It is x − (h²/24) a, u + (h²/24) a' of the one that (1) moves
/// on,                                                                                      (2)
/// with a and a' from the last kicks, where these show a smooth motion (kick_history.h). So the
/// energy of a bobbing body neither drifts nor swings, and the rule above leaves it alone.
///
/// [R91] Rowlands. A numerical algorithm for Hamiltonian systems. J. Comp. Phys. 97 (1991).
///
/// With a tolerance the pieces are chosen from an estimate of the error (error_control.h).

namespace engine {

inline constexpr double kShortestHalf = 1.0 / 256;  ///< Of a step.
inline constexpr int kMostPieces = 64;              ///< By the first rule, in a step.

/// Length of the first of the equal pieces in which the rest of a step is to be taken [s].
double piece_length(const Body& body, const Surroundings& around, const Motion& motion, double rest,
                    double shortest);

/// Rate at which a body and its momentum turn by its own inertia and that of the water [rad/s].
double own_turning_rate(const Body& body, const Surroundings& around, const Motion& motion);

/// False if a body turns round and round in a piece of length h: halves of it would tell no more of
/// its energy.
bool can_be_followed(const Body& body, const Surroundings& around, const Motion& motion, double h);
inline constexpr double kFollowedTurn = 8;  ///< [rad]

/// True if loads have thrown a body through the water's surface, or from it or to it, by more than
/// kLongestLeap of its height in a time h [s]: they were not those on its way.
bool leaps(const Body& body, const Surroundings& around, const hydro::BodyState& before,
           const hydro::BodyState& after, double h);
inline constexpr double kLongestLeap = 2;

/// Takes a step of a body by itself, or a part of one.
/// @param shortest    What the energy may cut it to [s].
/// @param tolerance   Largest error of the pose in a second, as a part of the body's radius and in
///                    rad; 0: pieces are cut by the rules above alone.
void free_step(Body& body, const Surroundings& around, double time, double step, double shortest,
               double tolerance);

}  // namespace engine
