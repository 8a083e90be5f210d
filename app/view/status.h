#pragma once

#include <string>

#include "app/render/image.h"
#include "app/view/pace.h"

namespace app {

/// How fast time goes, as the window tells it: `speed 1/4, reached 0.25`, or that it is paused.
std::string pace_text(const Pace& pace);

/// Puts a line of help, or the whole of it, upper right.
void add_help(render::Image& image, bool whole);

}  // namespace app
