#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "engine/contacts/broad_phase.h"

/// @file
/// The model of a contact: which points are kept where two bodies overlap, and what their rows ask
/// for.
///
/// A contact is rigid, whatever it carries. With h the length of a substep, d the depth of a point
/// halfway through it, τ = kShortestContact and r = kContactRecovery, the point parts after the
/// update at least with
///
///     v⁺ = min((d − s)/(r max(h, τ)), √(g (d − s)/2)),    without the root for d < s. (E11)
///
/// The depth of rest s is kContactDepth of the thickness of the thinner body. It keeps a body at
/// rest in contact, so that round-off does not part it from what bears it. A body that is deeper,
/// as a scene may begin or a long step may leave it, is pushed out within some τ, and no faster
/// than leaves it with a quarter of the energy of a fall through the rest of the overlap: it does
/// not hop. Here g is the acceleration by weight and full buoyancy, less than gravity where a body
/// moves much water.
///
/// Many points of a face can share their load in many ways, so the row of the normal of one that
/// does not bounce has a compliance of kContactCompliance of its response to its own impulse, by
/// which a body under a thousand times its weight sinks half a millimetre deeper in steps of
/// 1/60 s.
///
/// Friction is Coulomb's with the µ of the pair (contact_surfaces.h), exactly in its cone. All rows
/// of n points are regularised by
///
///     slip = kSlip h n / m,                                                              (E14)
///
/// m the mass of the heavier one of the movable bodies, which keeps the equations of many points
/// solvable; by it a body on a slope creeps with less than kSlip g h [m/s].
///
/// A point that closes faster than (E15) rebounds:
///
///     v⁺ = −e v⁻,                                                                        (E30)
///
/// Newton's law of restitution with the e of the pair; e = 0 stops it where it meets. In a substep
/// that begins at the onset, the positions at its two ends differ by the work of the weight over
/// what v⁻ and v⁺ travel, so with e = 1 a bounce keeps the energy for any h. Several impacts at
/// once and friction may gain energy under Newton's law; restitution.h takes that back.
///
/// A body that a contact stops may be followed by others, as in a stack that falls. They meet it
/// only because it stops, so the positions halfway, which do not know that, show no contact.
/// Therefore, where a contact with e = 0 stops a body faster than (E15), each near body that is as
/// fast is moved to its place at the end of the substep, and the stopped one to its place at the
/// start. If they overlap there, the near body is a follower. With γ the gap at the start, its
/// points ask for
///
///     v⁺ = −(γ + s)/h,                                                                  (E11a)
///
/// which closes the gap within the substep. A follower stops its own followers in turn. Without
/// these rows a stack lands one level a step, and each level is pushed out of the one below.

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

/// Indices of at most `limit` points that represent all: the deepest, then repeatedly the point
/// farthest from those taken, in position and direction. The first of equal ones is taken.
std::vector<std::size_t> representative(const std::vector<ContactPoint>& points, std::size_t limit);

/// The terms of the rows of a point, by (E11) and (E14).
struct ContactRow {
  double speed = 0;       ///< v⁺ [m/s]
  double compliance = 0;  ///< slip [s/kg]
};

/// The quantities that these terms depend on.
struct ContactLaw {
  double mass = 0;         ///< m, the heavier one of the movable bodies [kg].
  std::size_t points = 1;  ///< Number of points of the pair.
  double rest = 0;         ///< s [m]
  double fall = 1;         ///< Acceleration by weight and buoyancy, over that of gravity [-].
  double gravity = 0;      ///< [m/s^2]
};
/// @param step   h [s]
ContactRow contact_row(double depth, const ContactLaw& law, double step);

/// A point of a contact for the constraint solver.
struct Contact {
  Pair pair;
  ContactPoint point;
  ContactRow row;
  double friction = kFriction;                          ///< Coulomb's µ [-].
  double restitution = 0;                               ///< [-]
  bool rebounds = false;                                ///< (E30) holds.
  Eigen::Vector3d sliding_W = Eigen::Vector3d::Zero();  ///< Relative velocity without it [m/s].
  /// Force on the first body, in the axes W, that the solver has found or is to start from [N].
  Eigen::Vector3d force_W = Eigen::Vector3d::Zero();
};

/// Speed of (E15), above which touching is an impact [m/s].
double impact_speed(double gravity);

}  // namespace engine
