#include "app/databases/database_checks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/databases/bad_ends.h"
#include "app/databases/bounds.h"
#include "app/scene/diagnostics.h"
#include "hydro/added_mass/wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/radiation/froude_krylov.h"
#include "hydro/statics/hydrostatics.h"

namespace databases {
namespace {

using Eigen::Index;
using hydro::Matrix6d;
using std::numbers::pi;

// Panel methods stay below what is noted; what is refused is of another body or convention.
constexpr Bounds kVolume = {0.01, 0.1};
constexpr Bounds kWaterplane = {0.02, 0.2};
constexpr Bounds kHaskind = {0.05, 0.3};
/// Part of the frequencies that may contradict Haskind's relation and be left out, where all of
/// them lie at the ends (bad_ends.h) [-].
constexpr double kMostAtEnds = 1.0 / 3;
constexpr Bounds kFroudeKrylov = {0.05, 0.3};
constexpr Bounds kLongWaves = {0.1, 0.3};

/// Wave number by the lever at which Froude-Krylov forces are compared [-].
constexpr double kCompared = 0.5;
/// Wave numbers by half the body's length between which the whole excitation is [-]: in longer
/// waves moments are small differences.
constexpr double kShortest = 0.1, kLongest = 0.3;
/// Part of the moment of the horizontal force by the lever that counts as the least moment [-].
constexpr double kLeastMoment = 0.1;

/// Longest waves' wave number by the lever below which the body is small in them [-].
constexpr double kLongWave = 0.5;
/// Least part of the push that a body of its volume must feel in them for the phase to count [-].
constexpr double kLeastPush = 0.2;

/// Group velocity [m/s].
double group_velocity(double omega, double k, double depth) {
  const double kh = k * depth;
  return omega / (2 * k) * (1 + (kh > 300 ? 0 : 2 * kh / std::sinh(2 * kh)));
}

/// How far the damping of a frequency is from Haskind's relation.
struct Mismatch {
  double frequency = 0;  ///< [rad/s]
  double error = 0;      ///< Largest difference of weighted entries.
  double size = 0;       ///< Largest entry, of the smaller of the two matrices.
  Index row = 0, column = 0;
};

Mismatch haskind_mismatch(const hydro::RadiationData& data, std::size_t f, double lever) {
  Mismatch found{.frequency = data.frequencies[f]};
  const hydro::LinearWater& water = data.water;
  const double k = hydro::wave_number(found.frequency, water.depth, water.gravity).value();
  const hydro::Loads6cd X = data.froude_krylov[f] + data.diffraction[f];
  const double factor = k /
                        (8 * pi * water.gravity * group_velocity(found.frequency, k, water.depth)) *
                        2 * pi / static_cast<double>(X.cols());
  const Matrix6d radiated = weighted(factor * (X * X.adjoint()).real(), lever);
  const Matrix6d damping = weighted(data.damping[f], lever);
  found.error = (radiated - damping).cwiseAbs().maxCoeff(&found.row, &found.column);
  found.size = std::min(radiated.cwiseAbs().maxCoeff(), damping.cwiseAbs().maxCoeff());
  return found;
}

template <class T>
void keep_only(const std::vector<bool>& kept, std::vector<T>& list) {
  std::size_t next = 0;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (kept[f]) std::swap(list[next++], list[f]);
  list.resize(next);
}

/// Leaves out single frequencies that contradict themselves: those of sloshing inside the hull, at
/// which panel methods have no unique solution.
void drop_frequencies(const std::vector<bool>& kept, const std::vector<Mismatch>& mismatches,
                      BodyData& found) {
  std::vector<double> dropped;
  for (std::size_t f = 0; f < kept.size(); ++f)
    if (!kept[f]) dropped.push_back(mismatches[f].frequency);
  found.notes.push_back(
      fmt::format("{} of {} frequencies contradict Haskind's relation and are left "
                  "out: {} rad/s",
                  dropped.size(), kept.size(), in_words(dropped)));
  hydro::RadiationData& data = found.data;
  keep_only(kept, data.frequencies);
  keep_only(kept, data.added_mass);
  keep_only(kept, data.damping);
  keep_only(kept, data.froude_krylov);
  keep_only(kept, data.diffraction);
}

void check_push(const Database& d, BodyData& found) {
  const hydro::RadiationData& data = found.data;
  const double k =
      hydro::wave_number(data.frequencies[0], data.water.depth, data.water.gravity).value();
  double push = 0;  // Along the waves, in phase with the water's acceleration.
  for (std::size_t h = 0; h < data.headings.size(); ++h) {
    const auto X = (data.froude_krylov[0] + data.diffraction[0]).col(static_cast<Index>(h)).imag();
    push -= X[0] * std::cos(data.headings[h]) + X[1] * std::sin(data.headings[h]);
  }
  const double expected =
      data.water.gravity * k * data.volume * static_cast<double>(data.headings.size());
  if (push < -kLeastPush * expected)
    refuse(d, fmt::format("excitation at {:g} rad/s: the waves push the body against the water's "
                          "acceleration, rows 1 and 2; expected the other sign of the imaginary "
                          "part, or of the headings",
                          data.frequencies[0]));
}

/// The water's acceleration at the centre of mass, over the elevation there [1/s^2].
Eigen::Vector3cd acceleration(const FloatingMesh& body, const hydro::LinearWater& water, double k,
                              double heading) {
  const double z = std::min(0.0, body.pose.height);
  const double below = std::exp(-2 * k * (z + water.depth)),
               bottom = std::exp(-2 * k * water.depth);
  const double gk = water.gravity * k * std::exp(k * z) / (1 + bottom);
  const std::complex<double> along(0, -gk * (1 + below));
  return {along * std::cos(heading), along * std::sin(heading), -gk * (1 - below)};
}

/// Refuses loads that differ from those of the mesh.
/// @param terms   Whose sum the loads are: where they cancel, they tell the size of an error.
void compare_loads(const Database& d, const char* what, double omega, const hydro::Loads6cd& theirs,
                   const std::vector<hydro::Loads6cd>& terms, double lever, const Bounds& bounds,
                   BodyData& found) {
  hydro::Loads6cd ours = hydro::Loads6cd::Zero(6, theirs.cols());
  double force = theirs.topRows<3>().cwiseAbs().maxCoeff();
  double moment = theirs.bottomRows<3>().cwiseAbs().maxCoeff();
  for (const hydro::Loads6cd& term : terms) {
    ours += term;
    force = std::max(force, term.topRows<3>().cwiseAbs().maxCoeff());
    moment = std::max(moment, term.bottomRows<3>().cwiseAbs().maxCoeff());
  }
  const double horizontal = ours.topRows<2>().cwiseAbs().maxCoeff();
  moment = std::max(moment, kLeastMoment * lever * horizontal);
  Eigen::MatrixXd error = (theirs - ours).cwiseAbs();
  error.topRows<3>() /= force;
  error.bottomRows<3>() /= moment;
  Index row = 0, column = 0;
  const double worst = error.maxCoeff(&row, &column);
  if (!(worst <= bounds.refused))
    refuse(d, fmt::format("{} at {:.4g} rad/s, row {}: found {:.4g}, and by the mesh {:.4g} (over "
                          "the density, about the body's centre of mass); expected them to agree "
                          "within {:g} %; reference_point, center_of_mass or heading_deg may be "
                          "wrong",
                          what, omega, row + 1, std::abs(theirs(row, column)),
                          std::abs(ours(row, column)), 100 * bounds.refused));
  add_check(fmt::format("{} against the mesh", what), worst, bounds, found);
}

}  // namespace

void check_loads_by_mesh(const Database& d, const FloatingMesh& body,
                         const LoadTable& froude_krylov, const LoadTable& diffraction,
                         const Neighbours& neighbours, double lever, BodyData& found) {
  const hydro::LinearWater& water = found.data.water;
  const auto wave_number = [&](std::size_t f) {
    return hydro::wave_number(d.frequencies[f], water.depth, water.gravity).value();
  };
  const auto on_mesh = [&](std::size_t f) {
    return hydro::froude_krylov(body.mesh_B, body.pose, water, {d.frequencies[f]},
                                froude_krylov.headings)[0];
  };
  std::size_t f = 0;
  if (!d.froude_krylov.empty()) {
    while (f + 1 < d.frequencies.size() && wave_number(f) * lever < kCompared) ++f;
    return compare_loads(d, "Froude-Krylov force", d.frequencies[f], froude_krylov.loads[f],
                         {on_mesh(f)}, lever, kFroudeKrylov, found);
  }
  const double half_length = body.mesh_B.vertices.colwise().norm().maxCoeff();
  while (f + 1 < d.frequencies.size() && wave_number(f + 1) * half_length < kLongest) ++f;
  const double k = wave_number(f);
  if (k * half_length < kShortest || k * half_length > kLongest) return;
  // The others are held, too, and the water accelerates past all alike.
  Eigen::Matrix<double, 6, 3> A = found.data.added_mass[f].leftCols<3>();
  if (neighbours) A += neighbours(f);
  hydro::Loads6cd pushed(6, static_cast<Index>(froude_krylov.headings.size()));
  for (Index h = 0; h < pushed.cols(); ++h)
    pushed.col(h) =
        A.cast<std::complex<double>>() *
        acceleration(body, water, k, froude_krylov.headings[static_cast<std::size_t>(h)]);
  compare_loads(d, "excitation in long waves", d.frequencies[f],
                froude_krylov.loads[f] + diffraction.loads[f], {on_mesh(f), pushed}, lever,
                kLongWaves, found);
}

void check_statics(const Database& d, const FloatingMesh& body, BodyData& found) {
  const hydro::Hydrostatics own = hydro::hydrostatics(
      hydro::transformed(body.mesh_B, Eigen::Isometry3d(body.pose.orientation)), body.pose.height);
  found.data.volume = own.volume;
  const auto compare = [&](const char* what, const char* unit, double theirs, double ours,
                           const Bounds& bounds) {
    const double difference = theirs / ours - 1;
    if (!(std::abs(difference) < bounds.refused))
      refuse(d,
             fmt::format("found a {} of {:.5g} {}, and the body's is {:.5g} {} in its mean pose; "
                         "expected them to agree within {:g} %",
                         what, theirs, unit, ours, unit, 100 * bounds.refused));
    add_check(fmt::format("{} against the mesh", what), difference, bounds, found);
  };
  if (d.volume) compare("displaced volume", "m^3", *d.volume, own.volume, kVolume);
  if (d.waterplane_area && own.waterplane.area > 0)
    compare("waterplane", "m^2", *d.waterplane_area, own.waterplane.area, kWaterplane);
}

void check_loads(const Database& d, double lever, BodyData& found) {
  std::vector<Mismatch> mismatches;
  double largest = 0;
  for (std::size_t f = 0; f < found.data.frequencies.size(); ++f) {
    mismatches.push_back(haskind_mismatch(found.data, f, lever));
    largest = std::max(largest, mismatches.back().size);
  }
  if (largest > 0) {
    const auto worst =
        std::max_element(mismatches.begin(), mismatches.end(),
                         [](const Mismatch& a, const Mismatch& b) { return a.error < b.error; });
    std::vector<bool> bad;
    for (const Mismatch& each : mismatches) bad.push_back(each.error > kHaskind.refused * largest);
    const auto& [kept, dropped, at_ends] = without_bad(bad);
    if (static_cast<double>(dropped) >
        (at_ends ? kMostAtEnds : kMostDropped) * static_cast<double>(kept.size()))
      refuse(d, fmt::format("damping at {:g} rad/s, row {}, column {}: differs by {:.2g} % of the "
                            "largest from that of the loads of waves (Haskind's relation), and at "
                            "{} of {} frequencies by more than {:g} %",
                            worst->frequency, worst->row + 1, worst->column + 1,
                            100 * worst->error / largest, dropped, kept.size(),
                            100 * kHaskind.refused));
    if (dropped > 0) drop_frequencies(kept, mismatches, found);
    double left = 0;
    for (std::size_t f = 0; f < kept.size(); ++f)
      if (kept[f]) left = std::max(left, mismatches[f].error / largest);
    add_check("damping against Haskind's relation", left, kHaskind, found);
  }
  const hydro::RadiationData& data = found.data;
  const double k =
      hydro::wave_number(data.frequencies[0], data.water.depth, data.water.gravity).value();
  if (k * lever < kLongWave) check_push(d, found);
}

}  // namespace databases
