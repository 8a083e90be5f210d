#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "engine/contacts/broad_phase.h"

/// @file
/// The model of a contact: which points are kept where two bodies overlap, and their stiffness.
///
/// The points of a pair share one spring and damper, taken implicitly in time. Spring k = m/τ² and
/// damper c = 2 m/τ are critical for the mass m, the heavier one of the movable bodies, so overlap
/// decays within a few τ without bouncing. With the time step h, the constraint solver is given,
/// for each of n points,
///
///     ERP = h k / (α h k + w c)  = h / (α h + 2 w τ)                                     (E11)
///     CFM = 1 / (α h k + w c)    = n τ² / (m (α h + 2 w τ))
///     speed = −(1 − w) c v⁻ CFM/n = −2 (1 − w) τ v⁻ / (α h + 2 w τ)
///
/// which is the force k d − α h k v⁺ − c ((1 − w) v⁻ + w v⁺), where d is the depth and v⁻, v⁺ are
/// the speeds at which the point parts before and after the update. α = w = 1 is the force at the
/// end of the step: of first order, and stable for any h. Where d is the depth halfway through a
/// substep that is shorter than τ, the weights are
///
///     α = h/τ,    w = max(h/τ, 1/(1 − exp(−z)) − 1/z),    z = (c/n) h/µ,                 (E12)
///
/// of second order, as w tends to ½. µ is the mass that resists a push at the point: a damper on it
/// alone, far stiffer at a corner than one on the whole body, is then solved exactly.
///
/// A body that carries its own weight sinks in by g τ². With τ = max(h, kShortestContact) that is
/// 1 mm, whatever the body's size. Below 0.01 s τ does not follow h, so the motion converges as the
/// step is refined; above it does, as a spring shorter than a step is not resolved.
///
/// A contact in a stack of cubes of edge L is a joint with the stiffness m L²/(4 τ²) against
/// turning. The stack is a column of such joints: its own weight bends it [Gre81] if the number of
/// cubes is more than
///
///     (7.84 L/(4 g τ²))^(1/3).                                                          (E13a)
///
/// A body that one step has taken deep into another is pushed out no faster than
///
///     s = √(g depth/2):                                                                  (E13)
///
/// where it would part faster, the force is the one with which it parts at s. So it is left with a
/// quarter of the energy of a fall through the overlap, and does not hop; with the whole of it a
/// crate that lands at 3 m/s hops by a millimetre. A contact that is deep for what rests on it
/// parts from nothing, and carries all that its spring holds. Here g is the acceleration of the
/// mass m by weight and full buoyancy: less than gravity where a body moves much water. With the
/// lighter mass a body would sink deep into a lighter one; with the heavier one the contact of the
/// light body is overdamped, with the same ERP.
///
/// Friction is Coulomb's with the µ of the pair (contact_surfaces.h), in a pyramid whose first edge
/// lies along the sliding without it; so a body slides down the steepest way above atan µ, whatever
/// the heading of the slope. Its rows are regularised by
///
///     slip = kSlip h n / m,                                                              (E14)
///
/// by which a body on a slope creeps with less than kSlip g h [m/s], and which keeps the equations
/// of many points solvable.
///
/// A point rebounds, in place of the spring and damper, where it closes faster than (E15) and the
/// pair has a restitution e > 0, or where spring and damper would stop the bodies only beyond half
/// the thickness of the thinner one, kSink v τ, on their way through each other. Then
///
///     v⁺ = −e v⁻,    CFM = kSlip h n / m,                                                (E30)
///
/// Newton's law of restitution, regularised as friction is. In a substep that begins at the onset,
/// the positions at its two ends differ by the work of the weight over what v⁻ and v⁺ travel, so
/// with e = 1 a bounce keeps the energy for any h. Several impacts at once and friction may gain
/// energy under Newton's law; restitution.h takes that back.
///
/// [Gre81] Greenhill. Determination of the greatest height consistent with stability that a
///         vertical pole or mast can be made. Proc. Camb. Phil. Soc. 4 (1881) 65-73.

namespace engine {

/// A point where two bodies overlap.
struct ContactPoint {
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  ///< Unit, into the first body.
  double depth = 0;                                     ///< Depth of the overlap along it [m].
};

/// The points that are contacts.
///
/// Where two meshes overlap by a little, the faces beside the overlap cut each other too, and are
/// reported with their own normals and with depths as large as the body. Such a point lies in the
/// overlap of another contact that is less than a fifth as deep and has another direction: pushing
/// the bodies apart there removes both. A point more than twice as deep as the bodies' boxes
/// overlap is none either: where flat faces meet edge on edge, no valid point may be reported.
/// Points no deeper than `reach` are kept, points that just touch are not.
///
/// @param reach   Depth that the pair can have gathered in the last steps [m].
/// @param boxes   Least overlap of the boxes along the axes [m]; infinite for a sheet.
std::vector<ContactPoint> without_artefacts(const std::vector<ContactPoint>& points, double reach,
                                            double boxes);

/// The points that support a sphere: those that remain when it is pushed out of every deeper one.
///
/// On a mesh a sphere also overlaps the triangles beside the one that it lies on, and touches their
/// edges with normals that lean away from them. Such points would set it rolling on a flat floor;
/// pushed out of the deepest, it is out of them. In a valley both sides are kept.
std::vector<ContactPoint> supporting_a_sphere(std::vector<ContactPoint> points);

/// Indices of at most `most` points that represent all: the deepest, then repeatedly the point
/// farthest from those taken, in position and direction. The first of equal ones is taken.
std::vector<std::size_t> representative(const std::vector<ContactPoint>& points, std::size_t most);

/// The weights of (E12).
struct ContactWeights {
  double spring = 1;  ///< α
  double damper = 1;  ///< w
};
/// @param lightness   m/µ
ContactWeights halfway_weights(std::size_t points, double step, double lightness);

/// (E11) and (E14) for one point.
struct ContactStiffness {
  double erp = 0;    ///< [-]
  double cfm = 0;    ///< [m/(N s)]
  double speed = 0;  ///< For v⁻ = −1 [-]; of (E30) [m/s].
  double slip = 0;   ///< [m/(N s)]
  /// Speed at which the point parts, above which it is not pushed: (E13), or none [m/s].
  double fastest = std::numeric_limits<double>::infinity();
};
ContactStiffness contact_stiffness(double mass, std::size_t points, double step,
                                   const ContactWeights& weights = {});

/// A point of a contact for the constraint solver.
struct Contact {
  Pair pair;
  ContactPoint point;
  ContactStiffness stiffness;
  double friction = kFriction;                          ///< Coulomb's µ [-].
  double restitution = 0;                               ///< [-]
  bool rebounds = false;                                ///< (E30) holds.
  Eigen::Vector3d sliding_W = Eigen::Vector3d::Zero();  ///< Relative velocity without it [m/s].
  /// Force on the first body, in the axes W, that the solver has found or is to start from [N].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
};

/// Speed of (E15), above which touching is an impact [m/s].
double impact_speed(double gravity);

/// (E30) for one point.
/// @param rebound   The speed e v⁻ at which it parts [m/s].
ContactStiffness rebound_stiffness(double mass, std::size_t points, double step, double rebound);

/// (E13) [m/s]. @param fall   Acceleration by weight and buoyancy, over that of gravity.
double parting_speed(double depth, double fall, double gravity);

}  // namespace engine
