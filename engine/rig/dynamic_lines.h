#pragma once

#include <array>
#include <functional>
#include <vector>

#include "engine/base/spec.h"
#include "hydro/lines/lumped_step.h"

/// @file
/// Lines with inertia (hydro/lines/lumped_line.h) on the bodies of a simulation. A line takes the
/// whole step at once, its bodies take substeps of it.
///
/// At the start t_n of a step of the length h the line is asked for its response to ends that go on
/// at their velocities, to the places x̂: the forces F̂ on its holders at t_n + h, and its stiffness
/// K for each end. In a substep of the length η, at the part s of the step and τ before its end, an
/// end has the force
///
///     F = F_n + θ (F̂ − F_n − K (x + τ v − x̂)),                                             (E34)
///
/// x and v its place and velocity halfway, before the update. The update moves the end by a further
/// τ Δv until the end of the step, so that
///
///     (S + θ τ η K) Δu = η F.                                                              (E35)
///
/// θ is s where the step resolves the oscillation of the bodies on the taut line, and 1 where it
/// does not (spring_weights in force_row.h has the same bounds): a stiff line that goes slack would
/// throw its bodies about with F_n. With one substep θ = ½ is the implicit midpoint rule with the
/// mean of the forces at both ends of the step, of second order. The line then takes the step to
/// where its ends are. Between two bodies K counts twice in (E35), as each of them holds the line
/// for the other.

namespace engine {

struct SubstepBody;

/// Longest step with which a line with inertia may join two bodies that move [s]; infinite for any
/// other line.
double longest_step(const SimulationSpec& spec, const LineSpec& line);

class DynamicLines {
 public:
  /// Starts with the lines at rest. @param spec   It must outlive this.
  /// @throws std::invalid_argument where the step is longer than longest_step()
  explicit DynamicLines(const SimulationSpec& spec);

  /// True if a line of the specification is one of these.
  bool has(std::size_t line) const { return place_[line] >= 0; }
  bool acts_on(BodyId body) const { return !ends_of_[static_cast<std::size_t>(body)].empty(); }
  bool empty() const { return lines_.empty(); }

  /// The unstretched length of a line at a time [m].
  using LengthAt = std::function<double(std::size_t line, double time)>;

  /// Asks the lines for their responses in the step from a time on.
  void begin_step(const std::vector<hydro::BodyState>& states, double time, double h,
                  const LengthAt& length_at);
  /// Adds (E34) to the load on a body halfway in a substep of the length h, and (E35) to its
  /// inertia. @param time   Halfway [s].
  void add_update(double time, double h, SubstepBody& body) const;
  /// Takes the lines through the step. @param states   At its end.
  void follow(const std::vector<hydro::BodyState>& states);

  /// Brings the lines of a body that has been put elsewhere to rest.
  void settle(BodyId body, const std::vector<hydro::BodyState>& states, double time,
              const LengthAt& length_at);
  /// Ends the pull of a line, or gives it back. This is no part of state().
  void set_broken(std::size_t line, bool broken) { of(line).broken = broken; }

  /// Adds the forces of the lines on a body: moments about its centre of mass, in W.
  void add_load(BodyId body, const hydro::BodyState& state, hydro::Wrench& load) const;
  /// Force of a line on its first holder, W [N].
  Eigen::Vector3d force(std::size_t line) const { return of(line).force(0); }
  /// The larger tension of its ends [N].
  double tension(std::size_t line) const;
  /// The nodes of a line, from its first end to its second [m]; none of one that is broken.
  std::vector<Eigen::Vector3d> nodes(std::size_t line) const;
  /// Length that lies on the bottom [m].
  double resting(std::size_t line, double length) const;

  /// The changing side of the lines.
  std::vector<hydro::LumpedState> state() const;
  bool fits(const std::vector<hydro::LumpedState>& state) const;
  void restore(const std::vector<hydro::LumpedState>& state);

 private:
  struct Line {
    std::size_t index;       ///< In the specification.
    hydro::LumpedLine line;  ///< Its properties.
    bool between = false;    ///< Both its ends are on bodies that move.
    double unresolved = 0;   ///< 0: the step resolves the bodies on the taut line; 1: it does not.
    bool broken = false;
    hydro::LumpedState motion;
    hydro::LineEnds aimed = hydro::LineEnds::Zero();  ///< x̂ [m]
    hydro::LumpedStep step;

    Eigen::Vector3d force(int end) const;
  };
  struct End {
    std::size_t line;  ///< In `lines_`.
    int side;          ///< 0: first.
  };
  const Line& of(std::size_t line) const { return lines_[static_cast<std::size_t>(place_[line])]; }
  Line& of(std::size_t line) { return lines_[static_cast<std::size_t>(place_[line])]; }
  const AttachmentPoint& point(const Line& line, int side) const;
  void settle(Line& line, double length, const std::vector<hydro::BodyState>& states);
  hydro::LineEnds places(const Line& line, const std::vector<hydro::BodyState>& states) const;

  const SimulationSpec* spec_;
  const hydro::Sea* sea_;
  std::vector<Line> lines_;
  std::vector<int> place_;                 ///< Per line of the specification: in `lines_`, or −1.
  std::vector<std::vector<End>> ends_of_;  ///< Per body.
  double step_start_ = 0, step_ = 1;       ///< t_n, h [s]
};

}  // namespace engine
