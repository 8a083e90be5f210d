#include "app/compare/learned_tolerances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/scene/diagnostics.h"

namespace app {
namespace {

constexpr double kOwnBelow = 0.1;  ///< Peak over all names' below which a name has its own [-].

/// Rounds up to two digits.
double rounded_up(double number) {
  if (number == 0) return 0;
  const double unit = std::pow(10, std::floor(std::log10(number)) - 1);
  // Read back from its digits, so that 0.30000000000000004 becomes 0.3.
  return std::stod(fmt::format("{:.2g}", std::ceil(number / unit * (1 - 1e-12)) * unit));
}

Tolerance tolerance_of(const Difference& d, double margin) {
  const bool of_table = d.quantity.find('.') != std::string::npos;
  const double least = Tolerances::kDefault * (1 + (of_table ? d.size : 0));
  if (margin * d.largest <= least) return {.peak = rounded_up(least)};
  return {.peak = rounded_up(margin * d.largest),
          .rms = rounded_up(std::max(margin * d.rms, least))};
}

/// Returns the tolerance that holds for both.
Tolerance wider(const Tolerance& a, const Tolerance& b) {
  // Without a root mean square, the difference is at round-off: the peak bounds it, too.
  const auto rms = [](const Tolerance& t) { return t.rms == Tolerance::kNone ? t.peak : t.rms; };
  const double peak = std::max(a.peak, b.peak);
  if (a.rms == Tolerance::kNone && b.rms == Tolerance::kNone) return {.peak = peak};
  return {.peak = peak, .rms = std::max(rms(a), rms(b))};
}

void widen(Tolerances::Quantities& quantities, const std::string& quantity,
           const Tolerance& tolerance) {
  const auto [found, is_new] = quantities.try_emplace(quantity, tolerance);
  if (!is_new) found->second = wider(found->second, tolerance);
}

/// Adds the differences of a body or a name. @param run   For faults.
void learn(const BodyComparison& body, double margin, const std::filesystem::path& run,
           Tolerances& learned) {
  if (body.in != In::both || body.only_a + body.only_b > 0 || body.times.empty())
    throw scene::InputError(
        run, fmt::format("has not the same times of {} as the first run, so no tolerance can be "
                         "learned; expected runs of one scene",
                         body.name));
  for (const Difference& d : body.differences) {
    if (!std::isfinite(d.largest))
      throw scene::InputError(
          run, fmt::format("{} of {}: at {:g} s only one of the runs has numbers, so no tolerance "
                           "can be learned",
                           d.quantity, body.name, d.when_largest));
    const Tolerance tolerance = tolerance_of(d, margin);
    widen(learned.all, d.quantity, tolerance);
    widen(learned.bodies[body.name], d.quantity, tolerance);
  }
}

/// Keeps, of the names' own tolerances, those far below that of all.
void keep_far_below(Tolerances& learned) {
  for (auto& [name, quantities] : learned.bodies)
    std::erase_if(quantities, [&](const auto& entry) {
      return entry.second.peak > kOwnBelow * learned.all.at(entry.first).peak;
    });
  std::erase_if(learned.bodies, [](const auto& entry) { return entry.second.empty(); });
}

}  // namespace

Tolerances learned_tolerances(const std::vector<Comparison>& comparisons, double margin,
                              const std::vector<std::filesystem::path>& runs) {
  Tolerances learned;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    for (const BodyComparison& body : comparisons[i].bodies) learn(body, margin, runs[i], learned);
    for (const TableComparison& table : comparisons[i].tables) {
      if (table.in != In::both)
        throw scene::InputError(runs[i],
                                fmt::format("only one of this and the first run has {}, so no "
                                            "tolerance can be learned",
                                            table.name));
      for (const BodyComparison& name : table.names) learn(name, margin, runs[i], learned);
    }
  }
  keep_far_below(learned);
  return learned;
}

}  // namespace app
