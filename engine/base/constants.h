#pragma once

#include <cstddef>

/// @file
/// Every tolerance of the stepping, its unit, and the effect of changing it. Each was chosen by
/// measurement (tests/benchmarks/README.md, tests/stress/README.md); "step" is the scene's step.

namespace engine {

// ── Length of a substep (substep_limit.h) ───────────────────────────────────────────────────────

/// Largest turn of a wet body in a substep [rad]. Larger: loads halfway miss those on the way.
inline constexpr double kLargestWetTurn = 0.5;
/// Largest rise through the water surface in a substep, over the body's height [-]. Larger: entry
/// and exit are missed.
inline constexpr double kLargestCrossing = 0.5;
/// Largest phase of a resolved oscillation in a substep [rad]. Larger: its phase error grows as the
/// square; smaller: floating bodies cost more.
inline constexpr double kLargestSwing = 0.25;
/// Least amplitude per substep, over the radius, for which an oscillation is resolved [-].
inline constexpr double kSmallestSwing = 1e-6;
/// Shortest substep that an oscillation asks for, over the step [-].
inline constexpr double kShortestSwing = 1.0 / 8;
/// Largest turn, by its own inertia, of a body under joints or contacts in a substep [rad]. Larger:
/// chains that whip lose energy, since the solver of their joints does not see that turn.
inline constexpr double kLargestConstrainedTurn = 0.25;
/// Substeps that the motion can ask for in a step [-]. More: bodies that spin fast cost more.
inline constexpr int kMostSubsteps = 64;
/// First substeps of a motion without history, over the step [-]. They are of lower order.
inline constexpr double kStartingPart = 1.0 / 8;
/// Shortest substep that energy or tolerance ask for, over the step [-]. Smaller: stiff motions are
/// halved more often before they are clamped.
inline constexpr double kShortestPart = 1.0 / 256;
/// Shortest substep that the energy or a tolerance asks for in a group under constraints, over the
/// step [-]. Smaller: chains that spin solve their constraints thousands of times in a step.
inline constexpr double kShortestConstrainedPart = 1.0 / 32;
/// Rest of a step that may be left out, over the step [-]: the round-off of a sum of substeps.
inline constexpr double kRoundOffPart = 1e-12;

// ── Which substeps are judged (substep.h, energy_limiter.h) ─────────────────────────────────────

/// Change of velocity beyond the extrapolated one, over the velocity, that is abrupt [-]. Larger:
/// bodies that dip into the water gain more than kEnergyGain before they are judged.
inline constexpr double kAbruptLoad = 1e-3;
/// Turn of a wet free body in a substep from which on it is judged [rad]. Larger: a needle that
/// starts slowly and is then turned fast by its added mass gains more than kEnergyGain.
inline constexpr double kJudgedTurn = 0.1;
/// Rise through the water surface in a substep, over the height, that is abrupt [-].
inline constexpr double kAbruptCrossing = 0.1;
/// Rise by loads through the water surface, over the height, after which a substep is halved [-].
/// Larger: plates a twentieth of a millimetre thick that spin in a swell are thrown out of it.
inline constexpr double kLargestOvershoot = 1;
/// Change of added mass in a substep, over the inertia, after which it is halved [-]. Larger:
/// crates that fall on the water nearly flat are off by tens of millimetres; smaller: many in a
/// storm take a third longer, for no less error.
inline constexpr double kLargestAddedChange = 0.25;
/// Turn in a substep beyond which halves find a body's energy no better [rad].
inline constexpr double kFollowedTurn = 8;
/// Phase per substep below which those of a jointed group, or of a body in the water surface, are
/// not judged [rad].
inline constexpr double kSmoothSwing = 0.3;
/// Half the energy gain that still water may give, over the largest energy so far [-]. Larger:
/// light bodies bounce on the surface; smaller: resolved motions are slowed.
inline constexpr double kEnergyGain = 2.5e-4;

// ── Drift by inertia (free_motion.h) ────────────────────────────────────────────────────────────

/// Largest turn, or change of direction of the momentum, in one application of (E2) [rad]. Larger:
/// its phase error grows as the square.
inline constexpr double kLargestTurn = 0.1;
inline constexpr double kLargestSolvedTurn = 1;  ///< Beyond it (E2) is not solved but halved [rad].
inline constexpr int kMostDriftParts = 1024;     ///< Applications of (E2) in a drift.
inline constexpr int kMostDriftHalvings = 6;     ///< Halvings of one that does not converge.
inline constexpr int kMostDriftSolves = 40;      ///< Substitutions in an application of (E2).
/// Part of the residual that a substitution leaves, beyond which Newton's method is taken [-].
inline constexpr double kSlowConvergence = 0.1;
/// Square of half a turn below which the series of sine and cosine are exact [rad^2].
inline constexpr double kShortTurn = 0.01;
inline constexpr double kDriftConverged = 1e-15;   ///< Residual of (E2) over the momentum [-].
inline constexpr double kDriftRoundOff = 1e-12;    ///< The same for ill-conditioned inertia [-].
inline constexpr double kDriftEnergyKept = 1e-9;   ///< Change of energy where that is missed [-].
inline constexpr double kLockedEnergyKept = 1e-3;  ///< Change of (E3a) in a part of a drift [-].

// ── Update of the velocity (velocity_update.h) ──────────────────────────────────────────────────

/// Stiffness ζ of the drag above which the update is implicit [-]. Explicit is stable below ½.
inline constexpr double kStiffDrag = 0.3;
/// (h ω)² of the waterplane above which the update is implicit [-]. Explicit is stable below 4.
inline constexpr double kStiffWaterplane = 0.5;
/// Change of velocity that extrapolation may miss, over the larger of both, before loads are found
/// a second time [-].
inline constexpr double kPredicted = 0.3;
/// Largest shift of the pose in (E5), over the radius [-]. Oscillations that a substep resolves
/// need less.
inline constexpr double kLargestShift = 0.02;
inline constexpr int kMostNewtonSteps = 30;       ///< Newton steps of an implicit update.
inline constexpr double kNewtonTolerance = 1e-3;  ///< Last step over the change of velocity [-].
inline constexpr double kNewtonRoundOff = 1e-12;  ///< Last step over the velocity [-].
/// A Newton step so much larger than the shortest before it diverges: the next ones would square it
/// [-].
inline constexpr double kNewtonDivergence = 1e3;

// ── Added mass at the end of a substep (body.h) ─────────────────────────────────────────────────

/// Updates until the added mass agrees with the final pose: of a free body, and of an island under
/// constraints, which each update solves anew.
inline constexpr int kMostFreePasses = 3;
inline constexpr int kMostConstrainedPasses = 2;
/// Difference of two added masses, over the inertia, that another update need not take up [-]. The
/// motion goes on with the one that the update was taken with, so none is lost between them.
inline constexpr double kEqualAddedMass = 1e-5;
/// Estimated difference, over the inertia, that is not looked at [-]. It must be well below the
/// other, as the added mass may change faster in other directions than in that of the motion.
inline constexpr double kForeseenAddedMass = 1e-6;
/// Difference after the last update, over the inertia, without effect on the energy [-].
inline constexpr double kUnmatchedAddedMass = 1e-4;

// ── History of accelerations (acceleration_history.h) ───────────────────────────────────────────

/// Error of extrapolation, over the largest acceleration, of a motion that is resolved [-].
inline constexpr double kResolved = 0.25;
/// Decay of the remembered dominant frequency in a substep [-]. Smaller: it does not bridge the
/// half period between two peaks of acceleration.
inline constexpr double kFrequencyKept = 0.9;
/// Turn in a substep beyond which accelerations in body axes tell no trend [rad]. Larger: those of
/// a body that turns a whole number of times seem to follow one another, and a shell of 0.2 mm at
/// 17,000 rad/s flies off at 25 m/s.
inline constexpr double kLargestTrendTurn = 1;

// ── Water in pockets (carried_water.h, pocket_search.h) ──────────────────────────

/// Cosine of the angle between the verticals of two attitudes that have the same pockets [-]: 8°.
/// Smaller: pockets are searched for more often.
inline constexpr double kKnownAttitude = 0.9903;
/// Halvings of the way in a substep on which a body leaves its known attitudes [-]. Fewer: what is
/// found there depends on the length of the substep.
inline constexpr int kAttitudeBisections = 40;
/// Difference of spill heights over the radius, and of volumes over that of the box, up to which
/// pockets are kept [-]. Smaller: hulls with rounded rims are divided anew more often.
inline constexpr double kKeptSpill = 1e-3;
inline constexpr double kKeptVolume = 5e-4;  ///< The same of volumes, over that of the box [-].
/// Difference of the levels on the sides of a sill, over the depth of the sea above it, up to which
/// a full pocket is part of the sea [-].
inline constexpr double kJoinedHead = 0.25;
/// Water in a pocket, over its capacity or the cube of the radius, that is none [-].
inline constexpr double kLastWater = 1e-12;
/// Pressure of the atmosphere on trapped air [Pa].
inline constexpr double kAtmosphere = 101325;
/// Parts in which water runs for a substep in which a sill or opening crosses its surface, or
/// nearly does, or a pocket becomes a part of the sea [-]. Fewer: what runs depends more on the
/// substep.
inline constexpr int kWaterParts = 8;
/// Change of the water's mass in a substep, over the inertia, after which accelerations so far tell
/// nothing of the next ones [-].
inline constexpr double kMassJump = 0.01;
/// Cosine of the turn after which the water's mass has another place in the body [-].
inline constexpr double kKeptMassTurn = 0.5;

// ── Constraints (constrained_update.h, constraint_solver.h) ─────────────────────────────────────

inline constexpr int kMostLinearisations = 6;  ///< Linearisations of the loads in an update.
/// Energy that a linearisation misses, over the least so far, after which it is the last [-].
inline constexpr double kNewtonDiverged = 1e4;
inline constexpr int kFullNewtonSteps = 3;  ///< Later linearisations take half steps.
// Change of the velocities by a sweep, as the root of its energy over that of the motion [-]:
/// An island under joints or lines is solved below it. Larger: joints drift.
inline constexpr double kSolvedIsland = 1e-9;
/// One under contacts alone is. Smaller: Newton steps alternate about a point that begins to slide.
inline constexpr double kSolvedContacts = 1e-6;
/// A heap, of more contacts than take Newton steps, is. Smaller: it takes all of its sweeps.
inline constexpr double kSolvedHeap = 1e-4;
/// An island counts as not solved above it.
inline constexpr double kToleratedResidual = 1e-3;
inline constexpr int kMostSweeps = 40;  ///< Sweeps for one linearisation of the loads.
/// The same of contacts alone, the miss of which is not accepted yet.
inline constexpr int kMostHeapSweeps = 120;
inline constexpr int kSweepsOfContacts = 20;  ///< Between Newton steps in islands of contacts.
inline constexpr int kSweepsOfJoints = 10;    ///< The same where joints or lines act.
/// Change by a pair of sweeps over that by the last pair, below which acceleration has led nearer
/// and above which a long stride has led too far [-].
inline constexpr double kAndersonBelow = 0.7;
inline constexpr double kRestartAbove = 1.5;
inline constexpr int kMostRowSteps = 5;  ///< Newton steps in a row.
/// Rows of an island that takes Newton steps: with joints or lines, and with contacts alone.
inline constexpr std::size_t kMostNewtonRows = 6000;
inline constexpr std::size_t kMostContactRows = 600;
/// Rows of a system that is solved as a dense one; and where all rows are of joints.
inline constexpr int kMostDenseRows = 400;
inline constexpr int kMostDenseBilateralRows = 24;
/// Least compliance of a row, over the response of its block to its impulses [-]. Smaller: joints
/// that constrain the same motion twice are not solvable; larger: joints give way.
inline constexpr double kLeastCompliance = 1e-11;
inline constexpr std::size_t kAndersonDepth = 12;  ///< Differences that Anderson keeps.
/// Error of joints at the end of a substep that is none, over the radius of the smaller body [-].
inline constexpr double kClosedJoint = 1e-10;
/// Rate of the error of joints that is none, over those that their bodies' velocities could make
/// [-].
inline constexpr double kStoppedJoint = 1e-10;
/// Newton steps that close joints, and halvings of one that does not lead nearer.
inline constexpr int kMostClosings = 10;
inline constexpr double kLargestClosingTurn = 0.5;  ///< Turn of a body in one [rad].
inline constexpr int kMostDiskSteps = 6;            ///< Newton steps for a friction at its limit.
inline constexpr double kDiskError = 1e-6;          ///< Excess of such a friction, then taken [-].

// ── Lines and drives (rig.h, force_row.h) ───────────────────────────────────────────────────────

/// h² k + 2 h c over the mass, above which a line or drive is taken implicitly [-]. Explicit is
/// stable below 4.
inline constexpr double kStiffLine = 0.5;
/// Largest phase per step of two bodies on a taut line with inertia, which each of them feels
/// without the other's part in the step [rad]: momentum is kept to a tenth in a jerk.
inline constexpr double kMostLinePhase = 0.5;
/// Phase per step up to which a stiff line follows an oscillation, and from which on it takes it
/// away [rad].
inline constexpr double kResolvedLine = 0.7;
inline constexpr double kUnresolvedLine = 2;
/// Tension found, over that for which lateral inertia was added, after which more is added [-].
inline constexpr double kTensionExcess = 1.5;
/// Solutions of an island for that in a substep. Fewer: ropes throw a body a millionth as heavy as
/// the one that it holds.
inline constexpr int kMostTensionSolves = 4;
/// Compliance of a stop or motor, times the mass that it holds, over a substep [-].
inline constexpr double kRowCompliance = 1e-9;

// ── Contacts (contacts.h) and impacts (impacts.h) ───────────────────────────────────────────────

inline constexpr double kFriction = 0.5;           ///< Coulomb's µ where none is given [-].
inline constexpr double kShortestContact = 0.01;   ///< Least time τ in which overlap decays [s].
inline constexpr double kLeastGravity = 1;         ///< In (E11) and (E15) [m/s^2].
inline constexpr std::size_t kContactsOfPair = 8;  ///< Points kept where a mesh touches.
inline constexpr std::size_t kContactsOfFace = 4;  ///< Points kept of boxes and planes.
/// Creep on a slope is below this times g h [-]. Zero makes many points unsolvable.
inline constexpr double kSlip = 1e-6;
/// First substep after an impact, over the contact's time [-], and growth of those after it.
inline constexpr double kFirstAfterImpact = 1.0 / 32;
inline constexpr double kImpactGrowth = 1.2;
/// Onset of an impact, over that first substep, that counts as the start of the substep [-].
inline constexpr double kImpactBegun = 1.0 / 8;
/// Pairs of a group that touch, beyond which impacts do not shorten its substeps. Larger: heaps of
/// hundreds of bodies cost more, for no better error than a shorter step has in the same time;
/// smaller: heaps of tens of bodies are off by five times as much.
inline constexpr std::size_t kMostImpactPairs = 256;
/// The same of a group under joints. Larger: bodies that start inside each other under joints that
/// contradict each other may be thrown with more than their overlaps hold.
inline constexpr std::size_t kMostJointedImpactPairs = 4;
inline constexpr int kMostImpacts = 4;       ///< Impacts in a step of a group that end a substep.
inline constexpr int kMostOnsetQueries = 4;  ///< Collisions to find the onset of an impact.
/// Time past a known onset at which bodies are looked at again, over the one that counts as the
/// start of a substep [-]. Zero: round-off decides whether, and where, bodies touch at the onset.
/// Larger: onsets run together, and at 1 twelve crates afloat are off by nearly twice as much.
inline constexpr double kPastOnset = 1e-3;
/// Gain of energy by restitution, over the work of the impact's reactions, that is round-off [-].
inline constexpr double kImpactGain = 1e-9;
/// Work that the reactions of an island that is not solved may do in a substep, over the energy of
/// the motion and of what loads give it [-].
inline constexpr double kUnsolvedWork = 0.01;
/// Motion of a pair in a step after which an impact may throw bodies far, over the thickness of the
/// thinner one [-]. Smaller: groups of fast bodies are larger, and take short substeps together.
inline constexpr double kFarImpact = 2;
inline constexpr int kImpactRounds = 3;  ///< Bodies in a row, each thrown by the one before.
/// Substeps of a step, per body of a group, that end where bodies would pass through each other.
/// Later ones pass.
inline constexpr int kMostPassings = 16;
/// Boxes and collisions of a step, per body of a group, by which passings are looked for. More:
/// bodies that skim a rough ground for metres in a step, or that spin thousands of times in one,
/// cost more, and fewer of their contacts are missed.
inline constexpr int kMostPassingQueries = 2048;
/// Motion between two places in which bodies are collided to find a passing, and the error of its
/// onset, over half the thinner body's thickness [-]. Beyond 1 a body may pass between two places.
inline constexpr double kPassingInterval = 0.5;
inline constexpr double kPassingError = 1.0 / 32;
/// Depth of a contact at rest, over the thickness of the thinner body [-]. Larger: stacks sink in;
/// smaller: bodies that turn on each other lose contact within a substep, and meet anew.
inline constexpr double kContactDepth = 4e-4;
/// Time in which overlap decays, over the substep or kShortestContact [-]. Nearer to 1: in steps of
/// 1/15 s a crate under a hundred times its weight hops; it does under a thousand times.
inline constexpr double kContactRecovery = 1.5;
/// Compliance of a contact along its normal, over its response to its own impulse [-]. Larger:
/// bodies under a hundred times their weight sink in; smaller: which of the points of a face carry
/// is not found.
inline constexpr double kContactCompliance = 1e-4;
/// Reach of trusted contact points, in steps of the relative motion [-].
inline constexpr double kReachInSteps = 3;
/// Margin of broad-phase boxes, over their longest side [-]. Larger: fewer searches, more pairs.
inline constexpr double kBroadPhaseMargin = 0.25;

// ── ODE (world.h, ode_world.h) ──────────────────────────────────────────────────────────────────

/// Part of a joint's misalignment that a step removes [-]. The step is solved exactly, so a large
/// part is stable.
inline constexpr double kJointErp = 0.8;
/// Compliance of joints and locks in ODE's own step, times the smallest and the largest inertia in
/// the world, masses and moments alike as numbers in SI [s]. The first makes joints solvable that
/// constrain the same motion twice; the second bounds the sinking of the heaviest body's joint to
/// 1e-6 g h [m].
inline constexpr double kComplianceOfLightest = 1e-12;
inline constexpr double kComplianceOfHeaviest = 1e-6;
inline constexpr int kFallbackIterations = 200;  ///< Where ODE's exact solver gives up.

// ── Input (state_checks.h, body_check.h, pull.h) ────────────────────────────────────────────────

/// Largest coordinate, speed and angular speed of a body [m, m/s, rad/s]. Beyond it round-off of
/// coordinates exceeds 1e-7 m.
inline constexpr double kLargestState = 1e9;
inline constexpr double kInertiaTolerance = 1e-6;  ///< Asymmetry, or excess of one moment [-].
inline constexpr double kUnitTolerance = 1e-9;     ///< Error of the length of a quaternion [-].
/// Largest rate of a pull, times the step [-]: the explicit update allows ½ of twice the rate.
inline constexpr double kFastestPull = 0.2;

}  // namespace engine
