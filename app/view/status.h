#pragma once

#include <string>

#include "app/render/image.h"
#include "app/view/playback_clock.h"

namespace app {

/// How fast time goes, as the window tells it: `speed 1/4, reached 0.25`, or that it is paused.
std::string playback_text(const PlaybackClock& playback);

/// Puts a line of help, or the whole of it, upper right.
void add_help(render::Image& image, bool whole);

}  // namespace app
