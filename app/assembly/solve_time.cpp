#include "app/assembly/solve_time.h"

#include <algorithm>
#include <cmath>

namespace assembly {
namespace {

// Processor times of icospheres on one of two cores at 2.5 GHz.
constexpr double kTriangleSeconds = 1.3e-3;  ///< Time per triangle of kCountedTriangles [s].
constexpr double kCountedTriangles = 2e4;
constexpr double kStoredPanels = 5000;    ///< Up to so many panels all interactions are stored.
constexpr double kStoredGrowth = 1.43;    ///< Exponent of the number of panels there.
constexpr double kRadiationSeconds = 12;  ///< Time for sixteen frequencies [s].

}  // namespace

double added_mass_seconds(double triangles, int threads) {
  const double n = std::max(triangles, kStoredPanels);
  const double compressed = kTriangleSeconds * n * std::log(n) / std::log(kCountedTriangles);
  return compressed * std::pow(triangles / n, kStoredGrowth) / threads;
}

double radiation_seconds(double triangles, int threads) {
  return kRadiationSeconds / threads + added_mass_seconds(triangles, threads);
}

}  // namespace assembly
