#pragma once

#include <string>

#include "app/render/image.h"
#include "app/view/pace.h"

namespace app {

/// How fast time goes, as the window tells it: `speed 1/4, reached 0.25`, or that it is paused.
std::string pace_text(const Pace& pace);

/// Puts that text below the time that `render::add_overlay` writes, and a line of help, or all of
/// it, lower left. Text is of the overlay's size; nothing is put on what is too small for that.
void add_status(render::Image& image, const Pace& pace, bool help);

}  // namespace app
