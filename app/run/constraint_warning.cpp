#include "app/run/constraint_warning.h"

#include <fmt/format.h>

#include <algorithm>

namespace app {

std::optional<std::string> constraint_warning(const engine::SimulationSpec& spec,
                                              const std::vector<engine::Counts>& counts) {
  const auto worst = std::ranges::max_element(counts, {}, &engine::Counts::unconverged);
  if (worst == counts.end() || worst->unconverged == 0) return std::nullopt;
  const auto missed = [](const engine::Counts& c) { return c.unconverged > 0; };
  const auto others = std::ranges::count_if(counts, missed) - 1;
  const std::string more = others == 0 ? ""
                                       : fmt::format(", and on {} other bod{} in some", others,
                                                     others == 1 ? "y" : "ies");
  return fmt::format(
      "the forces of contacts, joints or lines on body '{}' missed their tolerance in {} of its {} "
      "pieces of motion{}: they are approximate there, and a shorter step may help",
      spec.bodies[static_cast<std::size_t>(worst - counts.begin())].name, worst->unconverged,
      worst->substeps, more);
}

}  // namespace app
