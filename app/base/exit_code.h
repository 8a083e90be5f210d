#pragma once

namespace app {

/// Exit codes of the program; scripts rely on them.
enum ExitCode {
  kDone = 0,
  kDiffers = 1,       ///< `compare` found a difference beyond tolerance.
  kWrongInput = 2,    ///< The usage or the input is wrong.
  kCannotGoOn = 3,    ///< The simulation met a state that is not finite.
  kOwnFault = 70,     ///< The program itself is at fault.
  kInterrupted = 130  ///< Ctrl-C stopped the program; what was done is written.
};

}  // namespace app
