#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/constants.h"

/// @file
/// The model of a contact: what is kept of the points where two bodies overlap, and how stiff they
/// are.
///
/// The points of a pair share one spring and damper between them, taken implicitly in time. Spring
/// k = m/τ² and damper c = 2 m/τ are critical for the mass m, the heavier of the two bodies that
/// can move, so that overlap decays within a few τ and does not bounce. With the time step h the
/// constraint solver is given, for each of n points,
///
///     ERP = h k / (α h k + w c)  = h / (α h + 2 w τ)                                     (E11)
///     CFM = 1 / (α h k + w c)    = n τ² / (m (α h + 2 w τ))
///     speed = −(1 − w) c v⁻ CFM/n = −2 (1 − w) τ v⁻ / (α h + 2 w τ)
///
/// that is the force k d − α h k v⁺ − c ((1 − w) v⁻ + w v⁺), where d is the depth and v⁻, v⁺ the
/// speeds at which the point parts before and after the update. With α = w = 1 it is that of the
/// end of the step, of first order and without any bound on h. Where d is the depth halfway through
/// a step that is shorter than τ, the split step takes the weights
///
///     α = h/τ,    w = max(h/τ, 1/(1 − exp(−z)) − 1/z),    z = (c/n) h/µ,                 (E12)
///
/// of second order: w tends to ½. µ is the mass that the point resists a push with. A damper on it
/// alone, which at a corner is far stiffer than on the whole body, is then solved exactly.
///
/// A body that carries its own weight sinks in by g τ². The time τ = max(h, 0.01 s) makes that 1
/// mm, whatever the body's size; it does not follow the step below 0.01 s, so that the motion
/// converges as the step is refined, and does above it, where a spring shorter than a step is not
/// resolved. A body that has got deep into another in one step is pushed out no faster than
///
///     √(2 g depth)                                                                       (E13)
///
/// so that it gains no more energy than by a fall through the overlap; g is that of what contacts
/// push against, with the weight of the body and of the water in its place: less than gravity where
/// the body moves much water. With the lighter mass
/// instead of the heavier a body would sink deep into a lighter one; as it is, the light body's
/// contact is overdamped, with the same ERP.
///
/// Friction is Coulomb's, µ = 0.5 for every pair, in a pyramid whose first edge lies along the
/// sliding that the contact would see without it; so a body slides down the steepest way above
/// atan µ, whatever the heading of the slope. Its rows are regularised by
///
///     slip = 1e-6 h n / m                                                                (E14)
///
/// which lets a body on a slope creep by less than 1e-6 g h [m/s] and keeps the equations of many
/// points solvable.

namespace engine {

/// A point where two bodies overlap.
struct ContactPoint {
  Eigen::Vector3d position_W = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  ///< Unit, into the first body.
  double depth = 0;                                     ///< Of the overlap along the normal [m].
};

/// The points that are contacts.
///
/// Where two meshes overlap by a little, the faces beside the overlap also cut each other, and are
/// reported with their own normals and depths as large as the body. Such a point is known by a
/// contact less than a fifth as deep in another direction whose overlap it lies in: pushed out
/// there, it is out. So is one more than twice as deep as the pair's boxes overlap, which pushing
/// the boxes apart undoes: where flat faces meet edge on edge, no sound point may be reported.
/// Points no deeper than `reach` are trusted, points that just touch are not kept.
///
/// @param reach   Depth that the pair can have gathered within the last steps [m].
/// @param boxes   Least overlap of boxes around the two, over directions [m]; infinite for a sheet.
std::vector<ContactPoint> without_artefacts(const std::vector<ContactPoint>& points, double reach,
                                            double boxes);

/// The points that hold a sphere: those that are left when it is pushed out of every deeper one.
///
/// On a mesh a sphere also overlaps the triangles beside the one that it lies on, and is reported
/// to touch their edges with normals that lean away from them. Such points would set it rolling on
/// a flat floor; pushed out of the deepest, it is out of them. In a valley both sides are kept.
std::vector<ContactPoint> holding_a_sphere(std::vector<ContactPoint> points);

/// Indices of at most `most` points that stand for all: the deepest, then one by one the point
/// farthest from those taken, in place and direction. Equal ones go by order.
std::vector<std::size_t> representative(const std::vector<ContactPoint>& points, std::size_t most);

/// The weights of (E12).
struct ContactWeights {
  double spring = 1;  ///< α
  double damper = 1;  ///< w
};
/// @param lightness   m/µ
ContactWeights halfway_weights(std::size_t points, double step, double lightness);

/// What the constraint solver is told about one point: (E11) and (E14).
struct ContactStiffness {
  double erp = 0;    ///< [-]
  double cfm = 0;    ///< [m/(N s)]
  double speed = 0;  ///< For v⁻ = −1 [-]
  double slip = 0;   ///< [m/(N s)]
};
ContactStiffness contact_stiffness(double mass, std::size_t points, double step,
                                   const ContactWeights& weights = {});

/// The ERP of (E11), or what makes the speed ERP·depth/h that of (E13) if that is less.
double limited_erp(double erp, double depth, double gravity, double step);

}  // namespace engine
