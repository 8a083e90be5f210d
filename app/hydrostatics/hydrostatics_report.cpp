#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/base/quoting.h"
#include "app/hydrostatics/hydrostatics.h"
#include "hydro/decompositions.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180;

/// Largest round-off of a number relative to its scale; the table shows 0 for it.
constexpr double kRoundOff = 1e-12;

std::string word(hydro::Stability stability) {
  switch (stability) {
    case hydro::Stability::stable:
      return "stable";
    case hydro::Stability::neutral:
      return "neutral";
    case hydro::Stability::unstable:
      break;
  }
  return "unstable";
}

std::vector<double> list(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Adds the metacentric heights and the terms they consist of.
void add_stability(const hydro::Flotation& f, std::vector<Quantity>& all) {
  const hydro::Hydrostatics& h = f.hydrostatics;
  const double keel = -f.draught - f.height;  // height of the lowest point, in G
  const double size = f.draught;
  const Eigen::Matrix2d gm = f.effective_metacentric_heights();
  const Eigen::Vector2d principal = hydro::eigenvalues(gm);
  const Eigen::Matrix2d& second = h.waterplane.second_moment;
  const double largest = second.trace();
  all.push_back({"second_moment_transverse", "m^4", {second(1, 1)}, largest});
  all.push_back({"second_moment_longitudinal", "m^4", {second(0, 0)}, largest});
  all.push_back({"second_moment_product", "m^4", {second(0, 1)}, largest});
  all.push_back({"kb", "m", {h.centre_of_buoyancy.z() - keel}, size});
  double kg = -keel, free_surface = 0;
  for (const hydro::Hydrostatics& tank : f.tanks) {
    kg += tank.volume / h.volume * tank.centre_of_buoyancy.z();
    free_surface += tank.waterplane.second_moment(1, 1) / h.volume;
  }
  all.push_back({"kg", "m", {kg}, size});
  all.push_back({"bm_t", "m", {second(1, 1) / h.volume}, size});
  all.push_back({"bm_l", "m", {second(0, 0) / h.volume}, size});
  if (!f.tanks.empty()) {
    all.push_back({"gm_solid_t", "m", {gm(0, 0) + free_surface}, size});
    all.push_back({"free_surface_loss_t", "m", {free_surface}, size});
  }
  all.push_back({"gm_t", "m", {gm(0, 0)}, size});
  all.push_back({"gm_l", "m", {gm(1, 1)}, size});
  all.push_back({"gm_least", "m", {principal[0]}, size});
  all.push_back({"gm_largest", "m", {principal[1]}, size});
}

/// Adds the restoring stiffness about the centre of mass; 3, 4 and 5 stand for heave, roll and
/// pitch.
void add_stiffness(const FloatingBody& body, const hydro::Flotation& f,
                   std::vector<Quantity>& all) {
  Eigen::Matrix3d c = hydro::restoring_stiffness(f.hydrostatics);
  c.bottomRightCorner<2, 2>() +=
      f.hydrostatics.volume *
      (f.effective_metacentric_heights() - hydro::metacentric_heights(f.hydrostatics));
  c *= body.density * body.gravity;
  const char* const units[] = {"N/m", "N", "N m"};
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j)
      all.push_back({fmt::format("c{}{}", i + 3, j + 3),
                     units[(i > 0) + (j > 0)],
                     {c(i, j)},
                     std::sqrt(std::abs(c(i, i) * c(j, j)))});
}

Json to_json(const std::vector<Quantity>& quantities) {
  Json json = Json::object();
  for (const Quantity& q : quantities)
    json[q.key] = q.values.size() == 1 ? Json(q.values[0]) : Json(q.values);
  return json;
}

Json state_json(const FloatingReport& report, const FloatingState& state,
                const Eigen::Quaterniond& orientation) {
  Json json = to_json(state_quantities(report.body, state, orientation));
  json["stability"] = word(state.stability);
  return json;
}

Json report_json(const FloatingReport& report) {
  Json json{{"floats", report.not_afloat.empty()}};
  json.update(to_json(body_quantities(report)));
  if (!report.not_afloat.empty()) {
    json["reason"] = report.not_afloat;
    return json;
  }
  json["start"] = state_json(report, report.start, report.body.start);
  json["rest"] = state_json(report, report.rest, report.orientation);
  if (report.natural_periods)
    json["natural_periods"] = natural_periods_json(*report.natural_periods);
  json["gz"] = Json::array();
  for (const hydro::RightingArm& arm : report.righting_arms) {
    Json row{{"heel_deg", arm.heel / kDegree},
             {"trim_deg", arm.trim / kDegree},
             {"draught", arm.draught},
             {"gz", arm.lever}};
    if (const auto freeboard = hydro::flooding_freeboard(report.intact_body(), arm))
      row["flooding_freeboard"] = *freeboard;
    json["gz"].push_back(row);
  }
  json["downflooding_deg"] = Json();
  if (report.intact.downflooding) json["downflooding_deg"] = *report.intact.downflooding / kDegree;
  json["imo_criteria"] = Json::array();
  for (const hydro::Criterion& c : report.intact.criteria)
    json["imo_criteria"].push_back({{"name", c.name},
                                    {"value", c.value},
                                    {"least", c.least},
                                    {"unit", c.unit},
                                    {"met", c.met()}});
  return json;
}

