#include "app/render/part_meshes.h"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>

#include "hydro/decompositions.h"
#include "hydro/mesh/mesh_union.h"

namespace render {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Points of a helix in a turn.
constexpr int kTurnPoints = 16;

/// Radius of a hub over that of its propeller.
constexpr double kHub = 0.18;

/// A closed surface of rings of `around` vertices each, one after the other, with a flat fan over
/// the first and the last.
hydro::TriMesh ringed(Eigen::Matrix3Xd rings, int around) {
  const int count = static_cast<int>(rings.cols()) / around;
  hydro::TriMesh mesh{std::move(rings), {}};
  mesh.faces.resize(3, 2 * around * (count - 1) + 2 * (around - 2));
  Index f = 0;
  for (int i = 0; i + 1 < count; ++i)
    for (int j = 0; j < around; ++j) {
      const int a = i * around + j, b = i * around + (j + 1) % around;
      mesh.faces.col(f++) = Eigen::Vector3i(a, b, a + around);
      mesh.faces.col(f++) = Eigen::Vector3i(b, b + around, a + around);
    }
  const int last = (count - 1) * around;
  for (int j = 1; j + 1 < around; ++j) {
    mesh.faces.col(f++) = Eigen::Vector3i(0, j + 1, j);
    mesh.faces.col(f++) = Eigen::Vector3i(last, last + j, last + j + 1);
  }
  return mesh;
}

/// Returns the points without those at the place of the one before them, and their radii as a
/// fourth row.
Eigen::Matrix4Xd distinct(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& radii) {
  Eigen::Matrix4Xd kept(4, points.cols());
  Index count = 0;
  for (Index i = 0; i < points.cols(); ++i)
    if (count == 0 || points.col(i) != kept.col(count - 1).head<3>())
      kept.col(count++) << points.col(i), radii[i];
  return kept.leftCols(count);
}

/// A unit vector normal to another.
Vector3d normal_to(const Vector3d& v) { return v.unitOrthogonal(); }

/// The unit vector normal to a unit one that is nearest to `toward`; any if there is none.
Vector3d normal_toward(const Vector3d& along, const Vector3d& toward) {
  const Vector3d across = toward - along.dot(toward) * along;
  return across.norm() > 1e-9 * toward.norm() ? Vector3d(across.normalized()) : normal_to(along);
}

/// A point of the outline of a symmetric section from its leading edge, x = 0, to the trailing
/// edge, x = 1, and back: the form of the NACA sections of four digits.
Eigen::Vector2d section_point(int index, int count, double thickness) {
  const double angle = 2 * M_PI * index / count, x = 0.5 * (1 - std::cos(angle));
  const double half = 5 * thickness *
                      (0.2969 * std::sqrt(x) - 0.1260 * x - 0.3516 * x * x +
                       0.2843 * std::pow(x, 3) - 0.1036 * std::pow(x, 4));
  return {x, std::sin(angle) >= 0 ? half : -half};
}

/// A blade that points along +z, of a right-handed screw of radius 1.
hydro::TriMesh blade_mesh(double widest, double pitch_ratio) {
  constexpr int kRings = 12, kAround = 16;
  Eigen::Matrix3Xd points(3, kRings * kAround);
  for (int i = 0; i < kRings; ++i) {
    const double part = static_cast<double>(i) / (kRings - 1);
    const double r = 0.8 * kHub + (1 - 0.8 * kHub) * part;
    // The blade is widest at two thirds of the radius and round at its tip.
    const double chord =
        std::max(0.06, widest * (0.62 + 0.55 * part) * std::sqrt(1 - std::pow(part, 6)));
    const double slope = std::atan2(2 * pitch_ratio, 2 * M_PI * r);
    const double thickness = 0.22 - 0.17 * part;
    for (int j = 0; j < kAround; ++j) {
      const Eigen::Vector2d s = section_point(j, kAround, thickness);
      const double along = chord * (0.5 - s.x()), off = chord * s.y();
      const double x = along * std::sin(slope) + off * std::cos(slope);
      const double arc = along * std::cos(slope) - off * std::sin(slope);
      // A positive turn about x moves a blade that points along z toward −y.
      points.col(i * kAround + j) << x, -r * std::sin(arc / r), r * std::cos(arc / r);
    }
  }
  return ringed(std::move(points), kAround);
}

hydro::TriMesh hub_mesh() {
  Eigen::Matrix3Xd axis(3, 7);
  axis << 0.3, 0.22, 0.1, -0.12, -0.2, -0.26, -0.28, Eigen::Matrix<double, 2, 7>::Zero();
  Eigen::VectorXd radii(7);
  radii << kHub, kHub, kHub, 0.92 * kHub, 0.75 * kHub, 0.4 * kHub, 0.05 * kHub;
  return tube_mesh(axis, radii);
}

}  // namespace

