#include "hydro/added_mass/surface_patches.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "hydro/decompositions.h"
#include "hydro/loads/clip.h"

namespace hydro {
namespace {

using bem::Element;
using Eigen::Index;
using Eigen::Vector3d;

/// Least number of triangles per patch: with fewer the equation is less accurate along edges of the
/// hull.
constexpr double kPanelsAPatch = 3;

/// Number of points of a patch with more triangles than this, if they suffice.
constexpr std::size_t kPointsAPatch = 12;

/// Least mean square of a patch's functions over its points; over its area it is 1.
constexpr double kLeastTold = 0.25;

/// Eigenvalue of the products of functions, over the largest, that is none [-].
constexpr double kNoProduct = 1e-12;

/// Weight of the normal when triangles are grouped, in square roots of the wetted area. It assigns
/// the sides of a thin plate, and the faces at an edge, to different patches.
constexpr double kNormalWeight = 0.5;

/// Area relative to the largest allowed one below which a triangle is dropped: its load is less
/// than its round-off.
constexpr double kLeastArea = 1e-9;

/// Splits a panel at the middle of the longest edge until no part has an area above `most`.
void add_split(const Panel& panel, double most, std::vector<Element>& panels) {
  const double area = area_vector(panel).norm();
  if (area <= most) {
    if (area > kLeastArea * most) panels.push_back(bem::make_element(panel[0], panel[1], panel[2]));
    return;
  }
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t e = 0; e < 3; ++e) {
    const double edge = (panel[(e + 1) % 3] - panel[e]).norm();
    if (edge <= length * (1 + 1e-9)) continue;
    length = edge;
    longest = e;
  }
  const Vector3d &a = panel[longest], &b = panel[(longest + 1) % 3], &c = panel[(longest + 2) % 3];
  const Vector3d middle = 0.5 * (a + b);
  add_split({a, middle, c}, most, panels);
  add_split({middle, b, c}, most, panels);
}

/// Calls f with each wet part of a face and its depths.
template <class Function>
void for_each_wet_part(const TriMesh& mesh_B, const WaterPlane& plane, Function&& f) {
  for (Index face = 0; face < mesh_B.face_count(); ++face) {
    Panel panel;
    Vector3d depth = Vector3d::Ones();
    for (std::size_t i = 0; i < 3; ++i) {
      panel[i] = mesh_B.vertices.col(mesh_B.faces(static_cast<Index>(i), face));
      if (plane.bounded()) depth[static_cast<Index>(i)] = plane.depth(panel[i]);
    }
    for (const PanelPart& part : positive_part(panel, depth)) f(part);
  }
}

std::vector<Panel> wet_parts(const TriMesh& mesh_B, const WaterPlane& plane) {
  std::vector<Panel> wet;
  for_each_wet_part(mesh_B, plane, [&](const PanelPart& part) { wet.push_back(part.panel); });
  return wet;
}

using Key = Eigen::Matrix<double, 6, 1>;

/// The centroid and the weighted normal of a triangle as one point.
Key key_of(const Element& panel, double normal_weight) {
  Key key;
  key << panel.centroid, normal_weight * panel.normal;
  return key;
}

/// The slopes of a patch, from the second moments of its area: the mean square of g·(y − centre) is
/// 1.
std::array<Vector3d, 2> slopes_of(const Patch& patch) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const Element& panel : patch.panels)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d offset = 0.5 * (panel.corners[i] + panel.corners[(i + 1) % 3]) - patch.centre;
      moments += panel.area / 3 * offset * offset.transpose();
    }
  // Its vectors' signs decide where the nodes of radiation_equations.h lie on a patch.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> extents(moments / patch.area);
  std::array<Vector3d, 2> slopes;
  for (Index k = 0; k < 2; ++k) {
    const double squared = extents.eigenvalues()[2 - k];
    slopes[static_cast<std::size_t>(k)] = Vector3d::Zero();
    if (squared > 1e-8 * patch.radius * patch.radius)
      slopes[static_cast<std::size_t>(k)] = extents.eigenvectors().col(2 - k) / std::sqrt(squared);
  }
  return slopes;
}

/// Three points per triangle: the rule is exact for products of two functions.
std::vector<PatchPoint> all_points(const std::vector<Element>& panels) {
  std::vector<PatchPoint> points;
  for (const Element& panel : panels)
    for (const Vector3d& corner : panel.corners)
      points.push_back({0.5 * (panel.centroid + corner), panel.area / 3});
  return points;
}

/// One point for each of kPointsAPatch runs of neighbours.
std::vector<PatchPoint> few_points(const std::vector<Element>& panels) {
  std::vector<PatchPoint> points;
  for (std::size_t run = 0; run < kPointsAPatch; ++run) {
    const std::size_t first = run * panels.size() / kPointsAPatch;
    const std::size_t last = (run + 1) * panels.size() / kPointsAPatch;
    PatchPoint point{panels[(first + last) / 2].centroid, 0};
    for (std::size_t p = first; p < last; ++p) point.weight += panels[p].area;
    points.push_back(point);
  }
  return points;
}

