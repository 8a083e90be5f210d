#include "app/logs/trajectory_match.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/scene/diagnostics.h"

namespace app {

void check_same_bodies(const Trajectory& trajectory, const engine::SimulationSpec& spec,
                       const std::filesystem::path& file) {
  std::vector<scene::Fault> faults;
  const auto add = [&](const std::string& message) {
    faults.push_back({.place = {.file = file}, .message = message});
  };
  for (const engine::BodySpec& body : spec.bodies)
    if (!trajectory.tracks.contains(body.name))
      add(fmt::format("has no body {}, which the scene has", body.name));
  for (const std::string& name : trajectory.names)
    if (std::none_of(spec.bodies.begin(), spec.bodies.end(),
                     [&](const engine::BodySpec& body) { return body.name == name; }))
      add(fmt::format("has a body {}, which the scene does not have", name));
  if (!faults.empty()) throw scene::InputError(faults);
}

std::size_t common_rows(const Trajectory& trajectory, const std::filesystem::path& file) {
  const auto& [first, times] = *trajectory.tracks.begin();
  std::size_t rows = times.times.size();
  for (const auto& [name, track] : trajectory.tracks) rows = std::min(rows, track.times.size());
  for (const auto& [name, track] : trajectory.tracks)
    for (std::size_t i = 0; i < rows; ++i)
      if (track.times[i] != times.times[i])
        throw scene::InputError(
            file, fmt::format("row {} of body {} has the time {} s and that of body {} {} s; "
                              "expected rows of all bodies at the same times",
                              i + 1, first, times.times[i], name, track.times[i]));
  return rows;
}

std::vector<hydro::BodyState> states_at(const Trajectory& trajectory,
                                        const engine::SimulationSpec& spec, std::size_t row) {
  std::vector<hydro::BodyState> states;
  for (const engine::BodySpec& body : spec.bodies)
    states.push_back(trajectory.tracks.at(body.name).states.at(row));
  return states;
}

}  // namespace app
