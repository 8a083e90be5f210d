#include "hydro/loads/drag_calibration.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "hydro/loads/coefficients.h"

namespace hydro {
namespace {

constexpr int kScanLines = 4096;

struct Interval {
  double from, to;
};

/// Interval in which a scan line at height `y` crosses the triangle, in plane coordinates.
Interval crossing(const std::array<Eigen::Vector2d, 3>& triangle, double y) {
  Interval cut{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d& a = triangle[i];
    const Eigen::Vector2d& b = triangle[(i + 1) % 3];
    if ((a.y() <= y) == (b.y() <= y)) continue;
    const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    cut.from = std::min(cut.from, x);
    cut.to = std::max(cut.to, x);
  }
  return cut;
}

double union_length(std::vector<Interval>& intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.from < b.from; });
  double length = 0;
  double reached = -std::numeric_limits<double>::infinity();
  for (const Interval& i : intervals) {
    length += std::max(0.0, i.to - std::max(i.from, reached));
    reached = std::max(reached, i.to);
  }
  return length;
}

/// Drag along an axis at unit speed over ½ρ: the mean of both directions [m^2].
double panel_drag(const TriMesh& mesh, const PressureDrag& drag, int axis) {
  double sum = 0;
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    const Eigen::Vector3d a = area_vector(mesh, face);
    const double area = a.norm();
    if (area > 0) sum += std::abs(a[axis] * a[axis] * a[axis]) / (area * area);
  }
  return 0.5 * (drag.front + drag.back) * sum;
}

/// Coefficients of ν in e_axis · (v + ω × r).
Vector6d row(int axis, const Eigen::Vector3d& r) {
  const Eigen::Vector3d e = Eigen::Vector3d::Unit(axis);
  Vector6d J;
  J << e, r.cross(e);
  return J;
}

/// The matrix of q_axis: edge midpoints integrate a quadratic exactly.
Matrix6d motion_matrix(const TriMesh& mesh, int axis) {
  Matrix6d sum = Matrix6d::Zero();
  double total = 0;
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    const double area = area_vector(mesh, face).norm();
    total += area;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d middle = 0.5 * (mesh.vertices.col(mesh.faces(i, face)) +
                                            mesh.vertices.col(mesh.faces((i + 1) % 3, face)));
      const Vector6d J = row(axis, middle);
      sum += area / 3 * J * J.transpose();
    }
  }
  return sum / total;
}

}  // namespace

double frontal_area(const TriMesh& mesh, int axis) {
  const int x = (axis + 1) % 3;
  const int y = (axis + 2) % 3;
  const double low = mesh.vertices.row(y).minCoeff();
  const double spacing = (mesh.vertices.row(y).maxCoeff() - low) / kScanLines;
  if (!(spacing > 0)) return 0;
  std::vector<std::vector<Interval>> lines(kScanLines);
  for (Eigen::Index face = 0; face < mesh.face_count(); ++face) {
    std::array<Eigen::Vector2d, 3> triangle;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d p = mesh.vertices.col(mesh.faces(i, face));
      triangle[i] = {p[x], (p[y] - low) / spacing - 0.5};  // scan line i is at y = i
    }
    const auto [least, most] = std::minmax({triangle[0].y(), triangle[1].y(), triangle[2].y()});
    const int last = std::min(kScanLines - 1, static_cast<int>(std::floor(most)));
    for (int i = std::max(0, static_cast<int>(std::ceil(least))); i <= last; ++i) {
      const Interval cut = crossing(triangle, i);
      if (cut.from < cut.to) lines[i].push_back(cut);
    }
  }
  double area = 0;
  for (std::vector<Interval>& line : lines) area += spacing * union_length(line);
  return area;
}

DragCalibration calibrate_drag(const TriMesh& mesh_B, const PressureDrag& drag,
                               const Eigen::Vector3d& tabulated) {
  DragCalibration calibration;
  for (int axis = 0; axis < 3; ++axis) {
    const double panels = panel_drag(mesh_B, drag, axis);
    if (!(panels > 0))
      throw std::invalid_argument("there is no pressure drag along axis " +
                                  std::string(1, static_cast<char>('x' + axis)) + " to scale");
    calibration.factor[axis] = tabulated[axis] * frontal_area(mesh_B, axis) / panels;
    calibration.motion[axis] = motion_matrix(mesh_B, axis);
  }
  return calibration;
}

double drag_factor(const DragCalibration& calibration, const Twist& motion_B) {
  Vector6d nu;
  nu << motion_B.linear, motion_B.angular;
  Eigen::Vector3d q;
  for (int axis = 0; axis < 3; ++axis) q[axis] = nu.dot(calibration.motion[axis] * nu);
  return q.sum() > 0 ? calibration.factor.dot(q) / q.sum() : 1;
}

}  // namespace hydro
