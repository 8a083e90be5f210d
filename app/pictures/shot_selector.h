#pragma once

#include <utility>
#include <vector>

#include "app/base/schedule.h"
#include "app/pictures/shot_spool.h"
#include "hydro/spatial.h"

namespace app {

/// Chooses from the states of a run those that are drawn: for frames the first state at or after
/// each time that is due, for a video the states at its times, found between those of the run.
class ShotSelector {
 public:
  /// @param every   Between frames [s].
  /// @param end     No picture is of it or later [s].
  /// @param fps     Pictures of the video in a second; 0: there is none.
  ShotSelector(double every, double end, int fps) : frames_(every, end), end_(end), fps_(fps) {}

  /// Keeps the shots in that store from the start.
  void keep_in(ShotSpool shots) { shots_ = std::move(shots); }
  /// Goes on after a run's state at `time`, with the shots that it had kept until then.
  void resume(double time, const std::vector<hydro::BodyState>& states, ShotSpool shots);
  /// As ShotSpool::save.
  void save() { shots_.save(); }

  /// To be told of all states in the order of time. @throws OutputError
  void add(double time, const std::vector<hydro::BodyState>& states);

  /// In the order of time.
  const ShotSpool& shots() const { return shots_; }

 private:
  /// The rounding of step·count, for times of the video [s].
  double slack() const { return 1e-6 / fps_; }
  bool add_video_shots(double time, const std::vector<hydro::BodyState>& states);
  void add_between(double due, double time, const std::vector<hydro::BodyState>& states);

  FrameSchedule frames_;
  double end_;
  int fps_;
  long next_ = 0;  ///< Number of the video's next picture.
  double last_time_ = 0;
  std::vector<hydro::BodyState> last_;  ///< For a video only.
  ShotSpool shots_;
};

}  // namespace app
