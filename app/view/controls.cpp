#include "app/view/controls.h"

#include <utility>

namespace app {
namespace {

/// Overload set of functions, for std::visit.
template <typename... Functions>
struct Either : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Either(Functions...) -> Either<Functions...>;

}  // namespace

Controls::Controls(const render::Camera& home, double step, Pick pick)
    : home_(orbit_of(home)), orbit_(home_), playback_(step), pick_(std::move(pick)) {}

void Controls::take(const Event& event) {
  std::visit(Either{[this](const KeyPress& e) { press(e.key); },
                    [this](const ButtonPress& e) { press(e); },
                    [this](const ButtonRelease&) { release(); },
                    [this](const MouseMove& e) { move(e.to); },
                    [this](const Wheel& e) { orbit_ = zoomed(orbit_, e.notches); }},
             event);
}

bool Controls::take_restart() { return std::exchange(restart_, false); }

std::optional<Controls::Held> Controls::held() const {
  if (!grip_) return std::nullopt;
  return Held{grip_->body, pull_towards(*grip_, ray_through(camera(), mouse_))};
}

void Controls::press(Key key) {
  switch (key) {
    case Key::pause:
      return playback_.pause_or_go_on();
    case Key::step:
      return playback_.step_once();
    case Key::faster:
      return playback_.faster();
    case Key::slower:
      return playback_.slower();
    case Key::home:
      orbit_ = home_;
      return;
    case Key::help:
      help_ = !help_;
      return;
    case Key::quit:
      quit_ = true;
      return;
    case Key::restart:
      restart_ = true;
      release();
      return playback_.restart();
  }
}

void Controls::press(const ButtonPress& press) {
  release();
  mouse_ = press.at;
  const bool left = press.button == Button::left;
  if (press.button == Button::middle || (left && press.control)) {
    grip_ = pick_(ray_through(camera(), mouse_));
    if (grip_) gesture_ = Gesture::pull;
  } else {
    gesture_ = left && !press.shift ? Gesture::turn : Gesture::pan;
  }
}

void Controls::move(const Eigen::Vector2d& to) {
  const Eigen::Vector2d way = to - std::exchange(mouse_, to);
  if (gesture_ == Gesture::turn) orbit_ = turned(orbit_, way);
  if (gesture_ == Gesture::pan) orbit_ = panned(orbit_, way);
}

void Controls::release() {
  gesture_ = Gesture::none;
  grip_.reset();
}

}  // namespace app
