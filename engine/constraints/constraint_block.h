#pragma once

#include <Eigen/Core>
#include <array>

#include "engine/base/spatial_vector.h"
#include "engine/constraints/force_row.h"
#include "engine/contacts/contacts.h"

/// @file
/// Rows of constraints between two bodies, in blocks of up to three that are solved together.
///
/// With u the velocities of both bodies after an update and p the impulses of the rows,
///
///     J₁ u₁ + J₂ u₂ + D p = c,                                                          (E8)
///
/// where D is diagonal, the compliance of the rows. The impulses on the bodies are J₁ᵀp and J₂ᵀp.
/// Where an impulse is at a bound, the row is an inequality:
///
///     one-sided     p >= 0, and J u + D p >= c;
///     bounded       |p| <= limit;
///     contact       row 1 is one-sided;
///                   of rows 2 and 3, |(p₂, p₃)| <= µ p₁, and where that is an equality the rest
///                   of their (E8) is opposite to (p₂, p₃): Coulomb's law.

namespace engine {

struct ConstraintBlock {
  enum class Kind { bilateral, one_sided, bounded, contact };
  using Rows = Eigen::Matrix<double, 3, 6>;

  Kind kind = Kind::bilateral;
  int rows = 3;                                  ///< Number of rows in use; the others are zero.
  std::array<BodyId, 2> bodies{kWorld, kWorld};  ///< kWorld does not move.
  std::array<Rows, 2> J{Rows::Zero(), Rows::Zero()};     ///< About the centres of mass, in W.
  Eigen::Vector3d target = Eigen::Vector3d::Zero();      ///< c [m/s, rad/s]
  Eigen::Vector3d compliance = Eigen::Vector3d::Zero();  ///< D [1/kg, 1/(kg m^2)]
  double give = 0;   ///< Least compliance of row 1, over its response to its own impulse [-].
  double limit = 0;  ///< Largest impulse of a bounded row [N s, N m s]; µ of a contact [-].
};

/// The rows of a contact: along its normal, into the first body, and along two tangents.
/// @param first, second   Centres of mass; of what does not move any point [m].
/// @param h               Length of the substep [s].
ConstraintBlock contact_block(const Contact& contact, const Eigen::Vector3d& first,
                              const Eigen::Vector3d& second, double h);

/// The row of (E22).
ConstraintBlock force_block(const ForceRow& row, const Eigen::Vector3d& first,
                            const Eigen::Vector3d& second, double h);

}  // namespace engine
