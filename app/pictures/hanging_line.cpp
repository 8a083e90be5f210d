#include "app/pictures/hanging_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace app {
namespace {

using Eigen::Vector3d;

constexpr double kNoGround = -std::numeric_limits<double>::infinity();

/// Points of a catenary of each of two kinds: at equal lengths, and at equal turns of its slope,
/// which lie close in a narrow bend.
constexpr int kPoints = 40;

/// Returns u > 0 with sinh(u)/u = ratio > 1.
double solve_sinh(double ratio) {
  // Both are above the root: sinh(u)/u exceeds 1 + u²/6, and exp(u)/(3u) beyond u = 2. The function
  // is convex, so that Newton's method goes down to the root.
  double u = ratio < 4 ? std::sqrt(6 * (ratio - 1)) : 2 * std::log(2 * ratio);
  for (int i = 0; i < 60; ++i) {
    const double step = (std::sinh(u) - ratio * u) / (std::cosh(u) - ratio);
    u -= step;
    if (!(step > 1e-14 * u)) break;
  }
  return u;
}

/// z of a triangle's plane above a place inside it; −∞ outside.
double height_on(const Vector3d& a, const Vector3d& b, const Vector3d& c, double x, double y) {
  const double area = (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
  if (area == 0) return kNoGround;
  const double v = ((x - a.x()) * (c - a).y() - (y - a.y()) * (c - a).x()) / area;
  const double w = ((b - a).x() * (y - a.y()) - (b - a).y() * (x - a.x())) / area;
  if (v < 0 || w < 0 || v + w > 1) return kNoGround;
  return a.z() + v * (b - a).z() + w * (c - a).z();
}

}  // namespace

Eigen::Matrix3Xd hanging_line(const Vector3d& from, const Vector3d& to, double length) {
  const Vector3d chord = to - from;
  if (!(length > (1 + 1e-9) * chord.norm())) {
    Eigen::Matrix3Xd ends(3, 2);
    ends << from, to;
    return ends;
  }
  // y = a cosh(x/a), with the length s = a sinh(x/a) and the slope s/a. The ends are h apart along
  // x and v along y, so that 2a sinh(h/2a) = √(L² − v²). Ends above each other are taken as a
  // little apart.
  const double v = chord.z(), level = chord.head<2>().norm(), h = std::max(level, 1e-9 * length);
  const double c = std::sqrt((length - v) * (length + v));
  const double u = solve_sinh(c / h), a = h / (2 * u), tilt = std::asinh(v / c);
  const double s1 = a * std::sinh(tilt - u), s2 = a * std::sinh(tilt + u);
  const double turn1 = std::atan(s1 / a), turn2 = std::atan(s2 / a);
  std::vector<double> lengths;
  for (int i = 1; i < kPoints; ++i) {
    const double part = static_cast<double>(i) / kPoints;
    lengths.push_back(s1 + part * (s2 - s1));
    lengths.push_back(a * std::tan(turn1 + part * (turn2 - turn1)));
  }
  std::sort(lengths.begin(), lengths.end());
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(lengths.size()) + 2);
  points.leftCols<1>() = from;
  points.rightCols<1>() = to;
  Vector3d ahead(chord.x(), chord.y(), 0);
  if (level > 0) ahead /= level;
  const double y1 = std::hypot(a, s1);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double s = std::clamp(lengths[i], s1, s2);
    const double x = a * std::asinh(s / a) - a * (tilt - u);
    const double z = (s - s1) * (s + s1) / (std::hypot(a, s) + y1);
    points.col(static_cast<Eigen::Index>(i) + 1) = from + x * ahead + z * Vector3d::UnitZ();
  }
  return points;
}

GroundHeight::GroundHeight(const engine::Ground& ground) : ground_(ground), highest_(kNoGround) {
  if (const auto* plane = std::get_if<engine::PlaneGround>(&ground)) highest_ = plane->z;
  if (const auto* mesh = std::get_if<engine::MeshGround>(&ground))
    highest_ = mesh->mesh_W.vertices.row(2).maxCoeff();
}

double GroundHeight::at(double x, double y) const {
  const auto* mesh = std::get_if<engine::MeshGround>(&ground_);
  if (!mesh) return highest_;
  double height = kNoGround;
  for (Eigen::Index f = 0; f < mesh->mesh_W.face_count(); ++f) {
    const auto corner = [&](int i) -> Vector3d {
      return mesh->mesh_W.vertices.col(mesh->mesh_W.faces(i, f));
    };
    height = std::max(height, height_on(corner(0), corner(1), corner(2), x, y));
  }
  return height;
}

void GroundHeight::lift(Eigen::Matrix3Xd& points_W, double clearance) const {
  for (auto point : points_W.colwise())
    if (point.z() < highest_ + clearance)
      point.z() = std::max(point.z(), at(point.x(), point.y()) + clearance);
}

}  // namespace app
