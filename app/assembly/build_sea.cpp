#include "app/assembly/build_sea.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

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

Components file_components(const scene::Spectrum& s, const hydro::Sea& sea, IrregularSea& irregular,
                           BuildLog& log) try {
  hydro::TabulatedSpectrum spectrum = read_spectrum(*s.file);
  spectrum.heading = s.heading;
  spectrum.spreading = s.spreading;
  spectrum.seed = s.seed;
  spectrum.components = s.components;
  irregular.significant_height = 4 * std::sqrt(hydro::spectral_energy(spectrum));
  irregular.peak_period = 2 * M_PI / hydro::peak_frequency(spectrum);
  if (irregular.significant_height >= sea.depth)
    log.faults.add(log.scene.places, "water.surface.spectrum.file",
                   fmt::format("its significant height is {:.3g} m, expected less than the depth "
                               "of {:g} m",
                               irregular.significant_height, sea.depth));
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

}  // namespace

hydro::Sea build_sea(const scene::Water& water, double gravity,
                     std::optional<IrregularSea>& irregular, BuildLog& log) {
  hydro::Sea sea{.density = water.density,
                 .gravity = gravity,
                 .level = water.level,
                 .depth = water.depth.value_or(std::numeric_limits<double>::infinity()),
                 .current = water.current};
  if (const auto* waves = std::get_if<std::vector<scene::Wave>>(&water.surface))
    sea.surface = hydro::WaveSurface{wave_components(*waves, sea, log), water.kinematics};
  else if (const auto* spectrum = std::get_if<scene::Spectrum>(&water.surface))
    sea.surface =
        hydro::WaveSurface{spectrum_components(*spectrum, sea, irregular, log), water.kinematics};
  else if (const auto* field = std::get_if<scene::HeightField>(&water.surface))
    sea.surface = height_field(*field, "water.surface.heightfield", log);
  return sea;
}

}  // namespace assembly
