#include "engine/constraints/restitution.h"

#include <algorithm>
#include <cmath>

#include "engine/base/constants.h"

namespace engine {
namespace {

double product(const std::vector<Vector6d>& a, const std::vector<Vector6d>& b) {
  double total = 0;
  for (std::size_t i = 0; i < a.size(); ++i) total += a[i].dot(b[i]);
  return total;
}

/// a + s b
std::vector<Vector6d> added(const std::vector<Vector6d>& a, const std::vector<Vector6d>& b,
                            double s) {
  std::vector<Vector6d> result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + s * b[i]);
  return result;
}

}  // namespace

bool has_restitution(const std::vector<Contact>& contacts) {
  return std::any_of(contacts.begin(), contacts.end(), [](const Contact& contact) {
    return contact.rebounds && contact.row.speed > 0;
  });
}

std::vector<Contact> without_restitution(std::vector<Contact> contacts) {
  for (Contact& contact : contacts)
    if (contact.rebounds) contact.row.speed = 0;
  return contacts;
}

double work(const ConstraintResult& result, const std::vector<Vector6d>& before, double h) {
  return h * product(result.reactions, added(before, result.changes, 0.5));
}

bool adds_energy(const ConstraintResult& result, const std::vector<Vector6d>& before, double h,
                 double allowed_gain) {
  const double exchanged =
      h * (std::abs(product(result.reactions, before)) + product(result.reactions, result.changes));
  const double gain = work(result, before, h) - result.row_work;
  // The gain of a result that is not solved may be infinite or NaN.
  return !std::isfinite(gain) || gain > allowed_gain + kImpactGain * exchanged;
}

ConstraintResult limit_energy(const ConstraintResult& plain, const ConstraintResult& restored,
                              const std::vector<Vector6d>& before, double h, double allowed_gain) {
  const std::vector<Vector6d> change = added(restored.changes, plain.changes, -1);
  const std::vector<Vector6d> reaction = added(restored.reactions, plain.reactions, -1);
  // W(s) = W(0) + b s + c s², where c = ½ h² Σ ΔR·S⁻¹ ΔR.
  const double least = work(plain, before, h);
  const double c = h / 2 * product(reaction, change);
  const double b = work(restored, before, h) - least - c;
  const double slack = std::max(0.0, -least) + allowed_gain;
  if (!(c > 0) || !std::isfinite(b) || !std::isfinite(c)) return plain;
  // The root of s² + 2 β s = ρ: no square of b or c, which may overflow, and no cancellation.
  const double beta = b / (2 * c), rho = slack / c;
  const double root = std::sqrt(beta * beta + rho);
  const double s = std::clamp(beta > 0 ? rho / (beta + root) : root - beta, 0.0, 1.0);
  ConstraintResult result{.changes = added(plain.changes, change, s),
                          .reactions = added(plain.reactions, reaction, s),
                          .row_forces = plain.row_forces,
                          .row_work = plain.row_work + s * (restored.row_work - plain.row_work),
                          .joints = plain.joints,
                          .solved = plain.solved && restored.solved};
  for (std::size_t i = 0; i < result.row_forces.size(); ++i)
    result.row_forces[i] += s * (restored.row_forces[i] - plain.row_forces[i]);
  for (std::size_t i = 0; i < result.joints.size(); ++i) {
    result.joints[i].force_W += s * (restored.joints[i].force_W - plain.joints[i].force_W);
    result.joints[i].moment_W += s * (restored.joints[i].moment_W - plain.joints[i].moment_W);
  }
  return result;
}

}  // namespace engine
