#include "hydro/radiation/radiation_solve.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/added_mass/surface_solve.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/mesh/mirror_symmetry.h"
#include "hydro/parallel.h"
#include "hydro/radiation/incident_wave.h"
#include "hydro/radiation/radiation_equations.h"

namespace hydro {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::Vector3d;
using std::numbers::pi;
using SixColumnsC = Eigen::Matrix<Complex, Eigen::Dynamic, 6>;

/// Panels above which those of a hull have one point each in (3), not three.
constexpr std::size_t kManyPanels = 3000;

/// Largest wave number times the root of a patch's mean area [-]: with 2.4 the damping of a hull of
/// 7 : 1 has errors as large as itself, with 1.6 of 5 %.
constexpr double kResolved = 1.6;

/// Harmonics of (4) over the heading beyond k times the length that are not yet nothing.
constexpr int kMoreHarmonics = 8;
constexpr int kLeastHeadings = 36;

/// Distance within which vertices are mirror images, over the mesh's size [-].
constexpr double kSymmetric = 1e-6;

/// A point of the surface, for its term in (3).
struct SurfacePoint {
  Vector3d at;
  Vector3d flux;  ///< n dS
  std::size_t patch;
};

std::vector<SurfacePoint> points_of(const std::vector<Patch>& patches) {
  std::size_t panels = 0;
  for (const Patch& patch : patches) panels += patch.panels.size();
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (const bem::Element& panel : patches[i].panels) {
      const Vector3d flux = panel.area * panel.normal;
      if (panels > kManyPanels) {
        points.push_back({panel.centroid, flux, i});
        continue;
      }
      for (std::size_t e = 0; e < 3; ++e)
        points.push_back({(panel.corners[e] + panel.corners[(e + 1) % 3]) / 2, flux / 3, i});
    }
  return points;
}

/// (3) for all headings.
void add_excitation(const RadiationEquations& p, const std::vector<SurfacePoint>& points,
                    const IncidentWave& wave, const SixColumnsC& psi,
                    const std::vector<double>& headings, Loads6cd& froude_krylov,
                    Loads6cd& diffraction) {
  const Complex i(0, 1);
  const double k = wave.k, gravity = wave.gravity;
  for (const SurfacePoint& point : points) {
    const Eigen::Matrix<Complex, 6, 1> potential =
        psi.middleRows<3>(3 * static_cast<Index>(point.patch)).transpose() *
        p.patches[point.patch].functions(point.at).cast<Complex>();
    const MotionRow N = motions(point.at, point.flux);
    const double down = p.plane.depth(point.at);
    const double head = wave.head(down), up = wave.rise(down) * point.flux.z();
    const std::size_t half = headings.size() / 2;
    for (std::size_t h = 0; h < half; ++h) {
      const Eigen::Vector2d d(std::cos(headings[h]), std::sin(headings[h]));
      const double phase = k * d.dot(point.at.head<2>());
      const Complex pressure = head * Complex(std::cos(phase), std::sin(phase));
      const double along = d.dot(point.flux.head<2>());
      for (const bool opposite : {false, true}) {
        const Index column = static_cast<Index>(opposite ? h + half : h);
        const Complex crest = opposite ? std::conj(pressure) : pressure;
        froude_krylov.col(column) -= gravity * crest * N.transpose();
        diffraction.col(column) -=
            gravity * k * crest * (i * (opposite ? -along : along) + up) * potential;
      }
    }
  }
}

/// (4)
Matrix6d damping_of(const Loads6cd& excitation, const IncidentWave& wave) {
  const Eigen::Matrix<Complex, 6, 6> sum = excitation * excitation.adjoint();
  const double factor = wave.k * wave.omega / (4 * pi * wave.gravity * wave.gravity) * 2 * pi /
                        static_cast<double>(excitation.cols());
  return factor * wave.deep_group_velocity() * sum.real();
}

/// Signs of the six motions under a mirror in the plane normal to a horizontal axis.
Vector6d mirror_signs(int axis) {
  Vector6d signs;
  if (axis == 0)
    signs << -1, 1, 1, 1, -1, -1;
  else
    signs << 1, -1, 1, -1, 1, -1;
  return signs;
}

/// Removes from the data the terms that a mirror symmetry of the hull forbids: its patches do not
/// have the symmetry.
void make_symmetric(int axis, RadiationData& data) {
  const Vector6d signs = mirror_signs(axis);
  const Matrix6d allowed = ((signs * signs.transpose()).array() + 1) / 2;
  for (std::vector<Matrix6d>* matrices : {&data.added_mass, &data.damping})
    for (Matrix6d& matrix : *matrices) matrix = matrix.cwiseProduct(allowed).eval();
  data.infinite_added_mass = data.infinite_added_mass.cwiseProduct(allowed).eval();
  for (std::vector<Loads6cd>* loads : {&data.froude_krylov, &data.diffraction})
    for (Loads6cd& load : *loads) {
      const Loads6cd given = load;
      const Index count = load.cols();
      for (Index h = 0; h < count; ++h) {
        const Index mirrored = ((axis == 0 ? count / 2 - h : -h) + count) % count;
        load.col(h) = (given.col(h) + signs.asDiagonal() * given.col(mirrored)) / 2;
      }
    }
}

/// Largest |B_mn| of `other` less that of the data, as RadiationSolution::mismatch.
double mismatch_of(const RadiationData& data, const std::vector<Matrix6d>& other,
                   const std::vector<Patch>& patches) {
  double area = 0, largest = 0, mismatch = 0;
  for (const Patch& patch : patches) area += patch.area;
  Vector6d lever = Vector6d::Ones();
  lever.tail<3>() /= std::sqrt(area);
  for (std::size_t f = 0; f < other.size(); ++f) {
    const Matrix6d B = lever.asDiagonal() * data.damping[f] * lever.asDiagonal();
    const Matrix6d radiated = lever.asDiagonal() * other[f] * lever.asDiagonal();
    largest = std::max(largest, B.cwiseAbs().maxCoeff());
    mismatch = std::max(mismatch, (B - radiated).cwiseAbs().maxCoeff());
  }
  return largest > 0 ? mismatch / largest : 0;
}

/// A in the limit of high frequency.
Matrix6d added_mass_without_waves(const TriMesh& mesh_H, const WaterPlane& plane, double depth,
                                  int patches) {
  if (std::isinf(depth)) return solve_under(mesh_H, plane, patches).matrix;
  const RadiationEquations p =
      make_radiation_equations(mesh_H, plane, depth, patches, SurfaceWaves::no);
  return semi_definite_part(load_of(p, solve_potentials(p, 0)).real());
}

/// @throws std::invalid_argument unless the water is above the body's lowest point, and below it.
void check_wet(const RadiationEquations& p) {
  if (p.patches.empty()) throw std::invalid_argument("the body is dry in its mean pose");
  if (!(p.draught() < p.depth))
    throw std::invalid_argument("the body reaches the bottom in its mean pose");
}

}  // namespace

