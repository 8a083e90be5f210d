#include "app/databases/fit_to_body.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "app/databases/database_checks.h"
#include "app/databases/heading_grid.h"
#include "app/databases/ogilvie.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/froude_krylov.h"

namespace databases {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::cross_matrix;
using hydro::Matrix6d;

/// Bound of the differences between estimates of A∞, over its largest entry [-].
constexpr double kLargestSpread = 0.05;

/// Largest B or ω(A − A∞) of a motion, over that of all, up to which it makes no waves [-].
constexpr double kLeastResponse = 1e-5;

/// Part of the body's length by which centres of mass may differ without a note [-].
constexpr double kSameCenter = 0.01;

/// The way from the file's frame to H.
struct Move {
  Vector3d center;           ///< The centre of mass in the file's frame [m].
  Matrix6d by_center, to_H;  ///< Velocities: about the reference point, by those about it; axes.
  double heading = 0;        ///< Heading of the file's x axis in H [rad].
  hydro::LinearWater water;

  Matrix6d matrix(const Matrix6d& about_reference) const {
    return to_H * (by_center.transpose() * about_reference * by_center) * to_H.transpose();
  }
};

void check_water(const Database& d, const hydro::LinearWater& water) {
  if (!(water.gravity > 0 && std::isfinite(water.gravity) && water.depth > 0))
    refuse(d, fmt::format("found a gravity of {:g} m/s^2 and a depth of {:g} m, expected positive "
                          "numbers",
                          water.gravity, water.depth));
  for (const double omega : {d.frequencies.front(), d.frequencies.back()}) {
    const auto k = hydro::wave_number(omega, water.depth, water.gravity);
    if (!k || !std::isfinite(*k) || !(*k > 0))
      refuse(d, fmt::format("found the frequency {:g} rad/s, at which there are no waves", omega));
  }
  for (const double heading : d.headings)
    if (!std::isfinite(heading))
      refuse(d, fmt::format("found the heading {:g}, expected a finite number", heading));
}

Move move_of(const Database& d, const scene::RadiationFile& source, const FloatingMesh& body,
             double length, std::vector<std::string>& notes) {
  Move move{.center = {0, 0, body.pose.height},
            .by_center = Matrix6d::Identity(),
            .to_H = Matrix6d::Zero(),
            .heading = source.heading,
            .water = body.water};
  if (const auto& center = source.center_of_mass ? source.center_of_mass : d.center_of_mass) {
    move.center.head<2>() = center->head<2>();
    if (std::abs(center->z() - body.pose.height) > kSameCenter * length)
      notes.push_back(
          fmt::format("the file's centre of mass is {:.4g} m above the water, the "
                      "body's {:.4g} m; loads are moved to the body's",
                      center->z(), body.pose.height));
  }
  if (!source.reference_point && !d.reference_point)
    notes.emplace_back(
        "the file does not tell the point of its moments and motions; taken: its origin");
  const Vector3d reference = source.reference_point ? *source.reference_point
                                                    : d.reference_point.value_or(Vector3d::Zero());
  move.by_center.topRightCorner<3, 3>() = -cross_matrix(reference - move.center);
  const Matrix3d turn = Eigen::AngleAxisd(move.heading, Vector3d::UnitZ()).toRotationMatrix();
  move.to_H.topLeftCorner<3, 3>() = move.to_H.bottomRightCorner<3, 3>() = turn;
  if (d.gravity) move.water.gravity = *d.gravity;
  if (d.depth) move.water.depth = *d.depth;
  check_water(d, move.water);
  return move;
}

/// Loads of waves about the centre of mass, of waves with their crest over it.
LoadTable moved(const Database& d, const Move& move, const std::vector<hydro::Loads6cd>& loads) {
  LoadTable table;
  for (const double heading : d.headings) table.headings.push_back(heading + move.heading);
  const Eigen::Vector2d away = move.center.head<2>() - d.phase_origin;
  const Matrix6d turn = move.to_H * move.by_center.transpose();
  for (std::size_t f = 0; f < loads.size(); ++f) {
    const double k =
        hydro::wave_number(d.frequencies[f], move.water.depth, move.water.gravity).value();
    hydro::Loads6cd load = turn.cast<std::complex<double>>() * loads[f];
    for (std::size_t h = 0; h < d.headings.size(); ++h) {
      const Eigen::Vector2d direction(std::cos(d.headings[h]), std::sin(d.headings[h]));
      load.col(static_cast<Eigen::Index>(h)) *= std::polar(1.0, -k * direction.dot(away));
    }
    table.loads.push_back(std::move(load));
  }
  return table;
}

std::vector<hydro::Loads6cd> difference(const std::vector<hydro::Loads6cd>& a,
                                        const std::vector<hydro::Loads6cd>& b) {
  std::vector<hydro::Loads6cd> result;
  for (std::size_t f = 0; f < a.size(); ++f) result.emplace_back(a[f] - b[f]);
  return result;
}

/// X_FK and X_D at the file's headings; what the file lacks comes from the mesh.
std::pair<LoadTable, LoadTable> both_loads(const Database& d, const Move& move,
                                           const FloatingMesh& body,
                                           std::vector<std::string>& notes) {
  LoadTable total = moved(d, move, d.excitation), known = moved(d, move, d.froude_krylov),
            diffraction = moved(d, move, d.diffraction);
  if (known.loads.empty() && !diffraction.loads.empty() && !total.loads.empty()) {
    known.loads = difference(total.loads, diffraction.loads);
  } else if (known.loads.empty()) {
    known.loads =
        hydro::froude_krylov(body.mesh_B, body.pose, move.water, d.frequencies, known.headings);
    notes.emplace_back("Froude-Krylov forces: those on the mesh");
  }
  if (diffraction.loads.empty()) diffraction.loads = difference(total.loads, known.loads);
  return {std::move(known), std::move(diffraction)};
}

void find_infinite_added_mass(Database& d, double lever, std::vector<std::string>& notes) {
  if (d.infinite_added_mass) return;
  const auto found = infinite_added_mass(d.frequencies, d.added_mass, d.damping);
  const std::string why = "has no added mass at infinite frequency, ";
  if (!found) refuse(d, why + "and too few frequencies for Ogilvie's relation; expected 6 or more");
  hydro::Vector6d weight = hydro::Vector6d::Ones();
  weight.tail<3>() /= lever;
  const auto largest = [&](const Matrix6d& matrix) {
    return (weight.asDiagonal() * matrix * weight.asDiagonal()).cwiseAbs().maxCoeff();
  };
  const double spread = largest(found->spread) / largest(found->matrix);
  if (!(spread <= kLargestSpread))
    refuse(d,
           fmt::format(
               "{}and by Ogilvie's relation the frequencies up to {:g} rad/s give it only "
               "within {:.2g} %; expected {:g} %, for which `frequencies` may leave out a bad end",
               why, d.frequencies.back(), 100 * spread, 100 * kLargestSpread));
  d.infinite_added_mass = found->matrix;
  notes.push_back(
      fmt::format("added mass at infinite frequency: by Ogilvie's relation, within "
                  "{:.2g} %",
                  100 * spread));
}

void note_depth(const Move& move, const FloatingMesh& body, const Database& d,
                std::vector<std::string>& notes) {
  const double theirs = move.water.depth, ours = body.water.depth;
  if (theirs == ours || std::abs(theirs / ours - 1) < 0.01) return;
  const double k =
      hydro::wave_number(d.frequencies[0], std::min(theirs, ours), body.water.gravity).value();
  if (k * std::min(theirs, ours) > M_PI) return;  // Both are deep for the longest waves.
  const auto text = [](double depth) {
    return std::isfinite(depth) ? fmt::format("a depth of {:g} m", depth) : "infinite depth";
  };
  notes.push_back(
      fmt::format("the file is for water of {}, the scene's has {}", text(theirs), text(ours)));
}

/// Takes out what is mere round-off of the file's program: couplings that the symmetries forbid,
/// and the memory of motions that make next to no waves. Oscillators would be fitted to it.
void take_noise_out(const BodySymmetry& symmetry, double lever, hydro::RadiationData& data) {
  Matrix6d& limit = data.infinite_added_mass;
  take_forbidden_out(symmetry, limit);
  hydro::Vector6d response = hydro::Vector6d::Zero();
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    take_forbidden_out(symmetry, data.added_mass[f]);
    take_forbidden_out(symmetry, data.damping[f]);
    const Matrix6d kept = data.frequencies[f] * (data.added_mass[f] - limit);
    response = response.cwiseMax(data.damping[f].diagonal().cwiseAbs())
                   .cwiseMax(kept.diagonal().cwiseAbs());
  }
  response.tail<3>() /= lever * lever;
  for (Eigen::Index i = 0; i < 6; ++i) {
    if (response[i] > kLeastResponse * response.maxCoeff()) continue;
    for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
      data.added_mass[f].row(i) = limit.row(i);
      data.added_mass[f].col(i) = limit.col(i);
      data.damping[f].row(i).setZero();
      data.damping[f].col(i).setZero();
    }
  }
}

