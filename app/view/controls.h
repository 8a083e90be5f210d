#pragma once

#include <functional>
#include <optional>
#include <variant>

#include "app/view/orbit.h"
#include "app/view/picking.h"
#include "app/view/playback_clock.h"

/// @file
/// Response to keys and mouse, independent of any window.

namespace app {

/// Command of a key.
enum class Key { pause, step, restart, faster, slower, home, help, quit };

enum class Button { left, middle, right };

struct KeyPress {
  Key key;
};
/// Positions are points of the window (orbit.h).
struct ButtonPress {
  Button button = Button::left;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  bool shift = false;
  bool control = false;
};
struct ButtonRelease {};
struct MouseMove {
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
};
struct Wheel {
  double notches = 0;  ///< Positive away from the hand.
};
using Event = std::variant<KeyPress, ButtonPress, ButtonRelease, MouseMove, Wheel>;

/// Finds the body that a ray of the mouse meets.
using Pick = std::function<std::optional<Hit>(const Ray&)>;

/// State set by keys and mouse: camera, pace of time and body held by the mouse.
class Controls {
 public:
  /// @param step   Time step of the simulation [s].
  Controls(const render::Camera& home, double step, Pick pick);

  void take(const Event& event);

  render::Camera camera() const { return camera_of(orbit_); }
  PlaybackClock& playback() { return playback_; }
  const PlaybackClock& playback() const { return playback_; }
  bool help() const { return help_; }
  bool quit() const { return quit_; }
  /// Returns true once after each command to restart the simulation.
  bool take_restart();

  /// Body that is held, and the force that pulls it.
  struct Held {
    engine::BodyId body;
    engine::Pull pull;
  };
  std::optional<Held> held() const;

 private:
  enum class Gesture { none, turn, pan, pull };

  void press(Key key);
  void press(const ButtonPress& press);
  void move(const Eigen::Vector2d& to);
  void release();

  Orbit home_, orbit_;
  PlaybackClock playback_;
  Pick pick_;
  Gesture gesture_ = Gesture::none;
  Eigen::Vector2d mouse_ = Eigen::Vector2d::Zero();
  std::optional<Hit> grip_;  ///< Point held while the gesture is `pull`.
  bool help_ = false, quit_ = false, restart_ = false;
};

}  // namespace app
