#pragma once

#include <array>
#include <vector>

#include "hydro/lines/lumped_line.h"

/// @file
/// A step of a line with inertia (lumped_line.h): its equations and their solution.

namespace hydro {

/// What acts on a node in a step, but for the springs: G x'' + C x' = load.
struct NodeTerms {
  Eigen::Matrix3d inertia, damping;
  Eigen::Vector3d load;
  double bottom = 0;  ///< Stiffness of the bottom [N/m].
};

/// Terms of a node. @param l   Length of a segment [m]. @param x, v   Expected places and
/// velocities of the nodes.
NodeTerms terms_of(const LumpedLine& line, double l, const Eigen::Matrix3Xd& x,
                   const Eigen::Matrix3Xd& v, Eigen::Index node, const Sea* sea, double time);

/// The equations of a step: (2) of lumped_line.h as x' = rate x + …, x'' = rate x' + …
struct LineEquations {
  LumpedLine line;
  double l = 0;               ///< Length of a segment [m].
  double rate = 0;            ///< 3/2h [1/s]
  Eigen::Matrix3Xd moving;    ///< x' at x = 0.
  Eigen::Matrix3Xd speeding;  ///< x'' at x' = 0.
  std::vector<NodeTerms> nodes;
  std::vector<Eigen::Matrix3d> dampers;  ///< Of the segments.
};

/// The slope of the energy at the nodes, and the blocks of its second derivatives.
struct LineSlope {
  Eigen::Matrix3Xd residual;
  std::vector<Eigen::Matrix3d> diagonal, beside;  ///< The latter couples a node with the next one.
};

/// Forces on what holds the ends of a line.
LineEnds forces_of(const LineSlope& slope);

/// Newton's method with a line search. It keeps its memory from one step to the next.
class LineSolver {
 public:
  /// Moves the nodes between the ends to the least energy.
  /// @param solved   The last change of a node, over the length of a segment, with which the search
  ///                 ends [-]: what is left is of its square.
  /// @return the slope there
  const LineSlope& solve(const LineEquations& e, double solved, Eigen::Matrix3Xd& x);

 private:
  void find_change();

  LineSlope slope_, next_;
  Eigen::Matrix3Xd change_, next_x_;
  std::vector<Eigen::Matrix3d> inverse_;
};

/// What a line is about to do at the end of a step, if its ends go to given places.
struct LineResponse {
  LineEnds forces;  ///< On what holds its ends [N].
  /// −∂F/∂x of each end, the other one held [N/m].
  std::array<Eigen::Matrix3d, 2> stiffness;
};

/// A step of a line.
class LumpedStep {
 public:
  /// Begins the step that follows a state.
  /// @param length, ends   Expected at the end of the step.
  /// @param time           End of the step [s].
  /// @param h              Length of the step [s]; that of the step before was the same.
  /// @return the response to such ends
  const LineResponse& begin(const LumpedLine& line, double length, const LineEnds& ends,
                            const Sea* sea, double time, double h, const LumpedState& state);
  const LineResponse& response() const { return response_; }
  /// Takes the line through the step that has begun, to where its ends are. @param state   As then.
  void end(const LineEnds& ends, LumpedState& state);

 private:
  LineEquations equations_;
  LineSolver solver_;
  Eigen::Matrix3Xd places_, velocities_;
  LineResponse response_;
};

}  // namespace hydro
