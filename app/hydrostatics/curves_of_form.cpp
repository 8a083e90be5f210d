#include "app/hydrostatics/curves_of_form.h"

#include <cmath>

#include "hydro/mesh/mesh_section.h"

namespace app {
namespace {

constexpr double kTonne = 1000;       ///< [kg]
constexpr double kCentimetre = 0.01;  ///< [m]

/// The box around closed curves.
Eigen::AlignedBox2d box_around(const std::vector<hydro::SectionLoop>& loops) {
  Eigen::AlignedBox2d box;
  for (const hydro::SectionLoop& loop : loops)
    for (const auto& point : loop.colwise()) box.extend(Eigen::Vector2d(point));
  return box;
}

/// The part of a loop whose second coordinate is negative, closed along zero.
hydro::SectionLoop below_zero(const hydro::SectionLoop& loop) {
  std::vector<Eigen::Vector2d> points;
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Eigen::Vector2d p = loop.col(i), q = loop.col((i + 1) % loop.cols());
    points.emplace_back(p.x(), std::min(p.y(), 0.0));
    if (p.y() * q.y() < 0)
      points.emplace_back(p.x() + (q.x() - p.x()) * p.y() / (p.y() - q.y()), 0);
  }
  hydro::SectionLoop below(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    below.col(static_cast<Eigen::Index>(i)) = points[i];
  return below;
}

/// Immersed area of the section across the waterline at x [m^2].
double section_area(const hydro::TriMesh& mesh_W, double x) {
  double area = 0;
  for (const hydro::SectionLoop& loop : hydro::mesh_section(mesh_W, 0, x))
    area += hydro::enclosed_area(below_zero(loop));
  return area;
}

/// Adds the length and breadth of the waterline, and the coefficients by them and the draught.
void add_coefficients(const hydro::TriMesh& mesh_W, const hydro::Hydrostatics& h, double draught,
                      FormRow& row) {
  const Eigen::AlignedBox2d box = box_around(hydro::mesh_section(mesh_W, 2, 0));
  const double L = box.sizes().x(), B = box.sizes().y();
  const double midship = section_area(mesh_W, box.center().x());
  row.push_back({"length", "m", {L}});
  row.push_back({"breadth", "m", {B}});
  row.push_back({"midship_area", "m^2", {midship}});
  row.push_back({"cb", "1", {h.volume / (L * B * draught)}});
  row.push_back({"cw", "1", {h.waterplane.area / (L * B)}});
  row.push_back({"cm", "1", {midship / (B * draught)}});
  row.push_back({"cp", "1", {h.volume / (L * midship)}});
}

/// The upright body as the curves take it. Frame U has the axes and the origin of the mesh frame of
/// the upright body.
struct Upright {
  explicit Upright(const FloatingBody& body)
      : mesh_U(hydro::translated(body.mesh_B, body.com_M)),
        box(hydro::bounding_box(mesh_U)),
        keel(body.keel_M.value_or(box.min().z())) {}

  hydro::TriMesh mesh_U;
  Eigen::AlignedBox3d box;
  double keel;  ///< Height of the keel [m].
};

/// The quantities at a draught; none where the waterline misses the body.
FormRow row_at(const Upright& body, double draught, double trim, double density) {
  const Eigen::Vector3d amidships(body.box.center().x(), 0, body.keel + draught);
  const Eigen::AngleAxisd R_WU(trim, Eigen::Vector3d::UnitY());
  Eigen::Isometry3d X_WU = Eigen::Isometry3d(R_WU) * Eigen::Translation3d(-amidships);
  const hydro::TriMesh mesh_W = hydro::transformed(body.mesh_U, X_WU);
  const hydro::Hydrostatics h = hydro::hydrostatics(mesh_W, 0);
  if (!(h.volume > 0 && h.waterplane.area > 0)) return {};
  const Eigen::Vector2d& flotation = h.waterplane.centroid;
  const Eigen::Vector3d B_U = X_WU.inverse() * h.centre_of_buoyancy;
  const Eigen::Vector3d F_U = X_WU.inverse() * Eigen::Vector3d(flotation.x(), flotation.y(), 0);
  const double mass = density * h.volume, kb = B_U.z() - body.keel;
  const double bm_t = h.waterplane.second_moment(1, 1) / h.volume;
  const double bm_l = h.waterplane.second_moment(0, 0) / h.volume;
  FormRow row = {{"draught", "m", {draught}},
                 {"volume", "m^3", {h.volume}},
                 {"displacement", "kg", {mass}},
                 {"kb", "m", {kb}, draught},
                 {"bm_t", "m", {bm_t}},
                 {"km_t", "m", {kb + bm_t}},
                 {"bm_l", "m", {bm_l}},
                 {"km_l", "m", {kb + bm_l}},
                 {"waterplane_area", "m^2", {h.waterplane.area}},
                 {"wetted_surface", "m^2", {h.wetted_surface}},
                 {"lcb", "m", {B_U.x()}, body.box.sizes().x()},
                 {"lcf", "m", {F_U.x()}, body.box.sizes().x()},
                 {"tpc", "t/cm", {density * h.waterplane.area * kCentimetre / kTonne}}};
  add_coefficients(mesh_W, h, draught, row);
  const double length = std::ranges::find(row, "length", &Quantity::key)->values[0];
  const auto after_tpc = std::ranges::find(row, "tpc", &Quantity::key) + 1;
  row.insert(after_tpc, {"mct", "t m/cm", {mass * bm_l / length * kCentimetre / kTonne}});
  return row;
}

/// KN of the upright body at the displacement of a draught.
CrossCurve cross_curve(const Upright& body, const FormRow& row, const std::vector<double>& heels) {
  const auto value = [&](const char* key) {
    return std::ranges::find(row, key, &Quantity::key)->values[0];
  };
  const Eigen::Vector3d keel_U(value("lcb"), body.box.center().y(), body.keel);
  return {.draught = value("draught"),
          .displacement = value("displacement"),
          .arms = hydro::righting_arms(hydro::translated(body.mesh_U, -keel_U), value("volume"),
                                       heels)};
}

}  // namespace

CurvesOfForm curves_of_form(const FloatingBody& floating, const std::vector<double>& draughts,
                            double trim, const std::vector<double>& heels) {
  const Upright body(floating);
  CurvesOfForm curves{.body = floating.name,
                      .trim = trim,
                      .density = floating.density,
                      .least = body.box.min().z() - body.keel,
                      .most = body.box.max().z() - body.keel,
                      .rows = {},
                      .cross_curves = {}};
  for (const double draught : draughts) {
    if (!(draught > std::max(0.0, curves.least) && draught < curves.most)) continue;
    FormRow row = row_at(body, draught, trim, floating.density);
    if (row.empty()) continue;
    if (!heels.empty()) curves.cross_curves.push_back(cross_curve(body, row, heels));
    curves.rows.push_back(std::move(row));
  }
  return curves;
}

}  // namespace app
