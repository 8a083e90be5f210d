#include "engine/force_row.h"

#include <algorithm>
#include <cmath>

#include "engine/constants.h"

namespace engine {

namespace {

/// 0 where a substep resolves an oscillation, 1 where it does not.
double unresolved(double phase) {
  return std::clamp((phase - kResolvedLine) / (kUnresolvedLine - kResolvedLine), 0.0, 1.0);
}

}  // namespace

double spring_weight(double phase) { return 0.25 + 0.75 * unresolved(phase); }

RowTerms row_terms(const RowLaw& law, double h) {
  const double k = law.stiffness, c = law.damping;
  const double phase = std::max(h * std::sqrt(k * law.mobility), h * c * law.mobility / 2);
  const double damped = unresolved(phase);
  const double a = spring_weight(phase), b = 0.25 * (1 - damped), w = 0.5 + 0.5 * damped;
  const double g = h * k * a + c * w;
  const double before = law.rest_rate - law.rate;  // d⁻
  return {.target = law.rest_rate + (k * law.missing + (c * (1 - w) - h * k * b) * before) / g,
          .compliance = 1 / g};
}

RowTerms rigid_terms(double rate, double mobility, double h) {
  return {.target = rate, .compliance = kRowCompliance * h * mobility};
}

}  // namespace engine