TriMesh in_frame_H(const TriMesh& mesh_B, const MeanPose& pose) {
  TriMesh mesh = mesh_B;
  mesh.vertices = pose.orientation.toRotationMatrix() * mesh_B.vertices;
  return mesh;
}

std::vector<double> evenly_spaced_headings(int count) {
  std::vector<double> headings;
  for (int h = 0; h < count; ++h) headings.push_back(2 * pi * h / count);
  return headings;
}

std::vector<double> radiation_frequencies(const TriMesh& mesh_B, const MeanPose& pose,
                                          const LinearWater& water, int patches) {
  constexpr int kCount = 16;
  const TriMesh mesh_H = in_frame_H(mesh_B, pose);
  const Eigen::Matrix3Xd& at = mesh_H.vertices;
  const Eigen::Vector2d sizes =
      at.topRows<2>().rowwise().maxCoeff() - at.topRows<2>().rowwise().minCoeff();
  const double draught = -pose.height - at.row(2).minCoeff();
  const auto frequency = [&](double k) {
    return std::sqrt(water.gravity * k * std::tanh(k * water.depth));
  };
  const double lowest = frequency(0.1 / std::max(sizes.maxCoeff(), 2 * draught));
  const double patch = std::sqrt(wetted_area(mesh_H, {.height = -pose.height}) / patches);
  const double highest = frequency(std::min(10 / sizes.minCoeff(), kResolved / patch));
  std::vector<double> frequencies;
  for (int i = 0; i < kCount; ++i)
    frequencies.push_back(lowest * std::pow(highest / lowest, i / (kCount - 1.0)));
  return frequencies;
}

