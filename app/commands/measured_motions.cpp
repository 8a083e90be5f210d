#include "app/commands/measured_motions.h"

#include <algorithm>
#include <cmath>

#include "app/assembly/build.h"
#include "engine/simulation.h"
#include "hydro/decompositions.h"

namespace app {
namespace {

using Eigen::Vector3d;
using hydro::Matrix6d;
using hydro::Vector6d;

// In periods of the wave.
constexpr int kRamp = 5;
constexpr int kWindow = 10;  ///< Length of a fit.
constexpr int kDuration = 3 * kWindow;
constexpr int kLeastSteps = 40;

/// Places and attitudes of a body, a state each step.
struct Track {
  std::vector<double> times;
  std::vector<Vector6d> motions;  ///< From the first state, with the turn as a vector, in W.
};

/// The scene in one wave.
scene::Scene in_wave(scene::Scene scene, const RegularWave& wave, double slope) {
  const double steps = std::max<double>(kLeastSteps, std::ceil(wave.period / scene.step));
  scene.step = wave.period / steps;
  scene.duration = kDuration * wave.period;
  scene.log_forces = false;
  scene.render.reset();
  scene.water->surface = std::vector<scene::Wave>{{.amplitude = slope / wave.wave_number,
                                                   .wavelength = {},
                                                   .period = wave.period,
                                                   .heading = wave.heading}};
  scene.water->kinematics = hydro::Kinematics::airy;
  scene.water->ramp = kRamp * wave.period;
  return scene;
}

Vector6d motion_from(const hydro::BodyState& first, const hydro::BodyState& now) {
  const Eigen::AngleAxisd turn(now.orientation * first.orientation.conjugate());
  const double angle = std::remainder(turn.angle(), 2 * M_PI);
  Vector6d motion;
  motion << now.position - first.position, angle * turn.axis();
  return motion;
}

/// The last two windows of a run, a track for each body.
std::vector<std::vector<Track>> run(const engine::SimulationSpec& spec, double period) {
  engine::Simulation simulation(spec);
  const std::vector<hydro::BodyState> first = simulation.states();
  std::vector<std::vector<Track>> windows(2, std::vector<Track>(first.size()));
  const auto window_steps = static_cast<long>(std::lround(kWindow * period / spec.step));
  for (long step = 1; step <= 3 * window_steps; ++step) {
    simulation.step();
    if (step <= window_steps) continue;
    const std::size_t window = step > 2 * window_steps ? 1 : 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      windows[window][i].times.push_back(simulation.time());
      windows[window][i].motions.push_back(motion_from(first[i], simulation.states()[i]));
    }
  }
  return windows;
}

/// Mean, drift and two harmonics of six motions, a column each, over the phase θ of the wave.
using Fit = Eigen::Matrix<double, 6, 6>;

Fit fit(const Track& track, const std::vector<double>& theta) {
  Matrix6d squares = Matrix6d::Zero();
  Fit products = Fit::Zero();
  const double middle = track.times[track.times.size() / 2];
  const double length = track.times.back() - track.times.front();
  for (std::size_t i = 0; i < theta.size(); ++i) {
    Vector6d row;
    row << 1, (track.times[i] - middle) / length, std::cos(theta[i]), std::sin(theta[i]),
        std::cos(2 * theta[i]), std::sin(2 * theta[i]);
    squares += row * row.transpose();
    products += row * track.motions[i].transpose();
  }
  const hydro::Cholesky6 factor(squares);
  Fit found;
  for (Eigen::Index m = 0; m < 6; ++m) found.col(m) = factor.solve(products.col(m));
  return found;
}

/// First harmonics c + i s of x = Re{(c + i s) e^{−iθ}}, θ the wave's phase at the body's mean
/// path.
hydro::Vector6cd harmonics(const Track& track, const RegularWave& wave, const Vector3d& start) {
  const Vector3d k(wave.wave_number * std::cos(wave.heading),
                   wave.wave_number * std::sin(wave.heading), 0);
  std::vector<double> theta;
  for (const double time : track.times)
    theta.push_back(std::remainder(wave.frequency * time, 2 * M_PI));
  const Fit at_start = fit(track, theta);
  const Vector3d mean = at_start.row(0).head<3>(), drift = at_start.row(1).head<3>();
  const double middle = track.times[track.times.size() / 2];
  const double length = track.times.back() - track.times.front();
  for (std::size_t i = 0; i < theta.size(); ++i)
    theta[i] -= k.dot(start + mean + (track.times[i] - middle) / length * drift);
  const Fit found = fit(track, theta);
  return found.row(2).transpose().cast<std::complex<double>>() +
         std::complex<double>(0, 1) * found.row(3).transpose().cast<std::complex<double>>();
}

/// Largest change of an amplitude over the largest of its kind.
double change_between(const hydro::Vector6cd& before, const hydro::Vector6cd& last) {
  const Vector6d change = last.cwiseAbs() - before.cwiseAbs();
  double most = 0;
  for (const int kind : {0, 3}) {
    const double largest = last.segment<3>(kind).cwiseAbs().maxCoeff();
    if (largest > 0) most = std::max(most, change.segment<3>(kind).cwiseAbs().maxCoeff() / largest);
  }
  return most;
}

}  // namespace

std::vector<MeasuredMotions> measured_motions(const scene::Scene& scene, const RegularWave& wave,
                                              double slope,
                                              const std::vector<LinearMotions>& bodies,
                                              assembly::AddedMassStore& store, Reporter& reporter) {
  const engine::SimulationSpec spec =
      assembly::build(in_wave(scene, wave, slope), store, reporter).spec;
  const auto windows = run(spec, wave.period);
  std::vector<MeasuredMotions> all;
  for (const LinearMotions& body : bodies) {
    const auto i = static_cast<std::size_t>(
        std::ranges::find(spec.bodies, body.name, &engine::BodySpec::name) - spec.bodies.begin());
    const Vector3d& start = spec.bodies[i].initial.position;
    const hydro::Vector6cd before = harmonics(windows[0][i], wave, start);
    const hydro::Vector6cd last = harmonics(windows[1][i], wave, start);
    const Matrix6d to_H = hydro::turn_of_heading(body.heading).transpose();
    hydro::Vector6cd in_H;
    in_H.real() = to_H * last.real();
    in_H.imag() = to_H * last.imag();
    all.push_back(
        {.first = wave.wave_number / slope * in_H, .change = change_between(before, last)});
  }
  return all;
}

}  // namespace app
