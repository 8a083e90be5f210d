#include "app/pictures/shot_selector.h"

#include <utility>

#include "app/logs/interpolation.h"

namespace app {

void ShotSelector::add(double time, const std::vector<hydro::BodyState>& states,
                       const FindInteriors& interiors, const FindRig& find_rig) {
  const bool frame = frames_.due(time);
  DrawnRig rig;
  if (find_rig && (frame || fps_ > 0)) rig = find_rig();
  const bool video = fps_ > 0 && add_video_shots(time, states, rig, interiors);
  if (waves_) waves_->follow(time, states);
  if (frame || video)
    shots_.add({time, states, frame, video, interiors ? interiors() : render::Interiors(), rig,
                patch(time)});
  if (fps_ == 0) return;
  last_time_ = time;
  last_ = states;
  last_rig_ = std::move(rig);
}

void ShotSelector::resume(double time, const std::vector<hydro::BodyState>& states, DrawnRig rig,
                          ShotSpool shots) {
  frames_.due(time);
  if (fps_ > 0) {
    while (static_cast<double>(next_) / fps_ <= time + slack()) ++next_;
    last_time_ = time;
    last_ = states;
    last_rig_ = std::move(rig);
  }
  shots_ = std::move(shots);
}

/// Adds the shots of the video that are due before `time` [s]. @return true if one is due at
/// `time`.
bool ShotSelector::add_video_shots(double time, const std::vector<hydro::BodyState>& states,
                                   const DrawnRig& rig, const FindInteriors& interiors) {
  for (;; ++next_) {
    const double due = static_cast<double>(next_) / fps_;
    if (due > time + slack() || !is_frame_time(due, end_)) return false;
    if (due >= time - slack()) {
      ++next_;
      return true;
    }
    if (last_.empty() && !states.empty()) continue;
    Shot shot = between_states(due, time, states, rig);
    if (interiors) shot.interiors = interiors();
    shots_.add(shot);
  }
}

/// The bodies' waves at a time about the last state.
std::optional<hydro::SurfacePatch> ShotSelector::patch(double time) const {
  if (felt_) return felt_->patch(time);
  return waves_ ? waves_->patch(time) : std::nullopt;
}

Shot ShotSelector::between_states(double due, double time,
                                  const std::vector<hydro::BodyState>& states,
                                  const DrawnRig& rig) const {
  Shot shot{.time = due, .states = {}, .frame = false, .video = true};
  const double interval = time - last_time_;
  const double part = (due - last_time_) / interval;
  for (std::size_t i = 0; i < states.size(); ++i)
    shot.states.push_back(between(last_[i], states[i], interval, part));
  shot.rig = between(last_rig_, rig, part);
  shot.water = patch(due);
  return shot;
}

}  // namespace app
