#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/assembly/built_scene.h"

namespace app {

/// Froude number above which the waves that a hull makes by going ahead take much of its drive [-].
inline constexpr double kWaveMakingFroudeNumber = 0.2;

/// Volume Froude number U/√(g ∇^⅓), of the volume afloat, above which hulls begin to plane [-].
inline constexpr double kPlaningFroudeNumber = 1.2;

/// Watches the motion of a run for what the theory of its loads leaves out, and tells each thing
/// once:
/// - a step that is too long for the waves that bodies meet (wave_warning.h), or a body that has
///   turned far from its mean pose (radiation_warning.h), whichever comes first;
/// - each body with radiation whose forward speed is above assembly::kLargestFroudeNumber, but for
///   slender hulls in simulated water without other waves;
/// - each floating hull in the surface without a resistance of its own or simulated water above
///   kWaveMakingFroudeNumber that machines, lines, joints or loads drive;
/// - each of those above kPlaningFroudeNumber, with a resistance or without.
/// The forward speed is the mean horizontal velocity in the water, over about two periods of the
/// longest waves and of waves as long as the body, so that no swell counts as speed.
class MotionWatch {
 public:
  /// @param built   It must outlive this.
  explicit MotionWatch(const assembly::BuiltScene& built);

  /// Returns the warnings that the states after a step give for the first time.
  std::vector<std::string> after_step(double time, const std::vector<hydro::BodyState>& states);

  /// Everything that changes, for a checkpoint. Numbers are read back to the same.
  nlohmann::ordered_json state() const;
  /// @throws nlohmann::json::exception unless `state` is that of state() for the same scene.
  void restore(const nlohmann::ordered_json& state);

 private:
  struct Speed {
    double length = 0;                               ///< Largest horizontal extent [m].
    double memory = 0;                               ///< Time of the mean [s].
    bool makes_waves = false;                        ///< Its radiation is watched.
    bool slender = false;                            ///< Thin-ship theory knows it.
    double planing = 0;                              ///< Speed of kPlaningFroudeNumber [m/s].
    bool lacks_resistance = false;                   ///< Its resistance is watched.
    bool may_plane = false;                          ///< So is planing.
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();  ///< [m/s]
  };
  void add_speed_warnings(std::size_t body, double time, const hydro::BodyState& state,
                          std::vector<std::string>& warnings);

  const assembly::BuiltScene& built_;
  std::vector<Speed> speeds_;  ///< Per body; empty without water or gravity.
  bool waves_told_ = false;
};

}  // namespace app