/// Changes the weights of points as little as makes sums over them exact for products of two
/// functions. @return false if points are too few or too uneven for that
bool match_moments(const Patch& patch, std::vector<PatchPoint>& points) {
  using Products = Eigen::Matrix<double, 6, 1>;
  const auto products = [&patch](const Vector3d& at) {
    const Vector3d f = patch.functions(at);
    Products all;
    all << f, f[1] * f[1], f[2] * f[2], f[1] * f[2];
    return all;
  };
  Products missing = Products::Zero();
  for (const Element& panel : patch.panels)
    for (std::size_t e = 0; e < 3; ++e)
      missing += panel.area / 3 * products((panel.corners[e] + panel.corners[(e + 1) % 3]) / 2);
  Eigen::Matrix<double, 6, 6> gram = Eigen::Matrix<double, 6, 6>::Zero();
  for (const PatchPoint& point : points) {
    const Products at = products(point.at);
    missing -= point.weight * at;
    gram += point.weight * at * at.transpose();
  }
  // The least solution: a patch may lack a function.
  const EigenDecomposition6 eigen = eigen_decomposition(gram);
  const double least = kNoProduct * eigen.values.maxCoeff();
  Products change = Products::Zero();
  for (int i = 0; i < 6; ++i)
    if (eigen.values[i] > least)
      change += eigen.vectors.col(i).dot(missing) / eigen.values[i] * eigen.vectors.col(i);
  for (PatchPoint& point : points) point.weight *= 1 + change.dot(products(point.at));
  return std::all_of(points.begin(), points.end(),
                     [](const PatchPoint& point) { return point.weight > 0; });
}

/// True if the points distinguish the patch's functions about as well as its whole area does.
bool tell_apart(const Patch& patch, const std::vector<PatchPoint>& points) {
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (const PatchPoint& point : points) {
    const Vector3d f = patch.functions(point.at);
    mean += point.weight / patch.area * f * f.transpose();
  }
  return eigenvalues(mean)[0] > kLeastTold;
}

Patch make_patch(std::vector<Element> panels) {
  Patch patch{.panels = std::move(panels), .points = {}, .centre = Vector3d::Zero(), .slopes = {}};
  for (const Element& panel : patch.panels) {
    patch.area += panel.area;
    patch.centre += panel.area * panel.centroid;
  }
  patch.centre /= patch.area;
  for (const Element& panel : patch.panels)
    for (const Vector3d& corner : panel.corners)
      patch.radius = std::max(patch.radius, (corner - patch.centre).norm());
  patch.slopes = slopes_of(patch);
  if (patch.panels.size() > kPointsAPatch) patch.points = few_points(patch.panels);
  if (patch.points.empty() || !match_moments(patch, patch.points) ||
      !tell_apart(patch, patch.points))
    patch.points = all_points(patch.panels);
  return patch;
}

/// Halves [begin, end) recursively by area across its longest extent, into `count` groups.
void group(std::vector<Element>& panels, std::size_t begin, std::size_t end, int count,
           double normal_weight, std::vector<Patch>& patches) {
  const auto from = panels.begin() + static_cast<std::ptrdiff_t>(begin);
  const auto to = panels.begin() + static_cast<std::ptrdiff_t>(end);
  if (count <= 1 || end - begin == 1) {
    patches.push_back(make_patch({from, to}));
    return;
  }
  Key low = key_of(*from, normal_weight), high = low;
  double whole = 0;
  for (auto panel = from; panel != to; ++panel) {
    low = low.cwiseMin(key_of(*panel, normal_weight));
    high = high.cwiseMax(key_of(*panel, normal_weight));
    whole += panel->area;
  }
  Index axis;
  (high - low).maxCoeff(&axis);
  std::stable_sort(from, to, [&](const Element& a, const Element& b) {
    return key_of(a, normal_weight)[axis] < key_of(b, normal_weight)[axis];
  });
  std::size_t middle = begin + 1;
  double below = from->area;
  while (middle + 1 < end && below + 0.5 * panels[middle].area < 0.5 * whole)
    below += panels[middle++].area;
  const int first = std::clamp(static_cast<int>(std::lround(count * below / whole)), 1, count - 1);
  group(panels, begin, middle, first, normal_weight, patches);
  group(panels, middle, end, count - first, normal_weight, patches);
}

}  // namespace

double wetted_volume(const TriMesh& mesh_B, const WaterPlane& plane) {
  // The divergence theorem is applied to −depth·up; in unbounded fluid depths are below the top.
  WaterPlane level = plane;
  if (!plane.bounded()) level.height = (plane.up.transpose() * mesh_B.vertices).maxCoeff();
  double volume = 0;
  for_each_wet_part(mesh_B, level, [&](const PanelPart& part) {
    volume -= part.value.sum() / 3 * area_vector(part.panel).dot(level.up);
  });
  return volume;
}

double wetted_area(const TriMesh& mesh_B, const WaterPlane& plane) {
  double area = 0;
  for_each_wet_part(mesh_B, plane,
                    [&](const PanelPart& part) { area += area_vector(part.panel).norm(); });
  return area;
}

std::vector<Patch> wetted_patches(const TriMesh& mesh_B, const WaterPlane& plane, int count) {
  const double area = wetted_area(mesh_B, plane);
  const std::vector<Panel> wet = wet_parts(mesh_B, plane);
  std::vector<Element> panels;
  for (const Panel& panel : wet) add_split(panel, area / (kPanelsAPatch * count), panels);
  std::vector<Patch> patches;
  if (!panels.empty())
    group(panels, 0, panels.size(), count, kNormalWeight * std::sqrt(area), patches);
  return patches;
}

}  // namespace hydro
