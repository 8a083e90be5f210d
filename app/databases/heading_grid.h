#pragma once

#include <string>
#include <vector>

#include "hydro/mesh/mesh.h"
#include "hydro/radiation/radiation_data.h"

/// @file
/// Loads of waves over the whole circle, from the headings that a file has.

namespace databases {

/// Symmetries of a body in H that relate the loads of waves from different sides.
struct BodySymmetry {
  bool left_right = false;  ///< Symmetric in the plane y = 0.
  bool fore_aft = false;    ///< Symmetric in the plane x = 0.
  bool revolution = false;  ///< About the vertical through the centre of mass.
};

/// The symmetries of a mesh, to a thousandth of its size, and those of matrices without the
/// couplings that a mirror forbids. A mesh counts as one of revolution if its faces look away from
/// the axis within some 6° in the mean over their area.
BodySymmetry symmetry_of(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                         const std::vector<hydro::Matrix6d>& matrices);

/// Sets to 0 the couplings that the mirror symmetries forbid.
void take_forbidden_out(const BodySymmetry& symmetry, hydro::Matrix6d& matrix);

/// A row of loads over the heading for each frequency.
struct LoadTable {
  std::vector<double> headings;  ///< In H [rad].
  std::vector<hydro::Loads6cd> loads;
};

/// Puts tables with equal headings on evenly spaced ones from 0, as hydro::DiffractionLoad wants
/// them: those that the tables have where they are such already; else by periodic cubic splines
/// through the given headings and their images by symmetry, or by turning the first heading's loads
/// about an axis of revolution.
/// @return what was done; empty if nothing was
/// @throws std::invalid_argument if more than 45° of the circle lie between two headings
std::string complete_circle(const BodySymmetry& symmetry, std::vector<LoadTable*> tables);

}  // namespace databases
