#include "hydro/lines/lumped_line.h"

#include <algorithm>
#include <optional>

#include "hydro/lines/lumped_step.h"

namespace hydro {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;

/// Newton's last change of a node in the search for the rest, over the length of a segment [-].
constexpr double kSolvedAtRest = 1e-7;
/// At rest a line moves by less than this part of its length in a step [-].
constexpr double kAtRest = 1e-11;
constexpr int kMostRestSteps = 400;

}  // namespace

double resting_length(const LumpedLine& line, double length, const LumpedState& state) {
  Index rests = 0;
  for (Index i = 1; i < state.places.cols(); ++i)
    if (std::max(state.places(2, i - 1), state.places(2, i)) <= line.bottom) ++rests;
  return static_cast<double>(rests) * length / line.segments;
}

// Steps of Euler's implicit rule without mass, in a thick fluid that gets thinner and thinner, come
// to the rest of any convex energy.
LumpedState line_at_rest(const LumpedLine& line, double length, const LineEnds& ends,
                         const Sea* sea) {
  const Index count = line.segments + 1;
  LumpedState state;
  state.places.resize(3, count);
  for (Index i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / line.segments;
    state.places.col(i) = (1 - part) * ends.col(0) + part * ends.col(1);
  }
  const double l = length / line.segments;
  std::optional<Sea> still;
  if (sea) {
    still = *sea;
    still->surface = FlatSurface{};
  }
  Matrix3Xd zero = Matrix3Xd::Zero(3, count);
  const double thinnest = 1e-9 * line.stiffness / l;  // [N/m]
  // At first a node moves by l under its weight.
  double thickness = std::max(line.mass * line.gravity, thinnest);
  LineSolver solver;
  for (int i = 0; i < kMostRestSteps; ++i) {
    LineEquations e{.line = line,
                    .l = l,
                    .rate = 1,
                    .moving = -state.places,
                    .speeding = zero,
                    .nodes = {},
                    .dampers = {}};
    e.line.damping = 0;
    for (Index k = 0; k < count; ++k) {
      NodeTerms node = terms_of(line, l, state.places, zero, k, still ? &*still : nullptr, 0);
      node.inertia.setZero();
      node.damping = thickness * Matrix3d::Identity();
      e.nodes.push_back(node);
    }
    Matrix3Xd x = state.places;
    state.forces = forces_of(solver.solve(e, kSolvedAtRest, x));
    const double moved = (x - state.places).colwise().norm().maxCoeff();
    state.places = x;
    if (moved <= kAtRest * length && i > 0) break;
    thickness = std::max(thickness / 2, thinnest);
  }
  state.places_before = state.places;
  state.velocities = state.velocities_before = zero;
  return state;
}

}  // namespace hydro
