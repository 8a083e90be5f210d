#include "app/assembly/mesh_frame.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace assembly {
namespace {

using scene::UpAxis;

/// Returns the rotation that turns the axis upward. Its entries are 0 and ±1, so that it rounds
/// nothing.
Eigen::Matrix3d turn_up(UpAxis up) {
  Eigen::Matrix3d R;
  switch (up) {
    case UpAxis::z:
      return Eigen::Matrix3d::Identity();
    case UpAxis::y:
      R << 1, 0, 0, 0, 0, -1, 0, 1, 0;
      return R;
    case UpAxis::minus_y:
      R << 1, 0, 0, 0, 0, 1, 0, -1, 0;
      return R;
    case UpAxis::x:
      R << 0, 0, -1, 0, 1, 0, 1, 0, 0;
      return R;
    case UpAxis::minus_x:
      R << 0, 0, 1, 0, 1, 0, -1, 0, 0;
      return R;
    case UpAxis::minus_z:
      R << 1, 0, 0, 0, -1, 0, 0, 0, -1;
      return R;
  }
  throw std::logic_error("unknown axis");
}

}  // namespace

AppliedFrame applied_frame(const StatedFrame& stated, const scene::MeshFrame& wanted) {
  AppliedFrame frame{.scale = wanted.scale};
  if (stated.up || wanted.up) {
    frame.up = wanted.up ? *wanted.up : *stated.up;
    frame.up_by = wanted.up ? SaidBy::author : SaidBy::file;
  }
  if (stated.unit || wanted.unit) {
    frame.unit = wanted.unit ? *wanted.unit : *stated.unit;
    frame.unit_by = wanted.unit ? SaidBy::author : SaidBy::file;
  }
  return frame;
}

hydro::TriMesh in_mesh_frame(hydro::TriMesh mesh, const AppliedFrame& frame) {
  const double factor = frame.unit * frame.scale;
  if (frame.up != UpAxis::z) mesh.vertices = turn_up(frame.up) * mesh.vertices;
  if (factor != 1) mesh.vertices *= factor;
  return mesh;
}

std::string description(const AppliedFrame& frame) {
  const auto said = [](SaidBy who) { return who == SaidBy::file ? ", as it says" : ""; };
  std::string text =
      fmt::format("{} is up in the file{}; its unit is {}{}", scene::name_of(frame.up),
                  said(frame.up_by), scene::name_of_unit(frame.unit), said(frame.unit_by));
  if (frame.scale != 1) text += fmt::format(", scaled by {:g}", frame.scale);
  return text;
}

std::string size_warning(const hydro::TriMesh& mesh, const MeshSource& source,
                         const std::string& setting) {
  constexpr double kLongest = 500;  // [m]; the longest ship so far had 458 m.
  const double length = hydro::bounding_box(mesh).sizes().maxCoeff();
  const AppliedFrame& frame = source.frame;
  if (frame.unit_by == SaidBy::author || frame.scale != 1 || !(length > kLongest)) return "";
  const std::string file = source.file.filename().string();
  const std::string as_read =
      frame.unit_by == SaidBy::file
          ? fmt::format("in the unit that it states, {}", scene::name_of_unit(frame.unit))
          : std::string("if its unit is the metre, and it names none");
  return fmt::format(
      "{} is {:.4g} m long {}; with '{}mm' it is {:.4g} m, and '{}m' confirms metres", file, length,
      as_read, setting, length / frame.unit * 1e-3, setting);
}

std::string density_warning(double mass, double volume, const MeshSource& source) {
  // Hydrogen has 0.08 kg/m^3, osmium 22,600 kg/m^3.
  constexpr double kLeast = 0.01, kMost = 1e5;
  const double density = mass / volume;
  if (density > kLeast && density < kMost) return "";
  const bool light = density <= kLeast;
  return fmt::format(
      "its mass of {:.4g} kg in the {:.4g} m^3 of {} makes {:.3g} kg/m^3, {}: is the file in {}? "
      "'unit: {}' says so",
      mass, volume, source.file.filename().string(), density,
      light ? "less than any gas has" : "more than any metal has", light ? "millimetres" : "metres",
      light ? "mm" : "m");
}

}  // namespace assembly