/// Adds the loads of waves, which may be missing in still water.
void add_loads(const Database& d, const Move& move, const FloatingMesh& body,
               const BodySymmetry& symmetry, double lever, BodyData& result) {
  hydro::RadiationData& data = result.data;
  if (d.excitation.empty() && d.diffraction.empty()) {
    if (body.waves) refuse(d, "has no loads of waves, and the scene's water has waves");
    result.notes.emplace_back("the file has no loads of waves, and the water is still");
    return;
  }
  auto [froude_krylov, diffraction] = both_loads(d, move, body, result.notes);
  Neighbours neighbours;
  if (!d.neighbours.empty())
    neighbours = [&](std::size_t f) -> Eigen::Matrix<double, 6, 3> {
      const Matrix3d turn = move.to_H.topLeftCorner<3, 3>();
      return move.to_H * move.by_center.transpose() * d.neighbours[f] * turn.transpose();
    };
  check_loads_by_mesh(d, body, froude_krylov, diffraction, neighbours, lever, result);
  try {
    const std::string how = complete_circle(symmetry, {&froude_krylov, &diffraction});
    if (!how.empty()) result.notes.push_back(how);
  } catch (const std::invalid_argument& error) {
    if (body.waves) refuse(d, error.what());
    result.notes.push_back(
        fmt::format("loads of waves are left out, as the water is still: the "
                    "file {}",
                    error.what()));
    return;
  }
  data.headings = froude_krylov.headings;
  data.froude_krylov = std::move(froude_krylov.loads);
  data.diffraction = std::move(diffraction.loads);
  check_loads(d, lever, result);
}

}  // namespace

BodyData fit_to_body(const Database& database, const scene::RadiationFile& source,
                     const FloatingMesh& body) {
  Database d = database;
  BodyData result{.data = {}, .checks = {}, .notes = d.notes};
  result.data.pose = body.pose;
  check_statics(d, body, result);
  const double lever = std::cbrt(result.data.volume);
  check_matrices(d, lever, result);
  find_infinite_added_mass(d, lever, result.notes);
  const Move move = move_of(d, source, body, lever, result.notes);
  note_depth(move, body, d, result.notes);
  hydro::RadiationData& data = result.data;
  data.water = move.water;
  data.frequencies = d.frequencies;
  for (const Matrix6d& A : d.added_mass) data.added_mass.push_back(move.matrix(A));
  for (const Matrix6d& B : d.damping) data.damping.push_back(move.matrix(B));
  data.infinite_added_mass = move.matrix(*d.infinite_added_mass);
  const BodySymmetry symmetry = symmetry_of(body.mesh_B, body.pose, data.added_mass);
  take_noise_out(symmetry, lever, data);
  add_loads(d, move, body, symmetry, lever, result);
  return result;
}

}  // namespace databases
