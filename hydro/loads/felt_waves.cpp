#include "hydro/loads/felt_waves.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "hydro/airy_waves.h"

namespace hydro {
namespace {

/// Error of the head, over the part of volume over area, that leaves the force within that part of
/// the buoyancy [-]: measured over random seas and poses of boxes and ellipsoids.
constexpr double kPartOfBuoyancy = 8;

/// With fewer waves none is left out: to look for them takes longer than they do.
constexpr std::size_t kFewestSorted = 12;

/// A wave's number, and the mean square of the head that it stands for [m^2].
struct Felt {
  double wave_number, square;
};

}  // namespace

double allowed_head_error(const HeadError& error, double deviation) {
  return std::min(kPartOfBuoyancy * error.tolerance * error.volume_over_area,
                  kPartOfWaves * deviation);
}

std::optional<Sea> without_weak_waves(const Sea& sea, const HeadError& error) {
  if (!has_airy_waves(sea)) return std::nullopt;
  const auto& all = std::get<WaveSurface>(sea.surface).components;
  if (all.size() < kFewestSorted) return std::nullopt;
  double variance = 0;
  std::vector<Felt> felt;
  felt.reserve(all.size());
  for (const WaveComponent& w : all) {
    const double number = wave_number(w), turn = number * error.size();
    const double head = w.amplitude / (1 + turn * std::sqrt(turn));
    variance += w.amplitude * w.amplitude / 2;
    felt.push_back({number, head * head / 2});
  }
  std::sort(felt.begin(), felt.end(),
            [](const Felt& a, const Felt& b) { return a.wave_number > b.wave_number; });
  const double allowed = allowed_head_error(error, std::sqrt(variance)) / 5;
  double left_out = 0, shortest = HUGE_VAL;
  for (const Felt& w : felt) {
    left_out += w.square;
    if (left_out > allowed * allowed) break;
    shortest = w.wave_number;
  }
  if (shortest == HUGE_VAL) return std::nullopt;
  Sea rest = sea;
  std::erase_if(std::get<WaveSurface>(rest.surface).components,
                [&](const WaveComponent& w) { return wave_number(w) >= shortest; });
  return rest;
}

}  // namespace hydro
