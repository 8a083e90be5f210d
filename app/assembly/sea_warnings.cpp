#include "app/assembly/sea_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "app/assembly/build_shape.h"
#include "hydro/airy_waves.h"

namespace assembly {
namespace {

/// Height over length of the steepest wave on deep water, by Miche; times tanh kh on any depth.
constexpr double kSteepestWave = 1.0 / 7;

/// Slope of a height field that no water has: the crest of the steepest wave has 0.58, by Stokes.
constexpr double kSteepestField = 1;

/// Significant height over the length of a wave of the peak period on deep water in the steepest
/// sea: half of the steepest wave's.
constexpr double kSteepestSea = kSteepestWave / 2;

constexpr double kLeastKh = 0.3;        ///< kh below which waves are long waves, not Airy's.
constexpr double kMostOfDepth = 0.2;    ///< Amplitude over depth that linear theory allows.
constexpr double kStepsPerPeriod = 10;  ///< Fewest steps in the period of a wave.

/// Part of the energy that the shortest waves may have without being worth a finer step.
constexpr double kEnergyLeftOut = 0.05;

using Components = std::vector<hydro::WaveComponent>;

double wavelength(const hydro::WaveComponent& w) { return 2 * M_PI / wave_number(w); }

/// Height over length from which on a wave breaks.
double breaking_steepness(const hydro::WaveComponent& w, double depth) {
  return kSteepestWave * std::tanh(wave_number(w) * depth);
}

bool wave_breaks(const hydro::WaveComponent& w, double depth) {
  return w.amplitude != 0 && 2 * w.amplitude > breaking_steepness(w, depth) * wavelength(w);
}

/// Largest slope between neighbouring heights.
double steepest_slope(const hydro::HeightField& field) {
  const auto& z = field.heights;
  double rise = 0;
  if (z.cols() > 1)
    rise = (z.rightCols(z.cols() - 1) - z.leftCols(z.cols() - 1)).cwiseAbs().maxCoeff();
  if (z.rows() > 1)
    rise = std::max(rise,
                    (z.bottomRows(z.rows() - 1) - z.topRows(z.rows() - 1)).cwiseAbs().maxCoeff());
  return rise / field.cell;
}

/// Returns the shortest wave that carries energy: shorter ones have less than kEnergyLeftOut of it.
std::optional<hydro::WaveComponent> shortest_wave(Components waves) {
  std::sort(waves.begin(), waves.end(),
            [](const auto& a, const auto& b) { return wave_number(a) > wave_number(b); });
  const auto energy = [](const auto& w) { return w.amplitude * w.amplitude; };
  const double total = std::accumulate(waves.begin(), waves.end(), 0.0,
                                       [&](double sum, auto& w) { return sum + energy(w); });
  double sum = 0;
  for (const hydro::WaveComponent& w : waves)
    if (total > 0 && (sum += energy(w)) >= kEnergyLeftOut * total) return w;
  return std::nullopt;
}

/// The warnings of one scene with waves.
class SeaWarnings {
 public:
  SeaWarnings(const scene::Scene& scene, const BuiltScene& built)
      : scene_(scene),
        spec_(built.spec),
        irregular_(built.irregular_sea),
        sea_(*built.spec.sea),
        waves_(std::get<hydro::WaveSurface>(sea_.surface).components) {}

  std::vector<std::string> all() {
    const scene::Surface& surface = scene_.water->surface;
    if (const auto* spectrum = std::get_if<scene::Spectrum>(&surface)) {
      const std::string path = "water.surface.spectrum";
      if (spectrum->file)
        check_irregular(*irregular_, path + ".file", path + ".file");
      else
        check_irregular(*irregular_, path + ".significant_height", path + ".peak_period");
    }
    if (std::holds_alternative<scene::Elevation>(surface))
      check_irregular(*irregular_, "water.surface.elevation.file", "water.surface.elevation.file");
    if (const auto* waves = std::get_if<std::vector<scene::Wave>>(&surface))
      for (std::size_t i = 0; i < waves->size(); ++i)
        check_wave(waves_[i], fmt::format("water.surface.waves[{}]", i),
                   (*waves)[i].period ? ".period" : ".wavelength");
    if (const auto shortest = shortest_wave(waves_)) check_step(*shortest);
    check_ground();
    return std::move(lines_);
  }

 private:
  void check_wave(const hydro::WaveComponent& wave, const std::string& path,
                  const std::string& length_key) {
    if (wave.amplitude == 0) return;
    const double k = wave_number(wave), length = wavelength(wave);
    const double bound = breaking_steepness(wave, sea_.depth);
    if (wave_breaks(wave, sea_.depth))
      lines_.push_back(fmt::format(
          "{}.amplitude: the height of the wave is {:.3g} of its length, and waves break from "
          "{:.3g} on; expected at most {:.3g} m",
          path, 2 * wave.amplitude / length, bound, bound * length / 2));
    check_depth(k, wave.amplitude, path + length_key, path + ".amplitude", 1);
  }

