#pragma once

#include <string>

#include "app/render/image.h"
#include "app/view/playback_clock.h"

namespace app {

/// Returns the text about the pace of time: `speed 1/4, reached 0.25`, or that it is paused.
std::string playback_text(const PlaybackClock& playback);

/// Writes one line of help, or all lines if `whole`, at the upper right.
void add_help(render::Image& image, bool whole);

}  // namespace app
