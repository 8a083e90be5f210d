#include "app/assembly/build_sea.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "app/assembly/elevation_file.h"
#include "app/assembly/spectrum_file.h"
#include "app/base/words.h"
#include "hydro/airy_waves.h"
#include "hydro/wave_spectrum.h"

namespace assembly {
namespace {

using Components = std::vector<hydro::WaveComponent>;

/// Returns the wave number of a wave [rad/m]; none, and a fault, if no wave has its period.
std::optional<double> wave_number(const scene::Wave& wave, const hydro::Sea& sea,
                                  const std::string& path, BuildLog& log) {
  if (wave.wavelength) return 2 * M_PI / *wave.wavelength;
  const double along =
      sea.current.head<2>().dot(Eigen::Vector2d(std::cos(wave.heading), std::sin(wave.heading)));
  const auto k = hydro::wave_number(2 * M_PI / *wave.period, sea.depth, sea.gravity, along);
  if (!k)
    log.faults.add(log.scene.places, path + ".period",
                   fmt::format("a wave of this period, {:g} s, cannot travel against this current, "
                               "which is {:.3g} m/s along its heading",
                               *wave.period, along));
  return k;
}

Components wave_components(const std::vector<scene::Wave>& waves, const hydro::Sea& sea,
                           BuildLog& log) {
  Components components;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const scene::Wave& w = waves[i];
    const std::string path = fmt::format("water.surface.waves[{}]", i);
    if (const auto k = wave_number(w, sea, path, log))
      components.push_back(hydro::linear_wave(sea, w.amplitude, *k, w.heading, w.phase));
  }
  return components;
}

double peak_enhancement(const scene::Spectrum& s) {
  if (s.type == scene::Spectrum::Type::pierson_moskowitz ||
      s.type == scene::Spectrum::Type::bretschneider)
    return 1;
  return s.gamma.value_or(hydro::usual_gamma(s.significant_height, s.peak_period));
}

/// Adds the faults of a file that a key names.
void add_file_faults(const scene::InputError& error, const std::string& key, BuildLog& log) {
  for (const scene::Fault& fault : error.faults())
    log.faults.add(log.scene.places, key, to_string(scene::Fault{fault.place, "", fault.message}));
}

/// Refuses waves that are as high as the water is deep.
void check_height(const IrregularSea& irregular, const hydro::Sea& sea, const std::string& key,
                  BuildLog& log) {
  if (irregular.significant_height < sea.depth) return;
  log.faults.add(log.scene.places, key,
                 fmt::format("its significant height is {:.3g} m, expected less than the depth of "
                             "{:g} m",
                             irregular.significant_height, sea.depth));
}

Components file_components(const scene::Spectrum& s, const hydro::Sea& sea, IrregularSea& irregular,
                           BuildLog& log) try {
  hydro::TabulatedSpectrum spectrum = read_spectrum(*s.file);
  spectrum.heading = s.heading;
  spectrum.spreading = s.spreading;
  spectrum.seed = s.seed;
  spectrum.components = s.components;
  irregular.significant_height = 4 * std::sqrt(hydro::spectral_energy(spectrum));
  irregular.peak_period = 2 * M_PI / hydro::peak_frequency(spectrum);
  check_height(irregular, sea, "water.surface.spectrum.file", log);
  log.notes.push_back(fmt::format(
      "water.surface.spectrum: {} has a significant height of {:.4g} m and a peak period of {:.4g} "
      "s in {} rows",
      s.file->filename().string(), irregular.significant_height, irregular.peak_period,
      spectrum.frequencies.size()));
  return hydro::tabulated_sea(spectrum, sea).components;
} catch (const scene::InputError& error) {
  add_file_faults(error, "water.surface.spectrum.file", log);
  return {};
}

Components formula_components(const scene::Spectrum& s, const hydro::Sea& sea) {
  return hydro::jonswap_sea({.significant_height = s.significant_height,
                             .peak_period = s.peak_period,
                             .gamma = peak_enhancement(s),
                             .tma = s.type == scene::Spectrum::Type::tma,
                             .heading = s.heading,
                             .spreading = s.spreading,
                             .seed = s.seed,
                             .components = s.components},
                            sea)
      .components;
}

Components spectrum_components(const scene::Spectrum& s, const hydro::Sea& sea,
                               std::optional<IrregularSea>& irregular, BuildLog& log) try {
  irregular = IrregularSea{.significant_height = s.significant_height,
                           .peak_period = s.peak_period,
                           .waves = s.components};
  return s.file ? file_components(s, sea, *irregular, log) : formula_components(s, sea);
} catch (const std::invalid_argument& error) {
  log.faults.add(log.scene.places, "water.surface.spectrum", error.what());
  return {};
}

const char* const kElevation = "water.surface.elevation";

/// Checks what the band and the start need from the record.
void check_record(const scene::Elevation& e, const hydro::ElevationRecord& record, BuildLog& log) {
  const double nyquist = M_PI / record.interval;
  for (const auto& [key, value] :
       {std::pair(".lowest_frequency_hz", e.lowest), std::pair(".highest_frequency_hz", e.highest)})
    if (value && *value >= nyquist)
      log.faults.add(log.scene.places, std::string(kElevation) + key,
                     fmt::format("found {:g}, expected less than half the sampling frequency of "
                                 "{:g} Hz",
                                 *value / (2 * M_PI), nyquist / M_PI));
  const double last = record.start + record.length();
  if (e.start && (*e.start < record.start || *e.start >= last))
    log.faults.add(log.scene.places, std::string(kElevation) + ".start",
                   fmt::format("found {:g}, expected a time of the record, which is from {:g} to "
                               "{:g} s",
                               *e.start, record.start, last));
}

std::string percent(double part) { return fmt::format("{:.2g} %", 100 * part); }

/// Tells how well the waves fit the record.
void note_fit(const scene::Elevation& e, const IrregularSea& irregular, BuildLog& log) {
  const hydro::ElevationFit& fit = *irregular.fit;
  const std::string path = kElevation;
  std::string left_out = fmt::format("{} of its energy is below the band, {} above",
                                     percent(fit.below), percent(fit.above));
  if (fit.dropped > 0)
    left_out += fmt::format(", {} in weak waves beyond components", percent(fit.dropped));
  if (fit.stopped > 0)
    left_out += fmt::format(", {} in waves that the current stops", percent(fit.stopped));
  log.notes.push_back(fmt::format(
      "{}: {} waves of {:.3g} to {:.3g} Hz have the elevation of {} (significant height {:.3g} m, "
      "peak period {:.3g} s, mean {:.2g} m left out) with an RMS error of {} of its RMS; {}",
      path, irregular.waves, fit.lowest / (2 * M_PI), fit.highest / (2 * M_PI),
      e.file.filename().string(), irregular.significant_height, irregular.peak_period, fit.mean,
      percent(fit.residual), left_out));
}

/// Warns of a record that the run or the waves do not fit.
void warn_of_record(const hydro::ElevationRecord& record, const hydro::ElevationFit& fit,
                    BuildLog& log) {
  constexpr double kPoorFit = 0.2;  // 4 % of the energy
  constexpr double kLargeJump = 3;  // in the largest steps of the record
  const std::string path = kElevation;
  const double end = record.start + record.length();
  if (log.scene.duration > end)
    log.warnings.push_back(
        fmt::format("{}.file: the record ends at {:g} s of a run of {:g} s, and the waves then "
                    "repeat; expected "
                    "a longer record or duration: {:g}",
                    path, end, log.scene.duration, end));
  if (fit.residual > kPoorFit)
    log.warnings.push_back(
        fmt::format("{}: the waves miss the record by {} of its RMS; expected a wider band, by "
                    "lowest_frequency_hz and highest_frequency_hz, or more components",
                    path, percent(fit.residual)));
  if (fit.jump > kLargeJump)
    log.warnings.push_back(fmt::format(
        "{}.file: from its last to its first elevation the record jumps by {:.2g} of its largest "
        "steps, so near its ends the waves leak; expected a record without drift that begins and "
        "ends alike",
        path, fit.jump));
}

Components elevation_components(const scene::Elevation& e, const hydro::Sea& sea,
                                std::optional<IrregularSea>& irregular, BuildLog& log) try {
  hydro::ElevationRecord record = read_elevation(e.file);
  check_record(e, record, log);
  record.start -= e.start.value_or(record.start);
  const hydro::MeasuredSea measured = hydro::sea_of_record(record,
                                                           {.at = e.at,
                                                            .heading = e.heading,
                                                            .lowest = e.lowest,
                                                            .highest = e.highest,
                                                            .components = e.components},
                                                           sea);
  irregular = IrregularSea{.significant_height = measured.fit.significant_height,
                           .peak_period = measured.fit.peak_period,
                           .waves = static_cast<int>(measured.components.size()),
                           .fit = measured.fit};
  check_height(*irregular, sea, std::string(kElevation) + ".file", log);
  note_fit(e, *irregular, log);
  warn_of_record(record, measured.fit, log);
  return measured.components;
} catch (const scene::InputError& error) {
  add_file_faults(error, std::string(kElevation) + ".file", log);
  return {};
} catch (const std::invalid_argument& error) {
  log.faults.add(log.scene.places, kElevation, error.what());
  return {};
}

/// Returns the waves of a surface that has some.
Components components_of(const scene::Surface& surface, const hydro::Sea& sea,
                         std::optional<IrregularSea>& irregular, BuildLog& log) {
  if (const auto* spectrum = std::get_if<scene::Spectrum>(&surface))
    return spectrum_components(*spectrum, sea, irregular, log);
  if (const auto* elevation = std::get_if<scene::Elevation>(&surface))
    return elevation_components(*elevation, sea, irregular, log);
  return wave_components(std::get<std::vector<scene::Wave>>(surface), sea, log);
}

bool changes_with_depth(const std::vector<hydro::CurrentRow>& profile) {
  return std::any_of(profile.begin(), profile.end(), [&](const hydro::CurrentRow& row) {
    return row.velocity != profile.front().velocity;
  });
}

}  // namespace

hydro::Sea build_sea(const scene::Water& water, double gravity,
                     std::optional<IrregularSea>& irregular, BuildLog& log) {
  hydro::Sea sea{.density = water.density,
                 .gravity = gravity,
                 .level = water.level,
                 .depth = water.depth.value_or(std::numeric_limits<double>::infinity()),
                 .current = water.current};
  if (changes_with_depth(water.current_profile)) sea.profile = water.current_profile;
  if (const auto* field = std::get_if<scene::HeightField>(&water.surface))
    sea.surface = height_field(*field, "water.surface.heightfield", log);
  else if (!std::holds_alternative<scene::Flat>(water.surface))
    sea.surface = hydro::WaveSurface{components_of(water.surface, sea, irregular, log),
                                     water.kinematics, water.ramp};
  return sea;
}

}  // namespace assembly
