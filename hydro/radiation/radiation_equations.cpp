#include "hydro/radiation/radiation_equations.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "hydro/mesh/face_tree.h"
#include "hydro/parallel.h"
#include "hydro/radiation/finite_depth_green.h"
#include "hydro/radiation/green_function.h"

namespace hydro {
namespace {

using bem::kPerSphere;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using std::numbers::pi;
using SixColumnsC = Eigen::Matrix<Complex, Eigen::Dynamic, 6>;

/// Part of the patches' number that points of the waterplane add to the equations.
constexpr double kInnerShare = 0.1;
/// Part of the lowest frequency of sloshing, squared, from which on they are added.
constexpr double kBelowSloshing = 0.8;

/// Values of a patch's functions at its three nodes, where they interpolate linear functions: node
/// m has the weight (1 + at(1, m) f_1 + at(2, m) f_2)/3.
const Eigen::Matrix3d& node_functions() {
  static const Eigen::Matrix3d at = [] {
    Eigen::Matrix3d functions;
    for (int m = 0; m < 3; ++m) {
      const double angle = 2 * pi * m / 3;
      functions.col(m) << 1, std::sqrt(2.0) * std::cos(angle), std::sqrt(2.0) * std::sin(angle);
    }
    return functions;
  }();
  return at;
}

std::vector<PatchNode> nodes_of(const Patch& patch, const PatchMoments& moments) {
  std::array<Eigen::Matrix3d, 3> products;  // ∫ f_k f_b n dS
  for (Eigen::Matrix3d& product : products) product.setZero();
  for (const bem::Element& panel : patch.panels)
    for (std::size_t e = 0; e < 3; ++e) {
      const Vector3d f = patch.functions((panel.corners[e] + panel.corners[(e + 1) % 3]) / 2);
      const Eigen::Matrix3d flux = panel.area / 3 * panel.normal * f.transpose();
      for (Index k = 0; k < 3; ++k) products[static_cast<std::size_t>(k)] += f[k] * flux;
    }
  std::vector<PatchNode> nodes;
  for (Index m = 0; m < 3; ++m) {
    const Vector3d f = node_functions().col(m);
    PatchNode node{patch.centre, Eigen::Matrix3d::Zero(), MotionRow::Zero()};
    for (Index k = 0; k < 3; ++k) {
      node.flux += f[k] / 3 * products[static_cast<std::size_t>(k)];
      node.source += f[k] / 3 * moments.load.row(k);
      if (k == 0) continue;
      const Vector3d& slope = patch.slopes[static_cast<std::size_t>(k - 1)];
      if (!slope.isZero(0)) node.at += f[k] / slope.squaredNorm() * slope;
    }
    nodes.push_back(node);
  }
  return nodes;
}

WaterPlane bottom_of(const RadiationEquations& p) {
  return {.up = p.plane.up, .height = p.plane.height - p.depth};
}

/// Rows of the equations at a point, for tests of the given weights.
void add_rankine(RadiationEquations& p, const Vector3d& x, const Eigen::VectorXd& test, Index row) {
  for (std::size_t j = 0; j < p.patches.size(); ++j) {
    Seen seen, image;
    add_seen(p.patches[j], p.moments[j], x, kPerSphere, seen);
    add_seen(p.patches[j], p.moments[j], p.plane.mirrored(x), p.image * kPerSphere, image);
    if (std::isfinite(p.depth))
      add_seen(p.patches[j], p.moments[j], bottom_of(p).mirrored(x), kPerSphere, seen);
    const Index column = 3 * static_cast<Index>(j);
    const Index rows = test.size();
    p.rankine.block(row, column, rows, 3) += test * (seen.twofold + image.twofold).transpose();
    p.rising.block(row, column, rows, 3) +=
        test * (image.normal.transpose() * p.plane.up).transpose();
    p.side.middleRows(row, rows) += test * (seen.single + image.single);
  }
}

void fill_rankine(RadiationEquations& p, std::size_t i) {
  const Patch& patch = p.patches[i];
  const Index row = 3 * static_cast<Index>(i);
  Eigen::Matrix3d own = Eigen::Matrix3d::Zero();
  for (const PatchPoint& point : patch.points) {
    const Vector3d f = patch.functions(point.at);
    const Vector3d test = point.weight / patch.area * f;
    own += test * f.transpose();
    add_rankine(p, point.at, test, row);
  }
  p.rankine.block<3, 3>(row, row) += own / 2;
  for (Index k = 0; k < 2; ++k)  // a function that the patch lacks has a coefficient of 0
    if (patch.slopes[static_cast<std::size_t>(k)].isZero(0))
      p.rankine(row + k + 1, row + k + 1) = 1;
}

/// Points spread over the part of the plane that is inside the hull (Roberts' sequence).
void choose_inner(const TriMesh& mesh_H, RadiationEquations& p) {
  Eigen::AlignedBox3d box;
  for (const Patch& patch : p.patches)
    for (const bem::Element& panel : patch.panels)
      for (const Vector3d& corner : panel.corners) box.extend(corner);
  const Vector3d size = box.sizes();
  const double kappa = pi * std::hypot(1 / size.x(), 1 / size.y());
  p.sloshing = kappa / std::tanh(kappa * size.z());
  const FaceTree tree(mesh_H);
  const int wanted =
      std::max(8, static_cast<int>(kInnerShare * static_cast<double>(p.patches.size())));
  const int most = 20 * wanted;
  int tried = 0;
  for (; tried < most && static_cast<int>(p.inner.size()) < wanted; ++tried) {
    const double a = std::fmod(0.5 + 0.7548776662466927 * tried, 1);
    const double b = std::fmod(0.5 + 0.5698402909980532 * tried, 1);
    const Vector3d x(box.min().x() + a * size.x(), box.min().y() + b * size.y(), p.plane.height);
    // Just below the plane, where a deck in it does not matter.
    if (tree.contains(x - 1e-6 * size.z() * p.plane.up)) p.inner.push_back(x);
  }
  if (p.inner.empty()) return;
  double area = 0;
  for (const Patch& patch : p.patches) area += patch.area;
  const double waterplane = size.x() * size.y() * static_cast<double>(p.inner.size()) / tried;
  p.inner_weight = std::sqrt(waterplane / static_cast<double>(p.inner.size()) /
                             (area / static_cast<double>(p.patches.size())));
}

/// The smooth part of (1) seen from a point: its row of the matrix, and of the right-hand sides.
struct WaveRow {
  explicit WaveRow(Index unknowns) : matrix(unknowns) {}
  Eigen::RowVectorXcd matrix;
  Eigen::Matrix<Complex, 1, 6> side;
};

/// The smooth part of G over a length, and its slopes over the length squared.
struct WaveField {
  const RadiationEquations& equations;
  double k;                                ///< ω²/g; infinite in the limit of high frequency.
  std::optional<FiniteDepthGreen> finite;  ///< None in deep water.

