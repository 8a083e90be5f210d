#include "engine/hollows/streams.h"

#include <algorithm>
#include <cmath>

namespace engine {

double weir_flow(double upstream, double downstream, double gravity) {
  if (!(upstream > 0)) return 0;
  const double free = std::pow(2.0 / 3, 1.5) * std::sqrt(gravity) * std::pow(upstream, 1.5);
  if (!(downstream > 0)) return free;
  if (downstream >= upstream) return 0;
  return free * std::pow(1 - std::pow(downstream / upstream, 1.5), 0.385);
}

double limited_flow(double volume, double equalising) {
  if (!(volume < 2 * equalising)) return equalising;
  return volume - volume * volume / (4 * equalising);
}

double pump_flow(double rate, double lift, double head) {
  return rate * std::sqrt(std::clamp(1 - lift / head, 0.0, 1.0));
}

bool pumping(const std::vector<double>& rates) {
  return std::ranges::any_of(rates, [](double rate) { return rate > 0; });
}

}  // namespace engine
