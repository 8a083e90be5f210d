#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/base/schedule.h"
#include "app/pictures/shot_spool.h"
#include "hydro/spatial.h"

namespace app {

/// Selects the states of a run that are drawn: for frames the first state at or after each due
/// time and the final state, for a video states interpolated at its times.
class ShotSelector {
 public:
  /// @param every   Time between frames [s].
  /// @param end     Time of the final state, before which a video ends [s].
  /// @param fps     Pictures of the video per second; 0: no video.
  ShotSelector(double every, double end, int fps) : frames_(every, end), end_(end), fps_(fps) {}

  /// Stores the shots in `shots`, to be called before the first state.
  void keep_in(ShotSpool shots) { shots_ = std::move(shots); }
  /// Draws the waves that bodies make and do not feel, from the first state on.
  void show_waves(std::optional<hydro::SimulatedWater> waves) { waves_ = std::move(waves); }
  /// Draws the water that bodies feel, that of the run, which must outlive this.
  void show_felt_waves(const hydro::SimulatedWater* felt) { felt_ = felt; }
  /// The state of the waves that nobody feels after the last state; empty without them.
  std::string state_of_waves() const { return waves_ ? waves_->state() : ""; }
  void restore_waves(const std::string& state) {
    if (waves_) waves_->restore(state);
  }
  /// Continues after a run's state at `time` with the shots stored until then.
  void resume(double time, const std::vector<hydro::BodyState>& states, DrawnRig rig,
              ShotSpool shots);
  /// Flushes the shots to the disk. @throws OutputError
  void save() { shots_.save(); }

  /// Finds the water in the bodies' hollows, if it is drawn.
  using FindInteriors = std::function<render::Interiors()>;
  /// Finds what lines and machines do, if there are any.
  using FindRig = std::function<DrawnRig()>;

  /// Takes the run's next state; times must increase. Pictures between two states have the water of
  /// the later one. @throws OutputError
  void add(double time, const std::vector<hydro::BodyState>& states,
           const FindInteriors& interiors = {}, const FindRig& rig = {});

  /// Returns the shots in the order of time.
  const ShotSpool& shots() const { return shots_; }

 private:
  /// Tolerance for the rounding of step·count at times of the video [s].
  double slack() const { return 1e-6 / fps_; }
  bool add_video_shots(double time, const std::vector<hydro::BodyState>& states,
                       const DrawnRig& rig, const FindInteriors& interiors);
  std::optional<hydro::SurfacePatch> patch(double time) const;
  Shot between_states(double due, double time, const std::vector<hydro::BodyState>& states,
                      const DrawnRig& rig) const;

  FrameSchedule frames_;
  double end_;
  int fps_;
  long next_ = 0;  ///< Number of the video's next picture.
  double last_time_ = 0;
  std::vector<hydro::BodyState> last_;  ///< States at `last_time_`, for a video only.
  DrawnRig last_rig_;                   ///< The same of lines and machines.
  ShotSpool shots_;
  std::optional<hydro::SimulatedWater> waves_;
  const hydro::SimulatedWater* felt_ = nullptr;
};

}  // namespace app