hydro::TriMesh tube_mesh(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& radii,
                         const Vector3d& toward) {
  const Eigen::Matrix4Xd kept = distinct(points, radii);
  const Index count = kept.cols();
  if (count < 2) return {};
  Eigen::Matrix3Xd rings(3, count * kTubeSides);
  Vector3d side = Vector3d::Zero(), before = Vector3d::Zero();
  for (Index i = 0; i < count; ++i) {
    const Vector3d in = (kept.col(i) - kept.col(std::max<Index>(i - 1, 0))).head<3>();
    const Vector3d out = (kept.col(std::min(i + 1, count - 1)) - kept.col(i)).head<3>();
    Vector3d along = in.normalized() + out.normalized();
    if (along.norm() < 1e-6) along = in;  // The line turns back.
    along.normalize();
    // The ring is turned with the line, so that the tube does not twist.
    side = i == 0 ? normal_toward(along, toward)
                  : Vector3d(hydro::shortest_turn(before, along) * side);
    before = along;
    const Vector3d other = along.cross(side);
    for (int j = 0; j < kTubeSides; ++j) {
      const double angle = 2 * M_PI * j / kTubeSides;
      rings.col(i * kTubeSides + j) =
          kept.col(i).head<3>() + kept(3, i) * (std::cos(angle) * side + std::sin(angle) * other);
    }
  }
  return ringed(std::move(rings), kTubeSides);
}

hydro::TriMesh tube_mesh(const Eigen::Matrix3Xd& points, double radius) {
  return tube_mesh(points, Eigen::VectorXd::Constant(points.cols(), radius));
}

Eigen::Matrix3Xd helix(const Vector3d& from, const Vector3d& to, double radius, int turns) {
  constexpr double kEnd = 0.1;
  const Vector3d whole = to - from;
  const Vector3d along = whole.norm() > 0 ? Vector3d(whole.normalized()) : Vector3d::UnitZ();
  const Vector3d side = normal_to(along), other = along.cross(side);
  const int steps = turns * kTurnPoints;
  Eigen::Matrix3Xd points(3, steps + 5);
  points.col(0) = from;
  points.col(1) = from + kEnd * whole;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps, angle = 2 * M_PI * turns * part;
    points.col(i + 2) = from + (kEnd + (1 - 2 * kEnd) * part) * whole +
                        radius * (std::cos(angle) * side + std::sin(angle) * other);
  }
  points.col(steps + 3) = to - kEnd * whole;
  points.col(steps + 4) = to;
  return points;
}

hydro::TriMesh screw_mesh(const ScrewShape& shape) {
  // About two thirds of the disc's radius is blade, of nearly the widest chord.
  const double widest = shape.area_ratio * M_PI / shape.blades / 0.78;
  const hydro::TriMesh blade = blade_mesh(widest, shape.pitch_ratio);
  std::vector<hydro::TriMesh> solids = {hub_mesh()};
  for (int i = 0; i < shape.blades; ++i)
    solids.push_back(hydro::transformed(
        blade,
        Eigen::Isometry3d(Eigen::AngleAxisd(2 * M_PI * i / shape.blades, Vector3d::UnitX()))));
  hydro::TriMesh mesh = hydro::scaled(hydro::side_by_side(solids), shape.diameter / 2);
  if (shape.right_handed) return mesh;
  mesh.vertices.row(1) *= -1;
  return hydro::flipped(std::move(mesh));
}

hydro::TriMesh wing_mesh(double span, double chord, double thickness) {
  constexpr int kAround = 24;
  Eigen::Matrix3Xd points(3, 2 * kAround);
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < kAround; ++j) {
      const Eigen::Vector2d s = section_point(j, kAround, thickness);
      points.col(i * kAround + j) << chord * (0.25 - s.x()), chord * s.y(), (i - 0.5) * span;
    }
  return ringed(std::move(points), kAround);
}

hydro::TriMesh anchor_mesh(double size) {
  const auto bar = [](std::initializer_list<Vector3d> corners,
                      std::initializer_list<double> radii) {
    Eigen::Matrix3Xd points(3, static_cast<Index>(corners.size()));
    Eigen::VectorXd widths(points.cols());
    Index i = 0;
    for (const Vector3d& corner : corners) points.col(i++) = corner;
    i = 0;
    for (const double radius : radii) widths[i++] = radius;
    return tube_mesh(points, widths);
  };
  std::vector<hydro::TriMesh> solids = {bar({{0, 0, 0}, {-1, 0, 0}}, {0.035, 0.06}),
                                        bar({{-0.12, -0.42, 0}, {-0.12, 0.42, 0}}, {0.035, 0.035})};
  Eigen::Matrix3Xd ring(3, 17);
  for (Index i = 0; i < ring.cols(); ++i) {
    const double angle = 2 * M_PI * static_cast<double>(i) / 16;
    ring.col(i) << 0.07 * std::cos(angle) + 0.05, 0, 0.07 * std::sin(angle);
  }
  solids.push_back(tube_mesh(ring, 0.022));
  for (const double up : {1.0, -1.0}) {
    solids.push_back(
        bar({{-1.02, 0, 0}, {-1, 0, 0.16 * up}, {-0.92, 0, 0.32 * up}, {-0.76, 0, 0.46 * up}},
            {0.065, 0.06, 0.05, 0.04}));
    // The fluke is a broad spade with its point ahead.
    hydro::TriMesh fluke = bar(
        {{-0.92, 0, 0.36 * up}, {-0.84, 0, 0.44 * up}, {-0.62, 0, 0.56 * up}}, {0.05, 0.09, 0.005});
    fluke.vertices.row(1) *= 1.5;
    solids.push_back(std::move(fluke));
  }
  return hydro::scaled(hydro::side_by_side(solids), size);
}

}  // namespace render
