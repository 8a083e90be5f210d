#include "hydro/radiation/froude_krylov.h"

#include <algorithm>
#include <cmath>

#include "hydro/airy_waves.h"
#include "hydro/loads/clip.h"
#include "hydro/parallel.h"

namespace hydro {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector3d;

/// Longest edge of a triangle, by its wave number [-]: the rule below is then exact to some 1e-6.
constexpr double kLongestEdge = 0.3;
/// Edges below this part of the hull's length are not halved, however short the wave [-].
constexpr double kShortestEdge = 0.01;

/// A triangle's part of the integral: the middles of its edges have a third of its area each.
struct PressurePoint {
  Vector3d at;    ///< In H, relative to the centre of mass [m].
  Vector3d flux;  ///< n dS [m^2].
};

void add_points(const Panel& panel, double longest_edge, std::vector<PressurePoint>& points) {
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const double edge = (panel[(e + 1) % 3] - panel[e]).norm();
    if (edge > length) {
      length = edge;
      longest = e;
    }
  }
  const Vector3d &a = panel[longest], &b = panel[(longest + 1) % 3], &c = panel[(longest + 2) % 3];
  const Vector3d middle = 0.5 * (a + b);
  if (length > longest_edge) {
    add_points({a, middle, c}, longest_edge, points);
    add_points({middle, b, c}, longest_edge, points);
    return;
  }
  const Vector3d flux = area_vector(panel) / 3;
  for (const Vector3d& at : {middle, Vector3d(0.5 * (b + c)), Vector3d(0.5 * (c + a))})
    points.push_back({at, flux});
}

std::vector<PressurePoint> wet_points(const TriMesh& mesh_B, const MeanPose& pose,
                                      double longest_edge) {
  const Eigen::Matrix3Xd at = pose.orientation.toRotationMatrix() * mesh_B.vertices;
  std::vector<PressurePoint> points;
  for (Eigen::Index face = 0; face < mesh_B.face_count(); ++face) {
    Panel panel;
    Vector3d depth;
    for (Eigen::Index i = 0; i < 3; ++i) {
      panel[static_cast<std::size_t>(i)] = at.col(mesh_B.faces(i, face));
      depth[i] = -pose.height - panel[static_cast<std::size_t>(i)].z();
    }
    for (const PanelPart& part : positive_part(panel, depth))
      add_points(part.panel, longest_edge, points);
  }
  return points;
}

Loads6cd loads_at(const std::vector<PressurePoint>& points, double k, const MeanPose& pose,
                  const LinearWater& water, const std::vector<double>& headings) {
  Loads6cd loads = Loads6cd::Zero(6, static_cast<Eigen::Index>(headings.size()));
  for (const PressurePoint& point : points) {
    const double z = std::min(0.0, point.at.z() + pose.height);
    const double below = std::exp(-2 * k * (z + water.depth)),
                 bottom = std::exp(-2 * k * water.depth);
    const double head = water.gravity * std::exp(k * z) * (1 + below) / (1 + bottom);
    Vector6d N;
    N << point.flux, point.at.cross(point.flux);
    for (std::size_t h = 0; h < headings.size(); ++h) {
      const double along =
          std::cos(headings[h]) * point.at.x() + std::sin(headings[h]) * point.at.y();
      loads.col(static_cast<Eigen::Index>(h)) -=
          head * std::polar(1.0, k * along) * N.cast<Complex>();
    }
  }
  return loads;
}

}  // namespace

std::vector<Loads6cd> froude_krylov(const TriMesh& mesh_B, const MeanPose& pose,
                                    const LinearWater& water,
                                    const std::vector<double>& frequencies,
                                    const std::vector<double>& headings) {
  const double size =
      (mesh_B.vertices.rowwise().maxCoeff() - mesh_B.vertices.rowwise().minCoeff()).norm();
  std::vector<Loads6cd> loads(frequencies.size());
  parallel_for(frequencies.size(), [&](std::size_t f) {
    const double k = wave_number(frequencies[f], water.depth, water.gravity).value();
    const double edge = std::max(kLongestEdge / k, kShortestEdge * size);
    loads[f] = loads_at(wet_points(mesh_B, pose, edge), k, pose, water, headings);
  });
  return loads;
}

}  // namespace hydro
