#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/base/atomic_file.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/hydrostatics/curves_of_form.h"

namespace app {
namespace {

/// Checks that a body floats. @throws InputError with the reason for each body if none does.
void check_that_one_floats(const std::vector<FloatingReport>& reports,
                           const std::filesystem::path& file) {
  std::vector<scene::Fault> faults;
  for (const FloatingReport& report : reports) {
    if (report.not_afloat.empty()) return;
    faults.push_back({{file}, report.body.name, report.not_afloat});
  }
  throw scene::InputError(std::move(faults));
}

void check_hydrostatics_options(const HydrostaticsOptions& o) {
  refuse_if(o.json && o.csv, "--csv", "given beside --json, expected only one of them");
  refuse_if(!o.plot.empty() && o.plot.extension() != ".svg", "--plot",
            fmt::format("found {}, expected a file .svg", o.plot.string()));
  refuse_if(o.trim && o.draughts.empty(), "--trim",
            "is for the curves of form, expected several draughts by --draught FIRST:LAST:STEP");
  refuse_if(o.trim && !(std::abs(*o.trim) < std::numbers::pi / 4), "--trim",
            "expected less than 45 degrees");
  refuse_if(o.trim && o.heels_given, "--heel",
            "given beside --trim, and a body that heels for its cross curves trims freely");
}

/// Prints and draws the curves of form of all bodies.
void write_curves_of_form(const HydrostaticsOptions& o) {
  std::vector<CurvesOfForm> all;
  std::string ranges;
  bool any = false;
  for (const FloatingBody& body : floating_bodies(o)) {
    all.push_back(curves_of_form(in_upright_axes(body), o.draughts, o.trim.value_or(0),
                                 o.heels_given ? o.heels : std::vector<double>{}));
    any = any || !all.back().rows.empty();
    ranges += fmt::format("{} {} between {:g} and {:g} m", ranges.empty() ? "" : ",", body.name,
                          std::max(0.0, all.back().least), all.back().most);
  }
  refuse_if(!any, "--draught", "no draught at which the waterline cuts a body, expected" + ranges);
  refuse_if(!o.plot.empty() && all.size() > 1, "--plot",
            "draws the curves of form of one body, and the scene has several");
  if (!o.plot.empty()) write_whole(o.plot, form_svg(all.front()));
  print(o.json ? form_json(all) : o.csv ? form_csv(all) : form_table(all));
  flush_output();
}

}  // namespace

int hydrostatics(const HydrostaticsOptions& options) {
  check_hydrostatics_options(options);
  if (!options.draughts.empty()) {
    write_curves_of_form(options);
    return kDone;
  }
  std::vector<FloatingReport> reports;
  for (const FloatingBody& body : floating_bodies(options))
    reports.push_back(floating_report(body, options.heels));
  check_that_one_floats(reports, options.file);
  if (!options.plot.empty()) write_whole(options.plot, righting_arms_svg(reports));
  print(options.json  ? floating_json(reports)
        : options.csv ? floating_csv(reports)
                      : floating_table(reports));
  flush_output();
  return kDone;
}

}  // namespace app
