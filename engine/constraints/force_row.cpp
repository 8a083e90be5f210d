#include "engine/constraints/force_row.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"

namespace engine {

double unresolved(double phase) {
  return std::clamp((phase - kResolvedLine) / (kUnresolvedLine - kResolvedLine), 0.0, 1.0);
}

SpringWeights spring_weights(double damped, double h, double step) {
  return {.after = 0.25 * (1 - damped) + damped * step / h, .before = 0.25 * (1 - damped)};
}

RowTerms row_terms(const RowLaw& law, double h, double step) {
  const double k = law.stiffness, c = law.damping;
  const double damped =
      unresolved(std::max(step * std::sqrt(k * law.mobility), step * c * law.mobility / 2));
  const bool slack = law.one_sided && law.missing < 0;
  const auto [a, b] = spring_weights(damped, h, slack ? h : step);
  const double w = 0.5 + 0.5 * damped;
  const double g = h * k * a + c * w;
  const double before = law.rest_rate - law.rate;  // d⁻
  return {.target = law.rest_rate + (k * law.missing + (c * (1 - w) - h * k * b) * before) / g,
          .compliance = 1 / g};
}

RowTerms rigid_terms(double rate, double mobility, double h) {
  return {.target = rate, .compliance = kRowCompliance * h * mobility};
}

}  // namespace engine