  void check_irregular(const IrregularSea& sea, const std::string& height_key,
                       const std::string& period_key) {
    const double omega = 2 * M_PI / sea.peak_period;
    const double length = 2 * M_PI * sea_.gravity / (omega * omega);
    if (sea.significant_height > kSteepestSea * length)
      lines_.push_back(fmt::format(
          "{}: the significant height is {:.3g} of the length of a wave of the peak period, and "
          "seas break from {:.3g} on; expected at most {:.3g} m",
          height_key, sea.significant_height / length, kSteepestSea, kSteepestSea * length));
    if (const auto k = hydro::wave_number(omega, sea_.depth, sea_.gravity))
      check_depth(*k, sea.significant_height / 2, period_key, height_key, 2);
  }

  /// @param factor   Value of `height_key` over the amplitude [-].
  void check_depth(double k, double amplitude, const std::string& length_key,
                   const std::string& height_key, double factor) {
    if (k * sea_.depth < kLeastKh)
      lines_.push_back(fmt::format(
          "{}: the wave's kh is {:.3g} on water.depth of {:g} m, and linear theory ends below "
          "{:g}; expected a depth of at least {:.3g} m or a shorter wave",
          length_key, k * sea_.depth, sea_.depth, kLeastKh, kLeastKh / k));
    if (amplitude > kMostOfDepth * sea_.depth)
      lines_.push_back(fmt::format(
          "{}: half the height of the wave is {:.3g} of water.depth, and linear theory ends above "
          "{:g}; expected at most {:.3g} m",
          height_key, amplitude / sea_.depth, kMostOfDepth, factor * kMostOfDepth * sea_.depth));
  }

  void check_step(const hydro::WaveComponent& shortest) {
    const double period = 2 * M_PI / std::abs(shortest.omega);
    if (scene_.step > period / kStepsPerPeriod)
      lines_.push_back(fmt::format(
          "step: {:.3g} s is {:.3g} of the period of the shortest wave, {:.3g} s; expected at most "
          "{:.3g} s",
          scene_.step, scene_.step / period, period, period / kStepsPerPeriod));
  }

  /// Depth of the deepest ground below the level [m]; none without ground.
  std::optional<double> depth_of_ground() const {
    if (const auto* plane = std::get_if<engine::PlaneGround>(&spec_.ground))
      return sea_.level - plane->z;
    if (const auto* mesh = std::get_if<engine::MeshGround>(&spec_.ground))
      return sea_.level - mesh->mesh_W.vertices.row(2).minCoeff();
    return std::nullopt;
  }

  /// Length of the highest wave, or of the waves of a spectrum's peak, on deep water [m].
  double peak_length() const {
    if (irregular_)
      return sea_.gravity * irregular_->peak_period * irregular_->peak_period / (2 * M_PI);
    const auto highest =
        std::max_element(waves_.begin(), waves_.end(),
                         [](const auto& a, const auto& b) { return a.amplitude < b.amplitude; });
    return highest == waves_.end() || highest->amplitude == 0 ? 0 : wavelength(*highest);
  }

  void check_ground() {
    const std::optional<double> depth = depth_of_ground();
    const double bound = peak_length() / 2;
    if (scene_.water->depth || !depth || *depth <= 0 || *depth >= bound) return;
    lines_.push_back(fmt::format(
        "water.depth: missing, so the waves are those of deep water, but ground lies {:.3g} m "
        "below water.level, and waves of {:.3g} m length feel it down to {:.3g} m; expected "
        "water.depth: {:.3g}",
        *depth, 2 * bound, bound, *depth));
  }

  const scene::Scene& scene_;
  const engine::SimulationSpec& spec_;
  const std::optional<IrregularSea>& irregular_;
  const hydro::Sea& sea_;
  const Components& waves_;
  std::vector<std::string> lines_;
};

}  // namespace

bool breaks(const hydro::Sea& sea) {
  if (const auto* field = std::get_if<hydro::HeightField>(&sea.surface))
    return steepest_slope(*field) > kSteepestField;
  const auto* waves = std::get_if<hydro::WaveSurface>(&sea.surface);
  return waves && std::ranges::any_of(waves->components,
                                      [&](const auto& w) { return wave_breaks(w, sea.depth); });
}

std::vector<std::string> sea_warnings(const scene::Scene& scene, const BuiltScene& built) {
  const std::optional<hydro::Sea>& sea = built.spec.sea;
  if (!sea) return {};
  if (const auto* field = std::get_if<hydro::HeightField>(&sea->surface)) {
    if (!breaks(*sea)) return {};
    return {
        fmt::format("water.surface.heightfield: neighbouring heights differ by {:.3g} of the cell, "
                    "and no water "
                    "is so steep; expected at most {:g}",
                    steepest_slope(*field), kSteepestField)};
  }
  if (!std::holds_alternative<hydro::WaveSurface>(sea->surface)) return {};
  return SeaWarnings(scene, built).all();
}

}  // namespace assembly
