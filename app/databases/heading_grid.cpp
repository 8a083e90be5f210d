#include "app/databases/heading_grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/decompositions.h"
#include "hydro/mesh/mirror_symmetry.h"

namespace databases {
namespace {

using Eigen::Index;
using hydro::Loads6cd;
using hydro::Vector6d;
using std::numbers::pi;

constexpr double kSameHeading = 1e-6;                 ///< [rad]
constexpr double kLargestGap = 45 * pi / 180 + 1e-6;  ///< [rad]
constexpr double kFineGap = 7.5 * pi / 180;           ///< Below it 72 headings are made, not 36.
constexpr double kMirrorTolerance = 1e-3;             ///< Over the mesh's size [-].
constexpr double kForbidden = 1e-2;                   ///< Over the diagonal's geometric mean [-].
constexpr double kRevolution = 0.1;                   ///< Mean sine of the normals' deviation [-].

Vector6d mirror_signs(int axis) {
  Vector6d signs;
  if (axis == 0)
    signs << -1, 1, 1, 1, -1, -1;
  else
    signs << 1, -1, 1, -1, 1, -1;
  return signs;
}

/// True if the couplings vanish that a mirror in the plane normal to the axis forbids.
bool lacks_forbidden(const std::vector<hydro::Matrix6d>& matrices, int axis) {
  const Vector6d signs = mirror_signs(axis);
  for (const hydro::Matrix6d& matrix : matrices)
    for (Index i = 0; i < 6; ++i)
      for (Index j = 0; j < 6; ++j)
        if (signs[i] * signs[j] < 0 &&
            std::abs(matrix(i, j)) > kForbidden * std::sqrt(std::abs(matrix(i, i) * matrix(j, j))))
          return false;
  return !matrices.empty();
}

bool of_revolution(const hydro::TriMesh& mesh_H) {
  double across = 0, area = 0;
  for (Index f = 0; f < mesh_H.face_count(); ++f) {
    const Eigen::Vector3d a = mesh_H.vertices.col(mesh_H.faces(0, f)),
                          b = mesh_H.vertices.col(mesh_H.faces(1, f)),
                          c = mesh_H.vertices.col(mesh_H.faces(2, f));
    const Eigen::Vector3d flux = 0.5 * (b - a).cross(c - a), at = (a + b + c) / 3;
    const double radius = at.head<2>().norm();
    if (radius > 0) across += std::abs(at.x() * flux.y() - at.y() * flux.x()) / radius;
    area += flux.head<2>().norm();
  }
  return area > 0 && across < kRevolution * area;
}

double wrapped(double heading) {
  const double in_turn = heading - 2 * pi * std::floor(heading / (2 * pi));
  return in_turn > 2 * pi - kSameHeading ? 0 : in_turn;
}

/// A heading of the given ones, or the image of one.
struct Source {
  double heading = 0;  ///< In [0, 2π).
  Index column = 0;    ///< Column of the given loads.
  Vector6d signs = Vector6d::Ones();
};

bool has(const std::vector<Source>& sources, double heading) {
  return std::any_of(sources.begin(), sources.end(), [&](const Source& s) {
    const double apart = std::abs(std::remainder(s.heading - heading, 2 * pi));
    return apart < kSameHeading;
  });
}

void add_images(std::vector<Source>& sources, int axis) {
  for (std::size_t i = 0, count = sources.size(); i < count; ++i) {
    const double image = wrapped(axis == 0 ? pi - sources[i].heading : -sources[i].heading);
    if (!has(sources, image))
      sources.push_back(
          {image, sources[i].column, sources[i].signs.cwiseProduct(mirror_signs(axis))});
  }
}

double largest_gap(const std::vector<Source>& sources) {
  double gap = sources.front().heading + 2 * pi - sources.back().heading;
  for (std::size_t i = 1; i < sources.size(); ++i)
    gap = std::max(gap, sources[i].heading - sources[i - 1].heading);
  return gap;
}

bool is_even(const std::vector<Source>& sources) {
  const auto count = static_cast<double>(sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (std::abs(sources[i].heading - 2 * pi * static_cast<double>(i) / count) > kSameHeading)
      return false;
  return true;
}

std::vector<double> even_headings(std::size_t count) {
  std::vector<double> headings;
  for (std::size_t i = 0; i < count; ++i)
    headings.push_back(2 * pi * static_cast<double>(i) / static_cast<double>(count));
  return headings;
}

Loads6cd at_sources(const Loads6cd& loads, const std::vector<Source>& sources) {
  Loads6cd all(6, static_cast<Index>(sources.size()));
  for (std::size_t i = 0; i < sources.size(); ++i)
    all.col(static_cast<Index>(i)) = sources[i].signs.asDiagonal() * loads.col(sources[i].column);
  return all;
}

/// Weights of the values at nodes on a circle in their periodic cubic spline at other headings: a
/// column for each of these.
Eigen::MatrixXd spline_weights(const std::vector<Source>& nodes,
                               const std::vector<double>& headings) {
  const auto n = static_cast<Index>(nodes.size());
  const auto at = [&](Index i) { return nodes[static_cast<std::size_t>(i)].heading; };
  const auto width = [&](Index i) {
    return i + 1 < n ? at(i + 1) - at(i) : at(0) + 2 * pi - at(i);
  };
  // The second derivatives m solve slopes_equal · m = jumps · values.
  Eigen::MatrixXd slopes_equal = Eigen::MatrixXd::Zero(n, n), jumps = Eigen::MatrixXd::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    const Index before = (i + n - 1) % n, after = (i + 1) % n;
    const double left = width(before), right = width(i);
    slopes_equal(i, before) += left / 6;
    slopes_equal(i, i) += (left + right) / 3;
    slopes_equal(i, after) += right / 6;
    jumps(i, before) += 1 / left;
    jumps(i, i) -= 1 / left + 1 / right;
    jumps(i, after) += 1 / right;
  }
  const Eigen::MatrixXd second = hydro::solve_dense(slopes_equal, jumps);
  Eigen::MatrixXd weights(n, static_cast<Index>(headings.size()));
  for (Index h = 0; h < weights.cols(); ++h) {
    double heading = headings[static_cast<std::size_t>(h)];
    if (heading < at(0)) heading += 2 * pi;
    Index i = n - 1;
    while (i > 0 && at(i) > heading) --i;
    const double w = width(i), t = (heading - at(i)) / w, s = 1 - t;
    const Index after = (i + 1) % n;
    Eigen::RowVectorXd row =
        w * w / 6 * ((s * s * s - s) * second.row(i) + (t * t * t - t) * second.row(after));
    row[i] += s;
    row[after] += t;
    weights.col(h) = row.transpose();
  }
  return weights;
}

Loads6cd turned_about_axis(const Loads6cd& loads, double heading,
                           const std::vector<double>& headings) {
  Loads6cd all(6, static_cast<Index>(headings.size()));
  for (std::size_t h = 0; h < headings.size(); ++h) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(headings[h] - heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    all.col(static_cast<Index>(h)) << turn * loads.col(0).head<3>(), turn * loads.col(0).tail<3>();
  }
  return all;
}

}  // namespace

BodySymmetry symmetry_of(const hydro::TriMesh& mesh_B, const hydro::MeanPose& pose,
                         const std::vector<hydro::Matrix6d>& matrices) {
  const hydro::TriMesh mesh_H = hydro::transformed(mesh_B, Eigen::Isometry3d(pose.orientation));
  const double tolerance = kMirrorTolerance * mesh_H.vertices.cwiseAbs().maxCoeff();
  return {
      .left_right =
          hydro::is_mirror_symmetric(mesh_H, 1, tolerance) || lacks_forbidden(matrices, 1),
      .fore_aft = hydro::is_mirror_symmetric(mesh_H, 0, tolerance) || lacks_forbidden(matrices, 0),
      .revolution = of_revolution(mesh_H)};
}

void take_forbidden_out(const BodySymmetry& symmetry, hydro::Matrix6d& matrix) {
  for (const int axis : {0, 1}) {
    if (!(axis == 0 ? symmetry.fore_aft : symmetry.left_right)) continue;
    const Vector6d signs = mirror_signs(axis);
    matrix = (signs * signs.transpose()).cwiseMax(0).cwiseProduct(matrix).eval();
  }
}

std::string complete_circle(const BodySymmetry& symmetry, std::vector<LoadTable*> tables) {
  std::vector<Source> sources;
  const std::vector<double> given = tables.front()->headings;
  for (std::size_t i = 0; i < given.size(); ++i)
    if (!has(sources, wrapped(given[i])))
      sources.push_back({wrapped(given[i]), static_cast<Index>(i)});
  const std::size_t distinct = sources.size();
  const auto sort = [&] {
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return a.heading < b.heading; });
  };
  sort();
  std::string mirrored;
  if (largest_gap(sources) > kLargestGap) {
    if (symmetry.left_right) add_images(sources, 1);
    if (symmetry.fore_aft) add_images(sources, 0);
    sort();
    if (sources.size() > distinct) mirrored = " and their mirror images";
  }
  const double gap = largest_gap(sources);
  const auto set = [&](const std::vector<double>& headings, const auto& loads_of) {
    for (LoadTable* table : tables) {
      for (Loads6cd& loads : table->loads) loads = Loads6cd(loads_of(loads));
      table->headings = headings;
    }
  };
  if (gap > kLargestGap && symmetry.revolution) {
    const std::vector<double> headings = even_headings(36);
    set(headings,
        [&](const Loads6cd& loads) { return turned_about_axis(loads, given.front(), headings); });
    return fmt::format(
        "loads of waves: those of the heading {:g}°, turned about the axis of "
        "revolution",
        given.front() * 180 / pi);
  }
  if (gap > kLargestGap)
    throw std::invalid_argument(
        fmt::format("has {} headings{} with {:.3g}° between two of them, and the body may turn to "
                    "all; expected at most 45°",
                    distinct, mirrored, gap * 180 / pi));
  if (is_even(sources)) {
    set(even_headings(sources.size()),
        [&](const Loads6cd& loads) { return at_sources(loads, sources); });
    return mirrored.empty() ? "" : fmt::format("loads of waves: {} headings{}", distinct, mirrored);
  }
  const std::vector<double> headings =
      even_headings(2 * pi / static_cast<double>(sources.size()) < kFineGap ? 72 : 36);
  const Eigen::MatrixXd weights = spline_weights(sources, headings);
  set(headings, [&](const Loads6cd& loads) {
    return Loads6cd(at_sources(loads, sources) * weights.cast<std::complex<double>>());
  });
  return fmt::format("loads of waves: by splines through {} headings{}", distinct, mirrored);
}

}  // namespace databases
