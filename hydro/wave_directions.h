#pragma once

#include <random>
#include <vector>

/// @file
/// Random numbers and directions of the waves of an irregular sea.

namespace hydro {

/// Uniform random numbers in (0, 1), the same with every standard library.
class UniformNumbers {
 public:
  explicit UniformNumbers(int seed) : engine_(static_cast<std::uint32_t>(seed)) {}
  double operator()() { return (static_cast<double>(engine_()) + 0.5) / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

/// Directions of `count` waves relative to the heading [rad], spread as cos^2s(θ/2): one from each
/// of `count` equally likely sectors, in random order.
/// @param spreading   s; 0 stands for long-crested waves, whose directions are all 0.
std::vector<double> spread_directions(double spreading, int count, UniformNumbers& uniform);

}  // namespace hydro
