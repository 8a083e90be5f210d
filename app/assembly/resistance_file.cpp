#include "app/assembly/resistance_file.h"

#include <fmt/format.h>

#include <vector>

#include "app/assembly/column_file.h"
#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

const char* const kResistanceUsage = "expected the columns speed [m/s] and force [N]";

}  // namespace

hydro::ResistanceCurve read_resistance(const std::filesystem::path& file) {
  const ColumnFile table = read_columns(file, {"speed", "force"}, kResistanceUsage);
  const std::vector<double>*speed = table.find("speed"), *force = table.find("force");
  if (speed == nullptr || force == nullptr) throw scene::InputError(file, kResistanceUsage);
  std::vector<double> speeds, forces;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double u = (*speed)[i], f = (*force)[i];
    if (u < 0) table.refuse(file, i, fmt::format("found the speed {:g}, expected one >= 0", u));
    if (i > 0 && u <= (*speed)[i - 1])
      table.refuse(file, i,
                   fmt::format("found the speed {:g} after {:g}, expected ascending ones", u,
                               (*speed)[i - 1]));
    if (f < 0)
      table.refuse(file, i,
                   fmt::format("found the force {:g}, expected one >= 0 against the motion", f));
    if (u == 0 && f != 0)
      table.refuse(file, i, fmt::format("found the force {:g} at rest, expected 0", f));
    if (u == 0) continue;  // The curve has this row.
    speeds.push_back(u);
    forces.push_back(f);
  }
  if (speeds.empty()) throw scene::InputError(file, "found no row with a speed above 0");
  return {speeds, forces};
}

}  // namespace assembly
