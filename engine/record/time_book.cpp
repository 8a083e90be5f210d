#include "engine/record/time_book.h"

#include <algorithm>

namespace engine {

void TimeBook::add(const std::vector<MovingBody>& bodies, int threads, double wall,
                   double collision) {
  BodySeconds sums;
  for (const MovingBody& moving : bodies) {
    sums.loads += moving.cache.seconds;
    sums.sea += moving.cache.sea_seconds;
    sums.constraints += moving.cache.constraint_seconds;
  }
  // Loads of several bodies are found at once: their share of the step is an average.
  const double at_once =
      std::clamp(static_cast<double>(bodies.size()), 1.0, std::max(1.0, 1.0 * threads));
  double rest = wall - collision;
  const auto take = [&](double now, double before) {
    const double share = std::min(rest, (now - before) / at_once);
    rest -= share;
    return share;
  };
  timings_.collision += collision;
  timings_.hydro += take(sums.loads, so_far_.loads);
  timings_.engine += rest;
  timings_.sea += take(sums.sea, so_far_.sea);
  timings_.constraints += take(sums.constraints, so_far_.constraints);
  so_far_ = sums;
}

}  // namespace engine
