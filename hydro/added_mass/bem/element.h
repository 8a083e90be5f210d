#pragma once

#include <array>
#include <numbers>
#include <vector>

#include "hydro/mesh/mesh.h"

/// @file
/// Flat triangles as boundary elements, and integrals of 1/r over them in closed form.

namespace hydro::bem {

/// 1/(4π): times 1/r it is the potential of a unit source.
inline constexpr double kPerSphere = 1 / (4 * std::numbers::pi);

/// Relative difference below which two edges count as equally long [-]. The choice of the edge that
/// is halved or named first must not depend on round-off; else a rotated mesh would be treated
/// differently.
inline constexpr double kSameLength = 1e-6;

/// A triangle with the data of its integrals. Edge e runs from corner e to corner e + 1.
struct Element {
  std::array<Eigen::Vector3d, 3> corners;    ///< [m]
  std::array<Eigen::Vector3d, 3> tangents;   ///< Unit vectors along the edges.
  std::array<Eigen::Vector3d, 3> conormals;  ///< Unit normals of the edges, in the plane, outward.
  std::array<double, 3> lengths;             ///< Lengths of the edges [m].
  std::array<Eigen::Vector3d, 3> curls;      ///< n × ∇λ of the corners' hat functions [1/m].
  std::array<Eigen::Vector3d, 3> slopes;     ///< ∇λ [1/m].
  Eigen::Vector3d normal;                    ///< Unit normal, out of the solid.
  Eigen::Vector3d centroid;                  ///< [m]
  double area = 0;                           ///< [m^2]
  double radius = 0;  ///< Largest distance of a corner from the centroid [m].
};

Element make_element(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// Returns one element per face.
std::vector<Element> make_elements(const TriMesh& mesh);

/// Values of the corners' hat functions (barycentric coordinates) at the projection of x onto the
/// element's plane.
Eigen::Vector3d hats_at(const Element& element, const Eigen::Vector3d& x);

/// Integrals over an element seen from a point x, with r = |y − x| and the component ρ of y − x in
/// the element's plane.
struct Potentials {
  double single = 0;           ///< ∫ 1/r dS [m].
  Eigen::Vector3d first;       ///< ∫ (y − x)/r dS [m^2].
  double solid_angle = 0;      ///< ∫ n·(y − x)/r³ dS: positive from behind the element.
  Eigen::Vector3d attraction;  ///< ∫ ρ/r³ dS.
};

/// Returns the integrals, exact to round-off also on the element (where its solid angle is 0) and
/// at its corners, where `attraction` is undefined.
Potentials potentials(const Element& element, const Eigen::Vector3d& x);

/// The potentials with second moments.
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
