#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Flat triangles as boundary elements, and integrals of 1/r over them in closed form.

namespace hydro::bem {

/// 1/(4π): with it 1/r is the potential of a unit source.
inline constexpr double kPerSphere = 1 / (4 * std::numbers::pi);

/// Edges are of one length if they differ by less [-]: which of them is halved, or named first,
/// must not hang on round-off, or a turned mesh would be treated in another way.
inline constexpr double kSameLength = 1e-6;

/// A triangle with what its integrals need. Edge e runs from corner e to corner e + 1.
struct Element {
  std::array<Eigen::Vector3d, 3> corners;    ///< [m]
  std::array<Eigen::Vector3d, 3> tangents;   ///< Unit, along the edges.
  std::array<Eigen::Vector3d, 3> conormals;  ///< Unit, in the plane, out of the triangle.
  std::array<double, 3> lengths;             ///< Of the edges [m].
  std::array<Eigen::Vector3d, 3> curls;      ///< n × ∇λ of the corners' hat functions [1/m].
  std::array<Eigen::Vector3d, 3> slopes;     ///< ∇λ [1/m].
  Eigen::Vector3d normal;                    ///< Unit, out of the solid.
  Eigen::Vector3d centroid;                  ///< [m]
  double area = 0;                           ///< [m^2]
  double radius = 0;  ///< Largest distance of a corner from the centroid [m].
};

Element make_element(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// One element a face.
std::vector<Element> make_elements(const TriMesh& mesh);

/// The corners' hat functions at the foot of x in the element's plane: barycentric coordinates.
Eigen::Vector3d hats_at(const Element& element, const Eigen::Vector3d& x);

/// Integrals over an element seen from a point x, with r = |y − x| and the part ρ of y − x in the
/// element's plane.
struct Potentials {
  double single = 0;           ///< ∫ 1/r dS [m].
  Eigen::Vector3d first;       ///< ∫ (y − x)/r dS [m^2].
  double solid_angle = 0;      ///< ∫ n·(y − x)/r³ dS: positive from behind the element.
  Eigen::Vector3d attraction;  ///< ∫ ρ/r³ dS.
};

/// Exact to round-off, also on the element (its solid angle is 0 there) and at its corners, where
/// `attraction` is not defined.
Potentials potentials(const Element& element, const Eigen::Vector3d& x);

/// Second moments as well.
struct PotentialMoments : Potentials {
  Eigen::Matrix3d second;  ///< ∫ ρ ρᵀ/r dS [m^3].
  Eigen::Matrix3d stress;  ///< ∫ ρ ρᵀ/r³ dS [m].
};
PotentialMoments potential_moments(const Element& element, const Eigen::Vector3d& x);

/// Signed solid angle of the element, as in Potentials (van Oosterom and Strackee, 1983).
double solid_angle(const Element& element, const Eigen::Vector3d& x);

/// Distance from a point to the nearest point of an element [m].
double distance(const Element& element, const Eigen::Vector3d& x);

}  // namespace hydro::bem