  WaveField(const RadiationEquations& p, double deep_wave_number)
      : equations(p), k(p.image > 0 ? deep_wave_number : std::numeric_limits<double>::infinity()) {
    if (std::isfinite(p.depth)) finite.emplace(k, p.depth, p.reach(), p.draught());
  }
  /// The inverse of the length.
  double scale() const { return finite ? 1 : k; }
  /// False if G has no smooth part.
  bool exists() const { return finite || std::isfinite(k); }
  /// @param x, y   Depths of two points below the surface.
  SmoothGreen at(double distance, double x, double y) const {
    if (finite) return finite->at(distance, -std::max(0.0, x), -std::max(0.0, y));
    const WaveGreen green = wave_green(k * distance, k * std::max(0.0, x + y));
    return {green.value, green.by_x, green.value};
  }
};

void find_wave_row(const WaveField& field, const Vector3d& x, WaveRow& row) {
  const RadiationEquations& p = field.equations;
  const double k = field.scale();
  row.matrix.setZero();
  row.side.setZero();
  const double depth = p.plane.depth(x);
  for (std::size_t n = 0; n < p.nodes.size(); ++n) {
    const PatchNode& node = p.nodes[n];
    const Eigen::Vector2d away = (node.at - x).head<2>();
    const double distance = away.norm();
    const SmoothGreen green = field.at(distance, depth, p.plane.depth(node.at));
    const Complex across = distance > 0 ? green.by_distance / distance : Complex(0);
    const Eigen::RowVector3d horizontal = away.transpose() * node.flux.topRows<2>();
    row.matrix.segment<3>(3 * static_cast<Index>(n / 3)) -=
        kPerSphere * k * k * (across * horizontal + green.by_height * node.flux.row(2));
    row.side += kPerSphere * k * green.value * node.source;
  }
}

/// Adds the smooth part of G to the rows of patches, then of inner points.
void add_waves(const WaveField& field, MatrixXcd& matrix, SixColumnsC& side) {
  const RadiationEquations& p = field.equations;
  WaveRow row(p.unknowns());
  for (std::size_t n = 0; n < p.nodes.size(); ++n) {
    const Patch& patch = p.patches[n / 3];
    const Vector3d f = node_functions().col(static_cast<Index>(n % 3));
    find_wave_row(field, p.nodes[n].at, row);
    for (Index a = 0; a < 3; ++a) {
      if (a > 0 && patch.slopes[static_cast<std::size_t>(a - 1)].isZero(0)) continue;
      matrix.row(3 * static_cast<Index>(n / 3) + a) += f[a] / 3 * row.matrix;
      side.row(3 * static_cast<Index>(n / 3) + a) += f[a] / 3 * row.side;
    }
  }
  for (Index i = p.unknowns(); i < matrix.rows(); ++i) {
    find_wave_row(field, p.inner[static_cast<std::size_t>(i - p.unknowns())], row);
    matrix.row(i) += p.inner_weight * row.matrix;
    side.row(i) += p.inner_weight * row.side;
  }
}

}  // namespace

double RadiationEquations::draught() const {
  double deepest = 0;
  for (const Patch& patch : patches)
    for (const bem::Element& panel : patch.panels)
      for (const Vector3d& corner : panel.corners) deepest = std::max(deepest, plane.depth(corner));
  return deepest;
}

double RadiationEquations::reach() const {
  Eigen::AlignedBox2d box;
  for (const PatchNode& node : nodes) box.extend(node.at.head<2>());
  for (const Vector3d& x : inner) box.extend(x.head<2>());
  return box.sizes().norm();
}

RadiationEquations make_radiation_equations(const TriMesh& mesh_H, const WaterPlane& plane,
                                            double depth, int patches, SurfaceWaves waves) {
  RadiationEquations p{.plane = plane,
                       .depth = depth,
                       .image = waves == SurfaceWaves::yes ? 1.0 : -1.0,
                       .patches = wetted_patches(mesh_H, plane, patches)};
  for (const Patch& patch : p.patches) {
    p.moments.push_back(moments_of(patch));
    const std::vector<PatchNode> nodes = nodes_of(patch, p.moments.back());
    p.nodes.insert(p.nodes.end(), nodes.begin(), nodes.end());
  }
  if (p.patches.empty()) return p;
  if (waves == SurfaceWaves::yes) choose_inner(mesh_H, p);
  const Index rows = p.unknowns() + static_cast<Index>(p.inner.size());
  p.rankine = p.rising = MatrixXd::Zero(rows, p.unknowns());
  p.side = RadiationEquations::SixColumns::Zero(rows, 6);
  parallel_for(p.patches.size(), [&](std::size_t i) { fill_rankine(p, i); });
  const Eigen::VectorXd weight = Eigen::VectorXd::Constant(1, p.inner_weight);
  parallel_for(p.inner.size(), [&](std::size_t i) {
    add_rankine(p, p.inner[i], weight, p.unknowns() + static_cast<Index>(i));
  });
  return p;
}

SixColumnsC solve_potentials(const RadiationEquations& p, double deep_wave_number) {
  const WaveField field(p, deep_wave_number);
  const double k = field.k;
  const bool sloshes = k > kBelowSloshing * p.sloshing && !p.inner.empty();
  const Index rows = p.unknowns() + (sloshes ? static_cast<Index>(p.inner.size()) : 0);
  MatrixXcd matrix = p.rankine.topRows(rows).cast<Complex>();
  if (std::isfinite(k))
    matrix = (p.rankine.topRows(rows) - 2 * k * p.rising.topRows(rows)).cast<Complex>();
  SixColumnsC side = p.side.topRows(rows).cast<Complex>();
  if (field.exists()) add_waves(field, matrix, side);
  if (!sloshes) return Eigen::PartialPivLU<Eigen::Ref<MatrixXcd>>(matrix).solve(side);
  return Eigen::HouseholderQR<Eigen::Ref<MatrixXcd>>(matrix).solve(side);
}

Eigen::Matrix<Complex, 6, 6> load_of(const RadiationEquations& p, const SixColumnsC& potentials) {
  Eigen::Matrix<Complex, 6, 6> sum = Eigen::Matrix<Complex, 6, 6>::Zero();
  for (std::size_t j = 0; j < p.patches.size(); ++j)
    sum += potentials.middleRows<3>(3 * static_cast<Index>(j)).transpose() * p.moments[j].load;
  return sum;
}

}  // namespace hydro
