#include "tests/stress/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "tests/stress/rigging.h"

namespace stress {
namespace {

constexpr std::size_t kInsideRuns = 1200;  ///< Of combinations inside the envelope, nearly all.
constexpr std::size_t kExtremeRuns = 825;  ///< Of combinations of all values: one of six inside.
constexpr std::size_t kRiggedRuns = 300;
constexpr std::size_t kSimulatedRuns = 476;
constexpr std::size_t kExtremeRiggedRuns = 100;
constexpr double kWidePart = 0.2;  ///< Of the random runs: those not kept to the envelope.

std::vector<RunName> bases() {
  std::vector<RunName> runs;
  for (const char* text : {
           "shape=cube density=0.5 size=1 speed=10",
           "shape=shell density=0.001 size=1 speed=0 start=deep",
           "shape=plate density=8 size=0.1 speed=100 entry=slant",
           "shape=needle density=0.5 size=10 speed=30 spin=10",
           "shape=ball density=8 size=0.001 speed=300 step=1/15",
           "shape=teapot density=0.5 size=1 speed=1 water=steep",
           "shape=tub density=0.3 size=1 speed=1 pose=flat start=half water=steep",
           "shape=tank density=0.3 size=1 speed=10 spin=3",
           "shape=ball density=0.1 start=deep speed=0 with=pinned",
           "shape=cube density=2 speed=0 pose=flat start=half with=floor",
           "shape=cube density=2 speed=0 pose=flat start=half with=stack",
           "shape=cube density=0.5 speed=1 start=deep with=chain",
       })
    runs.push_back(parse_run(text));
  return runs;
}

/// Returns every base run and its variations in each value of each parameter.
std::vector<RunName> one_at_a_time() {
  std::vector<RunName> runs;
  for (const RunName& base : bases()) {
    runs.push_back(base);
    for (const Dimension& dimension : dimensions())
      for (const std::string& value : dimension.values)
        if (value != base[dimension.key] && !is_rigged(value))
          runs.push_back(base.with(dimension.key, value));
  }
  return runs;
}

/// Returns runs in random combinations, in which every value of a parameter occurs equally often.
/// @param values   Of the parameters, in their order. @param with   Values of `with`.
std::vector<RunName> hypercube(std::size_t count, unsigned seed, std::vector<Dimension> values,
                               const std::vector<std::string>& with) {
  std::mt19937 random(seed);
  std::vector<RunName> runs(count);
  for (Dimension& dimension : values) {
    if (dimension.key == Key::with) dimension.values = with;
    std::vector<std::size_t> order(runs.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    // The result of std::shuffle depends on the standard library.
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    for (std::size_t i = 0; i < runs.size(); ++i)
      runs[i] = runs[i].with(dimension.key, dimension.values[order[i] % dimension.values.size()]);
  }
  for (RunName& run : runs) run = run.with(Key::steps, "100");
  return runs;
}

const Dimension& dimension_of(Key key) { return dimensions()[static_cast<std::size_t>(key)]; }

/// Returns the parameters with values to the bounds of the operating envelope. Light bodies with
/// much added mass lie outside it still.
const std::vector<Dimension>& inside_dimensions() {
  static const std::vector<Dimension> inside = [] {
    std::vector<Dimension> all = dimensions();
    const auto limit = [&](Key key, std::vector<std::string> values) {
      all[static_cast<std::size_t>(key)].values = std::move(values);
    };
    limit(Key::density, {"0.5", "0.01", "0.1", "0.99", "1.01", "2", "8", "20"});
    limit(Key::size, {"1", "0.005", "0.02", "0.1", "10", "100", "500"});
    limit(Key::speed, {"10", "0", "1", "30", "50"});
    limit(Key::spin, {"0", "1", "10", "50"});
    limit(Key::step, {"1/60", "1/20", "1/30", "1/120", "1/240", "1/1000"});
    limit(Key::water, {"flat", "current", "swell", "steep", "short", "jonswap", "bumps"});
    limit(Key::added, {"deep", "waves", "none", "0.5", "1", "10", "100"});
    return all;
  }();
  return inside;
}

std::vector<std::string> not_rigged() {
  std::vector<std::string> with = dimension_of(Key::with).values;
  std::erase_if(with, is_rigged);
  return with;
}

std::vector<RunName> inside() {
  return hypercube(kInsideRuns, 20261128, inside_dimensions(), not_rigged());
}
std::vector<RunName> extremes() {
  return hypercube(kExtremeRuns, 20140601, dimensions(), not_rigged());
}
std::vector<RunName> rigs_inside() {
  return hypercube(kRiggedRuns, 20261129, inside_dimensions(), rigged());
}
std::vector<RunName> rigs_at_extremes() {
  return hypercube(kExtremeRiggedRuns, 20261124, dimensions(), rigged());
}

/// Returns runs in simulated water, light bodies at long steps among them. A body that is thrown is
/// no hull there (radiation_choice.h).
std::vector<RunName> in_simulated_water() {
  std::vector<Dimension> values = inside_dimensions();
  values[static_cast<std::size_t>(Key::speed)].values = {"0", "1"};
  values[static_cast<std::size_t>(Key::spin)].values = {"0", "1"};
  values[static_cast<std::size_t>(Key::added)].values = {"simulated"};
  values[static_cast<std::size_t>(Key::water)].values = {"flat",  "current", "swell",
                                                         "steep", "short",   "jonswap"};
  std::vector<RunName> runs = hypercube(kSimulatedRuns, 20261130, values, not_rigged());
  const RunName base = parse_run("start=half pose=flat speed=0 added=simulated steps=300");
  for (const char* shape : {"cube", "ball", "tub", "teapot"})
    for (const char* density : {"0.01", "0.1", "0.5"})
      for (const char* step : {"1/60", "1/15"})
        runs.push_back(
            base.with(Key::shape, shape).with(Key::density, density).with(Key::step, step));
  return runs;
}

/// Returns runs of a minute in the water with A/m far below and above one.
std::vector<RunName> heavy_water() {
  std::vector<RunName> runs;
  const RunName base = parse_run("density=0.5 speed=1 spin=1 start=deep steps=3600");
  for (const char* with : {"free", "hinged", "pinned", "chain", "wall"})
    for (const char* added : {"waves", "0.5", "1", "2", "10", "100", "1000"})
      runs.push_back(base.with(Key::with, with).with(Key::added, added));
  return runs;
}

std::vector<RunName> great_teapots() {
  std::vector<RunName> runs;
  for (const char* text : {
           "density=0.5 speed=10",
           "density=0.5 speed=10 step=1/15",
           "density=0.001 speed=0 start=deep",
           "density=8 speed=300 size=0.1",
           "density=20 speed=30 size=300",
           "density=0.5 spin=300 speed=1",
           "density=0.5 coefs=x100 speed=30",
           "density=0.5 speed=1 water=steep start=half",
           "density=0.5 speed=1 water=breaking start=half",
           "density=0.1 speed=0 start=deep with=pinned",
           "density=2 speed=0 start=half with=floor",
           "density=0.5 speed=1 with=chain",
       })
    runs.push_back(
        parse_run(text).with(Key::shape, "teapot80k").with(Key::added, "1").with(Key::steps, "30"));
  return runs;
}

using Part = std::vector<RunName> (*)();

/// Parts of the matrix and their strides: one of so many runs is in the subset.
constexpr std::pair<Part, std::size_t> kParts[] = {
    {one_at_a_time, 8}, {inside, 17},      {extremes, 34},         {heavy_water, 6},
    {great_teapots, 6}, {rigs_inside, 17}, {rigs_at_extremes, 34}, {in_simulated_water, 17}};

std::vector<RunName> every_once(std::vector<std::size_t> strides) {
  std::vector<RunName> runs;
  for (std::size_t p = 0; p < std::size(kParts); ++p) {
    const std::vector<RunName> part = kParts[p].first();
    for (std::size_t i = 0; i < part.size(); i += strides[p])
      if (std::find(runs.begin(), runs.end(), part[i]) == runs.end()) runs.push_back(part[i]);
  }
  return runs;
}

/// True if constraints iterate the loads of a sea of many waves, or of waves shorter than the body.
bool takes_minutes(const RunName& run) {
  const bool costly = run[Key::water] == "jonswap" || run[Key::water] == "short";
  return costly && run[Key::with] != "free";
}

/// Random values of the parameters of a run.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}

  /// Returns a number whose logarithm has any value with the same probability.
  std::string number(double lo, double hi) {
    return fmt::format("{:.4g}", lo * std::pow(hi / lo, part()));
  }
  /// Returns such a number, or in one of four cases 0.
  std::string number_or_zero(double lo, double hi) { return part() < 0.25 ? "0" : number(lo, hi); }
  const std::string& one_of(const std::vector<std::string>& values) {
    return values[random_() % values.size()];
  }
  const std::string& value(Key key, const std::vector<Dimension>& dimensions) {
    return one_of(dimensions[static_cast<std::size_t>(key)].values);
  }
  double part() { return static_cast<double>(random_()) / 4294967296.0; }

 private:
  std::mt19937 random_;  ///< Its numbers are the same everywhere, those of distributions are not.
};

RunName random_run(Dice& dice) {
  RunName run;
  const std::vector<std::string> shapes = {"cube",   "ball", "shell", "plate",
                                           "needle", "tub",  "tank",  "teapot"};
  run = run.with(Key::shape, dice.one_of(shapes));
  const bool wide = dice.part() < kWidePart;
  run = run.with(Key::size, wide ? dice.number(1e-4, 1000) : dice.number(5e-3, 500));
  run = run.with(Key::density, wide ? dice.number(0.001, 40) : dice.number(0.01, 20));
  run = run.with(Key::speed, dice.number_or_zero(0.01, wide ? 300 : 50));
  run = run.with(Key::spin, dice.number_or_zero(0.01, wide ? 300 : 50));
  for (const Key key : {Key::entry, Key::pose, Key::start, Key::step, Key::added})
    run = run.with(key, dice.value(key, wide ? dimensions() : inside_dimensions()));
  run = run.with(Key::water, dice.one_of({"flat", "flat", "flat", "bumps", "swell", "steep"}));
  run = run.with(Key::coefs, dice.one_of({"default", "none", "thesis", "x100"}));
  return run.with(Key::with, "free").with(Key::steps, "100");
}

}  // namespace

std::vector<RunName> random_runs(std::size_t count, unsigned seed) {
  Dice dice(seed);
  std::vector<RunName> runs;
  while (runs.size() < count) runs.push_back(random_run(dice));
  return runs;
}

std::vector<RunName> whole_matrix() {
  return every_once(std::vector<std::size_t>(std::size(kParts), 1));
}

std::vector<RunName> subset() {
  std::vector<std::size_t> strides;
  for (const auto& part : kParts) strides.push_back(part.second);
  std::vector<RunName> runs = every_once(strides);
  std::erase_if(runs, takes_minutes);
  return runs;
}

}  // namespace stress
