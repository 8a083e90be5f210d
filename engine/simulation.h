#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/force_log.h"
#include "engine/pull.h"
#include "engine/spec.h"

namespace engine {

/// The simulation cannot go on: a state or load that is not finite, or the engine's refusal.
class SimulationError : public std::runtime_error {
 public:
  SimulationError(double time, std::string body, const std::string& what);
  double time() const { return time_; }              ///< [s]
  const std::string& body() const { return body_; }  ///< Empty if no single body is to blame.

 private:
  double time_;
  std::string body_;
};

/// Wall time spent so far, by stage [s].
struct Timings {
  double collision = 0;
  double hydro = 0;
  double engine = 0;
};

/// What the steps so far did not compute because the scene did not need it.
struct Skips {
  bool collision = false;           ///< Nothing in the scene can collide.
  bool water = false;               ///< No water, or no body that it acts on.
  std::vector<long> dry_steps;      ///< Per body: load evaluations above the highest water.
  std::vector<long> resting_steps;  ///< Per body: evaluations that took over the last load, since
                                    ///< neither the body nor the water had moved.
  std::vector<long> asleep_steps;   ///< Per body: steps that it slept through (sleep.h).
};

/// How a body's motion was found, in steps and pieces of steps so far.
struct Path {
  long free = 0;         ///< Steps by itself, or along a joint to the world (guide.h).
  long constrained = 0;  ///< Steps under other joints, or contacts.
  long pieces = 0;       ///< That those steps were cut in.
  long implicit = 0;     ///< Pieces too long for its loads to be taken explicitly (kick.h).
  long iterations = 0;   ///< Solutions of its constraints, one a piece without added mass.
  long unconverged = 0;  ///< Pieces in which they did not reach their tolerance.
  long braked = 0;       ///< Pieces slowed so that still water gives no energy (free_step.h).
};

/// Bodies in the sea, moved step by step. Owns the mechanics engine.
class Simulation {
 public:
  /// @throws std::invalid_argument for a step, body or joint that makes no sense (body_check.h),
  ///         SimulationError if the engine refuses the description.
  explicit Simulation(SimulationSpec spec);
  ~Simulation();
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;

  const SimulationSpec& spec() const;
  double time() const;  ///< steps()·step [s].
  long steps() const;
  const std::vector<hydro::BodyState>& states() const;  ///< In the order of the specification.
  /// What acts on each body in its present state, and the works so far.
  /// @throws std::logic_error unless the specification asks for books.
  std::vector<BodyForces> forces() const;
  const Timings& timings() const;
  const Skips& skips() const;
  const std::vector<Path>& paths() const;  ///< Per body.
  /// What the user should know of the run so far, each once, as whole sentences.
  const std::vector<std::string>& warnings() const;

  /// Draws the body by one of its points in all steps to come; none lets it go. At most one pull a
  /// body, at a rate of at most kFastestPull a step; a body that cannot move does not.
  void pull(BodyId body, const std::optional<Pull>& pull);

  /// One step. The state before it is kept if it throws; every later step then throws too.
  /// @throws SimulationError
  void step();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace engine
