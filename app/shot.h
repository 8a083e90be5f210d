#pragma once

#include <vector>

#include "hydro/spatial.h"

namespace app {

/// States of all bodies at a time that is to be drawn.
struct Shot {
  double time = 0;  ///< [s]
  std::vector<hydro::BodyState> states;
};

}  // namespace app
