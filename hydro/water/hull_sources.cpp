#include "hydro/water/hull_sources.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "hydro/added_mass/patch_integrals.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/mesh/face_tree.h"
#include "hydro/parallel.h"
#include "hydro/radiation/diffraction_load.h"
#include "hydro/radiation/incident_wave.h"
#include "hydro/radiation/radiation_solve.h"

namespace hydro {
namespace {

using bem::kPerSphere;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Distance in cells from the waterplane's edge beyond which the fictitious surface is damped.
constexpr double kInside = 1;

/// Pairs of images in the bottom and in the surface above it, whose signs alternate.
constexpr int kBottomImages = 4;

/// The grid's part of one hull's equations: what a unit source at each place does at all others.
struct GridResponse {
  MatrixXd potential;  ///< P; a column for each source.
  MatrixXd raise;      ///< η by a volume of 1.
  std::array<MatrixXd, 3> potential_slope, raise_slope;

  explicit GridResponse(Index n) : potential(n, n), raise(n, n) {
    for (auto* slopes : {&potential_slope, &raise_slope})
      for (MatrixXd& slope : *slopes) slope.resize(n, n);
  }
};

/// A square as small as the hull's nearest waves need it.
PeriodicSquare small_square(const PeriodicSquare& square, const Eigen::Matrix3Xd& places) {
  const double length =
      (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).head<2>().maxCoeff();
  PeriodicSquare small = square;
  small.cells = 64;
  while (small.side() < 4 * length) small.cells *= 2;
  return small;
}

PeriodicSquare deep_square(PeriodicSquare square) {
  square.depth = std::numeric_limits<double>::infinity();
  return square;
}

/// c of (3) times the side of the square: −4 ζ(½) β(½)/2π, the potential at one of the charges of a
/// square lattice of its neighbours and a plane of the opposite charge.
constexpr double kMissingConstant = 0.6207467;

GridResponse grid_response(const PeriodicSquare& square, const Eigen::Matrix3Xd& places) {
  const Index n = places.cols();
  GridResponse response(n);
  const PeriodicSquare small = small_square(square, places);
  const PeriodicWaves deep(deep_square(small));
  const bool bounded = std::isfinite(small.depth);
  const std::optional<PeriodicWaves> shallow =
      bounded ? std::optional<PeriodicWaves>(small) : std::nullopt;
  const double constant = kMissingConstant / small.side();
  const double sheet = 1 / (small.side() * small.side());  // The plane's own field.
  const double missing_raise = sheet - 1 / (square.side() * square.side());
  parallel_for(static_cast<std::size_t>(n), [&](std::size_t source) {
    const auto j = static_cast<Index>(source);
    const Vector3d from = places.col(j);
    const auto read = [&](PeriodicWaves& waves, FieldBelow& field) {
      waves.add_source(from.x() / small.cell, from.y() / small.cell, from.z(), 1);
      waves.read_sources(field);
    };
    PeriodicWaves waves = deep;
    std::optional<PeriodicWaves> over_bottom = shallow;
    FieldBelow short_waves, all_waves;
    read(waves, short_waves);
    if (bounded) read(*over_bottom, all_waves);
    for (Index i = 0; i < n; ++i) {
      const Vector3d to = places.col(i);
      const auto at = [&](const FieldBelow& field) {
        return field.at(to.x() / small.cell, to.y() / small.cell, to.z());
      };
      const FieldBelow::Sample potential = at(short_waves);
      const FieldBelow::Sample raise = bounded ? at(all_waves) : potential;
      response.raise(i, j) = raise.value.real() + missing_raise;
      response.potential(i, j) = potential.value.imag() + constant + sheet * (to.z() + from.z());
      for (int axis = 0; axis < 3; ++axis) {
        response.raise_slope[axis](i, j) = raise.slope[axis].real();
        response.potential_slope[axis](i, j) = potential.slope[axis].imag();
      }
      response.potential_slope[2](i, j) += sheet;
    }
  });
  return response;
}

/// Adds the integrals of (1/r + 1/r')/4π over all patches seen from a point, and of their images in
/// the bottom.
void add_images(const std::vector<Patch>& patches, const std::vector<PatchMoments>& moments,
                const WaterPlane& surface, double depth, const PatchPoint& point, double part,
                Eigen::Ref<Eigen::RowVectorXd> row, MotionRow& side) {
  const Vector3d mirrored = surface.mirrored(point.at);
  for (std::size_t j = 0; j < patches.size(); ++j) {
    Seen seen;
    const auto add = [&](const Vector3d& x, double sign) {
      add_seen(patches[j], moments[j], x, sign * part * kPerSphere, seen);
    };
    add(point.at, 1);
    add(mirrored, 1);
    for (int image = 1; image <= kBottomImages && std::isfinite(depth); ++image)
      for (const double way : {-2.0 * image * depth, 2.0 * image * depth}) {
        const double sign = image % 2 == 0 ? 1 : -1;
        add(point.at + way * surface.up, sign);
        add(mirrored + way * surface.up, -sign);
      }
    row[static_cast<Index>(j)] += seen.twofold[0];
    side += seen.single;
  }
}

/// The potentials (4) and their matrix.
struct Equations {
  MatrixXd matrix;
  HullSources::SixColumns side;
};

Equations make_equations(const std::vector<Patch>& patches, const WaterPlane& surface,
                         double depth) {
  const auto n = static_cast<Index>(patches.size());
  Equations equations{.matrix = MatrixXd::Zero(n, n), .side = HullSources::SixColumns::Zero(n, 6)};
  std::vector<PatchMoments> moments;
  for (const Patch& patch : patches) moments.push_back(moments_of(patch));
  parallel_for(patches.size(), [&](std::size_t i) {
    const auto row = static_cast<Index>(i);
    Eigen::RowVectorXd sums = Eigen::RowVectorXd::Zero(n);
    MotionRow side = MotionRow::Zero();
    for (const PatchPoint& point : patches[i].points)
      add_images(patches, moments, surface, depth, point, point.weight / patches[i].area, sums,
                 side);
    equations.matrix.row(row) = sums;
    equations.matrix(row, row) += 0.5;
    equations.side.row(row) = side;
  });
  return equations;
}

/// Takes the waves that the grid holds out of the image, twice: P of (2).
void add_grid(const HullSources& hull, const GridResponse& response, Equations& equations) {
  for (int axis = 0; axis < 3; ++axis)
    equations.matrix +=
        response.potential_slope[axis].transpose() * hull.fluxes.row(axis).asDiagonal();
  equations.side -= response.potential * hull.motions;
}

/// Points of the waterplane, half a cell apart, that are farther than `kInside` cells from its
/// edge.
Eigen::Matrix2Xd points_inside(const TriMesh& mesh_H, double level, double cell) {
  const FaceTree tree(mesh_H);
  const Vector3d low = mesh_H.vertices.rowwise().minCoeff();
  const Vector3d high = mesh_H.vertices.rowwise().maxCoeff();
  // Just below the plane, where a deck in it does not matter.
  const double height = level - 1e-6 * (high.z() - low.z());
  const auto is_inside = [&](const Eigen::Vector2d& p) {
    return tree.contains({p.x(), p.y(), height});
  };
  const auto is_far_inside = [&](const Eigen::Vector2d& p) {
    constexpr int kWays = 8;
    for (int way = 0; way < kWays; ++way) {
      const double angle = 2 * std::numbers::pi * way / kWays;
      if (!is_inside(p + kInside * cell * Eigen::Vector2d(std::cos(angle), std::sin(angle))))
        return false;
    }
    return is_inside(p);
  };
  // Whole multiples of half a cell, so that a symmetric hull has symmetric points.
  const auto first = [&](double from) { return std::ceil(2 * from / cell) * cell / 2; };
  std::vector<Eigen::Vector2d> found;
  for (double x = first(low.x()); x <= high.x(); x += cell / 2)
    for (double y = first(low.y()); y <= high.y(); y += cell / 2)
      if (is_far_inside({x, y})) found.emplace_back(x, y);
  Eigen::Matrix2Xd points(2, static_cast<Index>(found.size()));
  for (std::size_t i = 0; i < found.size(); ++i) points.col(static_cast<Index>(i)) = found[i];
  return points;
}

}  // namespace

double HullSources::length() const {
  return (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).head<2>().maxCoeff();
}

double HullSources::radius() const { return std::sqrt(waterplane / std::numbers::pi); }

Vector6d HullSources::load_of(const Eigen::VectorXd& raise, const Eigen::Matrix3Xd& slope) const {
  const Eigen::VectorXd outward = fluxes.cwiseProduct(slope).colwise().sum().transpose();
  return motions.transpose() * raise + potentials.transpose() * outward;
}

HullSources make_hull_sources(const TriMesh& mesh_B, const MeanPose& pose,
                              const PeriodicSquare& square, int patches) {
  const TriMesh mesh_H = in_frame_H(mesh_B, pose);
  const WaterPlane surface{.up = Vector3d::UnitZ(), .height = -pose.height};
  const std::vector<Patch> wetted = wetted_patches(mesh_H, surface, patches);
  if (wetted.empty()) throw std::invalid_argument("the body is dry in its mean pose");
  const auto n = static_cast<Index>(wetted.size());
  HullSources hull{.pose = pose,
                   .water = {.gravity = square.gravity, .depth = square.depth},
                   .volume = wetted_volume(mesh_H, surface)};
  hull.places.resize(3, n);
  hull.fluxes.resize(3, n);
  hull.motions.resize(n, 6);
  for (Index i = 0; i < n; ++i) {
    const Patch& patch = wetted[static_cast<std::size_t>(i)];
    const PatchMoments moments = moments_of(patch);
    hull.places.col(i) = patch.centre + Vector3d(0, 0, pose.height);
    hull.fluxes.col(i) = moments.area.col(0);
    hull.motions.row(i) = moments.source;
  }
  hull.waterplane = std::abs(hull.fluxes.row(2).sum());
  if (!(-hull.places.row(2).minCoeff() < square.depth))
    throw std::invalid_argument("the body reaches the bottom in its mean pose");
  const GridResponse response = grid_response(square, hull.places);
  Equations equations = make_equations(wetted, surface, square.depth);
  add_grid(hull, response, equations);
  const Eigen::PartialPivLU<MatrixXd> solved(equations.matrix);
  hull.potentials = solved.solve(equations.side);
  hull.volumes = solved.inverse().transpose();
  hull.added_mass = semi_definite_part(hull.potentials.transpose() * hull.motions);
  HullSources::SixRows load = hull.motions.transpose() * response.raise;
  for (int axis = 0; axis < 3; ++axis)
    load += hull.potentials.transpose() * hull.fluxes.row(axis).asDiagonal() *
            response.raise_slope[axis];
  hull.reply = load * hull.volumes;
  hull.thin_spring = load * hull.motions;
  const Matrix6d spring = hull.reply * hull.motions;
  hull.spring = semi_definite_part(spring);
  hull.inside = points_inside(mesh_H, -pose.height, square.cell);
  return hull;
}

namespace {

/// ∫ ψ_m (u̇·n) dS under a wave.
Vector6cd scattered_at_once(const HullSources& hull, const IncidentWave& wave, double heading) {
  const Eigen::Vector2d way(std::cos(heading), std::sin(heading));
  Vector6cd load = Vector6cd::Zero();
  for (Index i = 0; i < hull.places.cols(); ++i) {
    const Vector3d at = hull.places.col(i), flux = hull.fluxes.col(i);
    const std::complex<double> crest =
        wave.head(-at.z()) * std::polar(1.0, wave.k * way.dot(at.head<2>()));
    const std::complex<double> outward(wave.rise(-at.z()) * flux.z(), way.dot(flux.head<2>()));
    load -= wave.gravity * wave.k * crest * outward * hull.potentials.row(i).transpose();
  }
  return load;
}

/// The hull as FloatingBody takes it: A∞, and in place of the diffraction what the held hull
/// scatters at once. Nothing depends on the frequency, and nothing is damped.
RadiationData instant_data(const HullSources& hull, const TriMesh& mesh_B) {
  RadiationData data{.pose = hull.pose, .water = hull.water, .volume = hull.volume};
  data.frequencies = radiation_frequencies(mesh_B, hull.pose, hull.water);
  const int headings = radiation_headings(mesh_B, hull.pose, hull.water, data.frequencies.back());
  data.headings = evenly_spaced_headings(headings);
  data.infinite_added_mass = hull.added_mass;
  const std::size_t count = data.frequencies.size();
  data.added_mass.assign(count, hull.added_mass);
  data.damping.assign(count, Matrix6d::Zero());
  // The clipped mesh has the load of Froude and Krylov.
  data.froude_krylov.assign(count, Loads6cd::Zero(6, headings));
  for (const double omega : data.frequencies) {
    const IncidentWave wave(omega, hull.water);
    Loads6cd& loads = data.diffraction.emplace_back(6, headings);
    for (int h = 0; h < headings; ++h)
      loads.col(h) = scattered_at_once(hull, wave, data.headings[static_cast<std::size_t>(h)]);
  }
  return data;
}

}  // namespace

std::shared_ptr<const FloatingBody> floating_hull(const HullSources& hull, const TriMesh& mesh_B,
                                                  const Sea& sea) {
  RadiationData data = instant_data(hull, mesh_B);
  auto [load, momentum] = scattered_waves(data, sea);
  return std::make_shared<const FloatingBody>(mesh_B, std::move(data), RadiationMemory(),
                                              std::move(load), std::move(momentum));
}

}  // namespace hydro
