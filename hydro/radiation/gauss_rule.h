#pragma once

#include <array>

/// @file
/// Gauss' rule of eight points on [−1, 1], symmetric about 0.

namespace hydro {

inline constexpr std::array<double, 4> kGaussAt = {0.1834346424956498, 0.5255324099163290,
                                                   0.7966664774136267, 0.9602898564975363};
inline constexpr std::array<double, 4> kGaussWeight = {0.3626837833783620, 0.3137066458778873,
                                                       0.2223810344533745, 0.1012285362903763};

}  // namespace hydro
