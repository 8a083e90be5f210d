#include "app/pictures/interiors.h"

#include <algorithm>

namespace app {

render::Hollows hollows_of(const engine::BodySpec& body) {
  switch (body.interior) {
    case engine::Interior::flooding:
      return render::Hollows::flooding;
    case engine::Interior::dry:
      return render::Hollows::dry;
    case engine::Interior::wet:
      break;
  }
  return render::Hollows::none;
}

render::Interiors drawn_interiors(const std::vector<engine::InteriorState>& interiors) {
  render::Interiors drawn(interiors.size());
  for (std::size_t i = 0; i < interiors.size(); ++i)
    for (const engine::PocketState& pocket : interiors[i].pockets)
      if (pocket.flooded || pocket.volume > 0)
        drawn[i].push_back(
            {.at_W = pocket.centroid_W, .level = pocket.level, .flooded = pocket.flooded});
  return drawn;
}

render::Interiors drawn_interiors(const InteriorLog& log, const engine::SimulationSpec& spec,
                                  double time) {
  render::Interiors drawn(spec.bodies.size());
  for (std::size_t i = 0; i < spec.bodies.size(); ++i) {
    const auto rows = log.find(spec.bodies[i].name);
    if (rows == log.end()) continue;
    const auto at =
        std::lower_bound(rows->second.begin(), rows->second.end(), time,
                         [](const InteriorRows& row, double t) { return row.time < t; });
    if (at == rows->second.end() || at->time != time) continue;
    for (const PocketRow& pocket : at->pockets)
      if (pocket.flooded || pocket.volume > 0)
        drawn[i].push_back(
            {.at_W = pocket.centroid, .level = pocket.level, .flooded = pocket.flooded});
  }
  return drawn;
}

}  // namespace app
