#include "engine/force_row.h"

#include <algorithm>
#include <cmath>

#include "engine/constants.h"

namespace engine {

RowTerms row_terms(const RowLaw& law, double h) {
  const double k = law.stiffness, c = law.damping;
  const double phase = std::max(h * std::sqrt(k * law.mobility), h * c * law.mobility / 2);
  const double damped =
      std::clamp((phase - kResolvedLine) / (kUnresolvedLine - kResolvedLine), 0.0, 1.0);
  const double a = 0.25 + 0.75 * damped, b = 0.25 * (1 - damped), w = 0.5 + 0.5 * damped;
  const double g = h * k * a + c * w;
  const double before = law.rest_rate - law.rate;  // d⁻
  return {.target = law.rest_rate + (k * law.missing + (c * (1 - w) - h * k * b) * before) / g,
          .compliance = 1 / g};
}

RowTerms rigid_terms(double rate, double mobility, double h) {
  return {.target = rate, .compliance = kRowCompliance * h * mobility};
}

}  // namespace engine
