#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/base/quoting.h"
#include "app/base/table.h"
#include "app/hydrostatics/curves_of_form.h"
#include "app/pages/line_plot.h"

namespace app {
namespace {

constexpr double kRadiansToDegrees = 180 / std::numbers::pi;

/// Largest round-off of a number relative to its scale; the table shows 0 for it.
constexpr double kFormRoundOff = 1e-12;

/// Quantities after the draught that stand in one table, so that its lines are not too long.
constexpr std::size_t kTableColumns = 10;

/// Cross curves whose heels a picture has room to name.
constexpr std::size_t kNamedHeels = 5;

double without_round_off(double value, double scale) {
  return std::abs(value) <= kFormRoundOff * scale ? 0 : value;
}

double shown_value(const Quantity& q) { return without_round_off(q.values[0], q.scale); }

/// A table of some of the quantities, each line indented.
std::string part_of_table(const CurvesOfForm& curves, std::size_t first, std::size_t last) {
  std::vector<Cells> rows(2);
  const auto add = [&](const FormRow& row, const auto& text_of, Cells& cells) {
    cells.push_back(text_of(row.front()));
    for (std::size_t i = first; i < last; ++i) cells.push_back(text_of(row[i]));
  };
  add(
      curves.rows.front(), [](const Quantity& q) { return q.key; }, rows[0]);
  add(
      curves.rows.front(), [](const Quantity& q) { return q.unit; }, rows[1]);
  for (const FormRow& row : curves.rows)
    add(
        row, [](const Quantity& q) { return fmt::format("{:.6g}", shown_value(q)); },
        rows.emplace_back());
  std::string table;
  for (const std::string& line : aligned_lines(rows)) table += line + '\n';
  return table;
}

std::string cross_table(const CurvesOfForm& curves) {
  if (curves.cross_curves.empty()) return "";
  std::vector<Cells> rows = {{"draught", "displacement"}, {"m", "kg"}};
  for (const hydro::RightingArm& arm : curves.cross_curves.front().arms) {
    rows[0].push_back(fmt::format("KN {:g}°", arm.heel * kRadiansToDegrees));
    rows[1].push_back("m");
  }
  for (const CrossCurve& curve : curves.cross_curves) {
    Cells& cells = rows.emplace_back();
    cells = {fmt::format("{:.6g}", curve.draught), fmt::format("{:.6g}", curve.displacement)};
    for (const hydro::RightingArm& arm : curve.arms)
      cells.push_back(fmt::format("{:.4g}", without_round_off(arm.lever, curves.most)));
  }
  std::string table = "\n";
  for (const std::string& line : aligned_lines(rows)) table += line + '\n';
  return table;
}

/// Values of a quantity over the draught.
PlotLine line_of(const CurvesOfForm& curves, const std::string& key, const std::string& name,
                 double factor = 1) {
  PlotLine line{.name = name, .x = {}, .y = {}};
  for (const FormRow& row : curves.rows) {
    line.x.push_back(row.front().values[0]);
    line.y.push_back(factor * shown_value(*std::ranges::find(row, key, &Quantity::key)));
  }
  return line;
}

/// Explanation of the names in the table.
const char* const kFormLegend =
    "\ndraught: height of the waterline over the keel amidships. kb, km_…: over the keel; bm_t and "
    "km_t about the\nlongitudinal, bm_l and km_l about the transverse axis. lcb, lcf: along the "
    "upright mesh's x axis. tpc: tonnes\nper centimetre of immersion; mct: moment to change the "
    "trim "
    "by a centimetre over the length, by bm_l. length and\nbreadth: of the waterline; "
    "midship_area: "
    "immersed, in the middle of that length. cb = volume / (length breadth\ndraught), cw = "
    "waterplane_area / (length breadth), cm = midship_area / (breadth draught), cp = volume / "
    "(length\nmidship_area).\n";

}  // namespace

std::string form_table(const std::vector<CurvesOfForm>& bodies) {
  std::string table;
  bool crossed = false;
  for (const CurvesOfForm& curves : bodies) {
    if (!table.empty()) table += '\n';
    table += fmt::format(
        "{}: {} in water of {:g} kg/m^3; the waterline cuts it between draughts "
        "of {:.4g} and {:.4g} m\n",
        curves.body,
        curves.trim == 0 ? "upright"
                         : fmt::format("trimmed by {:g} deg", curves.trim * kRadiansToDegrees),
        curves.density, std::max(0.0, curves.least), curves.most);
    if (curves.rows.empty()) {
      table += "  no draught is between these\n";
      continue;
    }
    const std::size_t count = curves.rows.front().size();
    for (std::size_t first = 1; first < count; first += kTableColumns)
      table += '\n' + part_of_table(curves, first, std::min(count, first + kTableColumns));
    table += cross_table(curves);
    crossed = crossed || !curves.cross_curves.empty();
  }
  table += kFormLegend;
  if (crossed)
    table +=
        "KN: righting arm about the keel under the centre of buoyancy, free to trim: GZ = KN - "
        "KG sin(heel).\n";
  return table;
}

std::string form_json(const std::vector<CurvesOfForm>& bodies) {
  using Json = nlohmann::ordered_json;
  Json all = Json::object();
  for (const CurvesOfForm& curves : bodies) {
    Json& body = all[curves.body] = {{"trim_deg", curves.trim * kRadiansToDegrees},
                                     {"density", curves.density},
                                     {"curves_of_form", Json::array()}};
    for (const FormRow& row : curves.rows) {
      Json numbers = Json::object();
      for (const Quantity& q : row) numbers[q.key] = q.values[0];
      body["curves_of_form"].push_back(std::move(numbers));
    }
    for (const CrossCurve& curve : curves.cross_curves)
      for (const hydro::RightingArm& arm : curve.arms)
        body["kn"].push_back({{"draught", curve.draught},
                              {"displacement", curve.displacement},
                              {"heel_deg", arm.heel * kRadiansToDegrees},
                              {"trim_deg", arm.trim * kRadiansToDegrees},
                              {"kn", arm.lever}});
  }
  return Json{{"bodies", all}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string form_csv(const std::vector<CurvesOfForm>& bodies) {
  std::string csv = "body,draught,quantity,heel_deg,value,unit\n";
  for (const CurvesOfForm& curves : bodies) {
    const std::string name = csv_field(curves.body);
    for (const FormRow& row : curves.rows)
      for (std::size_t i = 1; i < row.size(); ++i)
        csv += fmt::format("{},{},{},,{},{}\n", name, row.front().values[0], row[i].key,
                           row[i].values[0], row[i].unit);
    for (const CrossCurve& curve : curves.cross_curves)
      for (const hydro::RightingArm& arm : curve.arms)
        csv += fmt::format("{},{},kn,{},{},m\n", name, curve.draught, arm.heel * kRadiansToDegrees,
                           arm.lever);
  }
  return csv;
}

std::string form_svg(const CurvesOfForm& curves) {
  const auto at = [&](int column, int row) {
    PlotPanel panel = panel_at(column, row);
    const double first = curves.rows.front().front().values[0],
                 last = curves.rows.back().front().values[0];
    panel.least_x = last > first ? first : 0.5 * first;
    panel.most_x = last > first ? last : 1.5 * last;
    return panel;
  };
  const auto line = [&](const char* key, const char* name, double factor = 1) {
    return line_of(curves, key, name, factor);
  };
  const std::string axis = "draught [m]";
  std::string panels =
      line_panel(at(0, 0), "displacement [t]", axis, {line("displacement", "", 1e-3)}) +
      line_panel(at(1, 0), "area [m²]", axis,
                 {line("waterplane_area", "waterplane"), line("wetted_surface", "wetted"),
                  line("midship_area", "midship")}) +
      line_panel(at(2, 0), "along x [m]", axis, {line("lcb", "LCB"), line("lcf", "LCF")}, false) +
      line_panel(at(0, 1), "KB, BM and KM [m]", axis,
                 {line("kb", "KB"), line("bm_t", "BM"), line("km_t", "KM")}) +
      line_panel(at(1, 1), "longitudinal KM [m]", axis, {line("km_l", "")}) +
      line_panel(at(2, 1), "coefficients [-]", axis,
                 {line("cb", "Cb"), line("cw", "Cw"), line("cm", "Cm"), line("cp", "Cp")}) +
      line_panel(at(0, 2), "TPC [t/cm]", axis, {line("tpc", "")}) +
      line_panel(at(1, 2), "MCT1cm [t m/cm]", axis, {line("mct", "")});
  if (!curves.cross_curves.empty()) {
    std::vector<PlotLine> lines;
    const std::size_t count = curves.cross_curves.front().arms.size();
    const std::size_t every = (count + kNamedHeels - 1) / kNamedHeels;
    for (std::size_t h = 0; h < count; ++h) {
      PlotLine& kn = lines.emplace_back();
      for (const CrossCurve& curve : curves.cross_curves) {
        if (h % every == 0) kn.name = fmt::format("{:g}°", curve.arms[h].heel * kRadiansToDegrees);
        kn.x.push_back(curve.draught);
        kn.y.push_back(without_round_off(curve.arms[h].lever, curves.most));
      }
    }
    panels += line_panel(at(2, 2), "KN [m]", axis, lines);
  }
  return panel_picture(3, 3,
                       fmt::format("{}: curves of form, {}, {:g} kg/m³", curves.body,
                                   curves.trim == 0 ? "upright"
                                                    : fmt::format("trimmed by {:g}°",
                                                                  curves.trim * kRadiansToDegrees),
                                   curves.density),
                       panels);
}

std::string righting_arms_svg(const std::vector<FloatingReport>& reports) {
  PlotPanel panel = panel_at(0, 0);
  std::vector<PlotLine> lines;
  bool first = true;
  for (const FloatingReport& report : reports) {
    if (report.righting_arms.empty()) continue;
    PlotLine& line = lines.emplace_back();
    line.name = report.body.name;
    for (const hydro::RightingArm& arm : report.righting_arms) {
      line.x.push_back(arm.heel * kRadiansToDegrees);
      line.y.push_back(without_round_off(arm.lever, arm.draught));
    }
    panel.least_x = first ? line.x.front() : std::min(panel.least_x, line.x.front());
    panel.most_x = first ? line.x.back() : std::max(panel.most_x, line.x.back());
    first = false;
  }
  if (!(panel.most_x > panel.least_x)) panel.most_x = panel.least_x + 1;
  constexpr double kScale = 2;  // of a picture of one panel
  return panel_picture(1, 1, "Righting arms", line_panel(panel, "GZ [m]", "heel [°]", lines),
                       kScale);
}

}  // namespace app
