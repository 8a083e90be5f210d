#include "hydro/added_mass/bem/adapt.h"

#include <algorithm>
#include <functional>

namespace hydro::bem {
namespace {

/// Share of the total gain in the edges that are halved. A smaller value needs more solves; a
/// larger one distributes the panels less well.
constexpr double kHalvedPart = 0.75;

/// Relative difference of gains below which edges count as equal.
constexpr double kSame = 1e-6;

}  // namespace

std::vector<bool> edges_to_halve(const Surface& surface, const Potential& psi,
                                 const Matrix6d& weight) {
  std::vector<double> counts(surface.edges.faces.size());
  for (std::size_t f = 0; f < surface.face_count(); ++f) {
    const std::array<int, 6> rows = functions_of(surface, f);
    for (std::size_t e = 0; e < 3; ++e) {
      const Vector6d bubble = psi.row(rows[3 + e]).transpose();
      counts[static_cast<std::size_t>(surface.edges.of_face[f][e])] =
          surface.elements[f].lengths[e] * bubble.dot(weight * bubble);
    }
  }
  std::vector<double> sorted = counts;
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double whole = 0, held = 0, least = 0;
  for (const double count : sorted) whole += count;
  for (std::size_t i = 0; i < sorted.size() && held < kHalvedPart * whole; ++i) {
    held += sorted[i];
    least = sorted[i];
  }
  std::vector<bool> marked(counts.size());
  for (std::size_t i = 0; i < counts.size(); ++i) marked[i] = counts[i] >= least * (1 - kSame);
  return marked;
}

}  // namespace hydro::bem