int radiation_headings(const TriMesh& mesh_B, const MeanPose& pose, const LinearWater& water,
                       double highest_frequency) {
  const Eigen::Matrix2Xd at = in_frame_H(mesh_B, pose).vertices.topRows<2>();
  const double length = (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm();
  const double k = IncidentWave(highest_frequency, water).k;
  const int half = static_cast<int>(std::ceil((k * length + kMoreHarmonics) / 2));
  return std::max(kLeastHeadings, 2 * half);
}

RadiationSolution solve_radiation(const TriMesh& mesh_B, const MeanPose& pose,
                                  const LinearWater& water, const RadiationOptions& options) {
  const TriMesh mesh_H = in_frame_H(mesh_B, pose);
  const WaterPlane plane{.up = Vector3d::UnitZ(), .height = -pose.height};
  const RadiationEquations p =
      make_radiation_equations(mesh_H, plane, water.depth, options.patches, SurfaceWaves::yes);
  check_wet(p);
  RadiationSolution solution{.data = {.pose = pose, .water = water}};
  RadiationData& data = solution.data;
  solution.unknowns = static_cast<int>(p.unknowns());
  data.volume = wetted_volume(mesh_H, plane);
  data.frequencies = options.frequencies.empty()
                         ? radiation_frequencies(mesh_B, pose, water, options.patches)
                         : options.frequencies;
  const int headings = options.headings > 0
                           ? options.headings
                           : radiation_headings(mesh_B, pose, water, data.frequencies.back());
  data.headings = evenly_spaced_headings(headings);
  data.infinite_added_mass = added_mass_without_waves(mesh_H, plane, water.depth, options.patches);
  const std::size_t count = data.frequencies.size();
  const Loads6cd none = Loads6cd::Zero(6, headings);
  data.added_mass.resize(count);
  data.damping.resize(count);
  data.froude_krylov.assign(count, none);
  data.diffraction.assign(count, none);
  std::vector<Matrix6d> radiated(count);
  const std::vector<SurfacePoint> points = points_of(p.patches);
  parallel_for(count, [&](std::size_t f) {
    const IncidentWave wave(data.frequencies[f], water);
    const SixColumnsC psi = solve_potentials(p, wave.deep_wave_number());
    const Eigen::Matrix<Complex, 6, 6> load = load_of(p, psi);
    data.added_mass[f] = (load + load.transpose()).real() / 2;
    radiated[f] = wave.omega * (load + load.transpose()).imag() / 2;
    add_excitation(p, points, wave, psi, data.headings, data.froude_krylov[f], data.diffraction[f]);
    data.damping[f] = damping_of(data.froude_krylov[f] + data.diffraction[f], wave);
  });
  const double size = mesh_H.vertices.cwiseAbs().maxCoeff();
  for (const int axis : {0, 1})
    if (is_mirror_symmetric(mesh_H, axis, kSymmetric * size)) make_symmetric(axis, data);
  solution.mismatch = mismatch_of(data, radiated, p.patches);
  return solution;
}

}  // namespace hydro