void write_rows(const std::string& body, const std::string& state,
                const std::vector<Quantity>& quantities, std::string& csv) {
  for (const Quantity& q : quantities)
    for (std::size_t i = 0; i < q.values.size(); ++i)
      csv += fmt::format("{},{},{}{},,{},{}\n", body, state, q.key,
                         q.values.size() > 1 ? fmt::format("[{}]", i) : "", q.values[i], q.unit);
}

void write_curve(const FloatingReport& report, std::string& csv) {
  for (const hydro::RightingArm& arm : report.righting_arms) {
    const double heel = arm.heel / kDegree;
    const std::string head = csv_field(report.body.name) + ",gz,";
    csv += fmt::format("{}gz,{},{},m\n", head, heel, arm.lever);
    csv += fmt::format("{}trim_deg,{},{},deg\n", head, heel, arm.trim / kDegree);
    csv += fmt::format("{}draught,{},{},m\n", head, heel, arm.draught);
    if (const auto freeboard = hydro::flooding_freeboard(report.intact_body(), arm))
      csv += fmt::format("{}flooding_freeboard,{},{},m\n", head, heel, *freeboard);
  }
}

void write_natural_periods(const FloatingReport& report, std::string& csv) {
  if (!report.natural_periods) return;
  for (const NaturalPeriod& mode : report.natural_periods->modes)
    csv += fmt::format("{},rest,natural_period_{},,{},s\n", csv_field(report.body.name),
                       mode.name("_"), mode.period);
}

void write_criteria(const FloatingReport& report, std::string& csv) {
  if (report.intact.downflooding)
    csv += fmt::format("{},imo,downflooding_deg,,{},deg\n", csv_field(report.body.name),
                       *report.intact.downflooding / kDegree);
  for (const hydro::Criterion& c : report.intact.criteria)
    csv += fmt::format("{},imo,{},,{},{}\n", csv_field(report.body.name), c.name, c.value, c.unit);
}

std::string shown(double value, double scale) {
  return fmt::format("{:.6g}", std::abs(value) <= kRoundOff * scale ? 0 : value);
}

std::string shown(const Quantity& q) {
  std::string text;
  for (const double value : q.values) text += (text.empty() ? "" : ", ") + shown(value, q.scale);
  return text;
}

/// Writes a line per quantity with its value in each column.
void write_lines(const std::vector<std::vector<Quantity>>& columns, std::string& table) {
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const Quantity& q = columns[0][i];
    table += fmt::format("  {:<28}{:<8}", q.key, q.unit);
    for (const auto& column : columns) table += fmt::format("{:<42}", shown(column[i]));
    table.erase(table.find_last_not_of(' ') + 1);
    table += '\n';
  }
}

void write_curve_table(const FloatingReport& report, std::string& table) {
  if (report.righting_arms.empty()) return;
  const bool may_flood = !report.body.flooding_points_B.empty();
  table += fmt::format("\n  {:>10}{:>14}{:>12}{:>12}{}\n", "heel [deg]", "GZ [m]", "trim [deg]",
                       "draught [m]", may_flood ? "  to flooding [m]" : "");
  for (const hydro::RightingArm& arm : report.righting_arms) {
    table += fmt::format("  {:>10}{:>14}{:>12}{:>12}", shown(arm.heel / kDegree, 1),
                         shown(arm.lever, arm.draught), shown(arm.trim / kDegree, 1),
                         shown(arm.draught, 1));
    if (const auto freeboard = hydro::flooding_freeboard(report.intact_body(), arm))
      table += *freeboard > 0 ? fmt::format("{:>17}", shown(*freeboard, 1))
                              : fmt::format("{:>17}", "floods");
    table += '\n';
  }
  if (!may_flood) return;
  table += report.intact.downflooding ? fmt::format("  downflooding at a heel of {} deg\n",
                                                    shown(*report.intact.downflooding / kDegree, 1))
                                      : std::string("  no downflooding up to a heel of 60 deg\n");
}

void write_criteria_table(const FloatingReport& report, std::string& table) {
  table += fmt::format("\n  {:<42}{:>10}  {:>12}\n", "IMO intact stability (2008 IS Code, A 2.2)",
                       "", "required");
  for (const hydro::Criterion& c : report.intact.criteria)
    table += fmt::format("  {:<42}{:>10.4g}  {:>12}  {:<6}{}\n", c.name, c.value,
                         fmt::format(">= {:g}", c.least), c.unit, c.met() ? "" : "NOT MET");
}

void write_table(const FloatingReport& report, std::string& table) {
  table += report.body.name + '\n';
  write_lines({body_quantities(report)}, table);
  if (!report.not_afloat.empty()) {
    table += fmt::format("  {}\n", report.not_afloat);
    return;
  }
  table += fmt::format("\n  {:<36}{:<42}{}\n", "", "as given: " + word(report.start.stability),
                       "at rest: " + word(report.rest.stability));
  write_lines({state_quantities(report.body, report.start, report.body.start),
               state_quantities(report.body, report.rest, report.orientation)},
              table);
  if (report.natural_periods) table += '\n' + natural_periods_text(*report.natural_periods);
  write_curve_table(report, table);
  write_criteria_table(report, table);
}

/// Explanation of the names in the table.
const char* const kLegend =
    "\ncom and centre_of_…: mesh frame. draught: depth of the lowest point; draught_from_keel: "
    "that "
    "of z = --keel\nof the mesh frame, under or over the centre of mass. Heights kb and kg: above "
    "the lowest point. heel_deg and trim_deg:\nroll and pitch of the mesh, +x end down positive. "
    "second_moment_…, bm_… and gm_…: "
    "t about the\nhorizontal axis along the mesh's x axis, l about the one across. c33…c55: "
    "restoring stiffness in heave,\nroll and pitch about the centre of mass, those axes. GZ: "
    "rights "
    "a positive heel if positive. Hollows count as\nclosed by lids: volume and water_inside are "
    "those "
    "of the outside and of the water in them. kg is that of body\nand water; gm_solid_t is without "
    "and gm_t with the loss by the water's free surface. 'to flooding' is the height of\nthe "
    "lowest "
    "sill or opening to the sea over the water.\n";

}  // namespace

std::vector<Quantity> body_quantities(const FloatingReport& report) {
  const FloatingBody& body = report.body;
  const double size = std::cbrt(report.volume);
  return {{"mass", "kg", {body.mass}},
          {"com", "m", list(body.com_M), size},
          {"volume", "m^3", {report.volume}, 0},
          {"water_density", "kg/m^3", {body.density}},
          {"gravity", "m/s^2", {body.gravity}},
          {"reserve_buoyancy", "1", {1 - body.displaced() / report.volume}},
          {"water_inside", "m^3", {body.water_inside()}}};
}

std::vector<Quantity> state_quantities(const FloatingBody& body, const FloatingState& state,
                                       const Eigen::Quaterniond& orientation) {
  const hydro::Flotation& f = state.flotation;
  const hydro::Hydrostatics& h = f.hydrostatics;
  const double size = f.draught;
  const Eigen::Vector3d angles = hydro::euler_angles(f.orientation);
  const auto in_mesh_frame = [&](const Eigen::Vector3d& p_G) {
    return list(f.orientation.inverse() * p_G + body.com_M);
  };
  const Eigen::Vector2d& flotation = h.waterplane.centroid;
  const Eigen::Quaterniond& q = orientation;
  std::vector<Quantity> all{
      {"quaternion", "1", {q.w(), q.x(), q.y(), q.z()}},
      {"heel_deg", "deg", {angles[0] / kDegree}, 60},
      {"trim_deg", "deg", {angles[1] / kDegree}, 60},
      {"com_height", "m", {f.height}, size},
      {"draught", "m", {f.draught}, size},
      {"displaced_volume", "m^3", {h.volume}, 0},
      {"centre_of_buoyancy", "m", in_mesh_frame(h.centre_of_buoyancy), size},
      {"wetted_surface", "m^2", {h.wetted_surface}, 0},
      {"waterplane_area", "m^2", {h.waterplane.area}, 0},
      {"centre_of_flotation", "m", in_mesh_frame({flotation.x(), flotation.y(), -f.height}), size}};
  if (body.keel_M) {
    // The keel's point on the line through the centre of mass along the mesh's z axis.
    const double above_com =
        f.orientation.toRotationMatrix()(2, 2) * (*body.keel_M - body.com_M.z());
    const auto draught = std::ranges::find(all, "draught", &Quantity::key);
    all.insert(draught + 1, {"draught_from_keel", "m", {-(f.height + above_com)}, size});
  }
  add_stability(f, all);
  add_stiffness(body, f, all);
  return all;
}

std::string floating_table(const std::vector<FloatingReport>& reports) {
  std::string table;
  for (const FloatingReport& report : reports) {
    if (!table.empty()) table += '\n';
    write_table(report, table);
  }
  return table + kLegend;
}

std::string floating_json(const std::vector<FloatingReport>& reports) {
  Json bodies = Json::object();
  for (const FloatingReport& report : reports) bodies[report.body.name] = report_json(report);
  return Json{{"bodies", bodies}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string floating_csv(const std::vector<FloatingReport>& reports) {
  std::string csv = "body,state,quantity,heel_deg,value,unit\n";
  for (const FloatingReport& report : reports) {
    const std::string name = csv_field(report.body.name);
    write_rows(name, "body", body_quantities(report), csv);
    if (!report.not_afloat.empty()) continue;
    write_rows(name, "start", state_quantities(report.body, report.start, report.body.start), csv);
    write_rows(name, "rest", state_quantities(report.body, report.rest, report.orientation), csv);
    write_natural_periods(report, csv);
    write_curve(report, csv);
    write_criteria(report, csv);
  }
  return csv;
}

}  // namespace app
