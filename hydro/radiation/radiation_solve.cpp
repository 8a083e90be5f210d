#include "hydro/radiation/radiation_solve.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "hydro/added_mass/patch_integrals.h"
#include "hydro/added_mass/surface_solve.h"
#include "hydro/mesh/mirror_symmetry.h"
#include "hydro/parallel.h"
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
using SixColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;
using SixColumnsC = Eigen::Matrix<Complex, Eigen::Dynamic, 6>;

/// Part of the patches' number that points of the waterplane add to the equations.
constexpr double kInnerShare = 0.1;
/// Part of the lowest frequency of sloshing, squared, from which on they are added.
constexpr double kBelowSloshing = 0.8;
/// Panels above which those of a hull have one point each in (3), not three.
constexpr std::size_t kManyPanels = 3000;

/// Distance within which vertices are mirror images, over the mesh's size [-].
constexpr double kSymmetric = 1e-6;

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

/// A point of a patch at which the smooth part of G is taken.
struct Node {
  Vector3d at;
  Eigen::Matrix3d flux;  ///< ∫ L f_b n dS, one column per function b, with L the node's weight.
  MotionRow source;      ///< ∫ L N dS
};

/// The wetted hull in H, and what of (1) does not depend on the frequency.
struct Problem {
  WaterPlane plane;
  std::vector<Patch> patches;
  std::vector<PatchMoments> moments;
  std::vector<Node> nodes;      ///< Three a patch.
  std::vector<Vector3d> inner;  ///< Points of the waterplane inside the hull.
  double inner_weight = 0;      ///< Of their equations.
  double sloshing = 0;          ///< A lower bound of the wave numbers of sloshing [1/m].
  MatrixXd rankine;             ///< Of ½ψ, 1/r and 1/r'; rows of patches, then inner points.
  MatrixXd rising;              ///< (1/4π) ∫ f_b n_z/r' dS
  SixColumns side;              ///< (1/4π) ∫ N (1/r + 1/r') dS

  Index unknowns() const { return 3 * static_cast<Index>(patches.size()); }
};

std::vector<Node> nodes_of(const Patch& patch, const PatchMoments& moments) {
  std::array<Eigen::Matrix3d, 3> products;  // ∫ f_k f_b n dS
  for (Eigen::Matrix3d& product : products) product.setZero();
  for (const bem::Element& panel : patch.panels)
    for (std::size_t e = 0; e < 3; ++e) {
      const Vector3d f = patch.functions((panel.corners[e] + panel.corners[(e + 1) % 3]) / 2);
      const Eigen::Matrix3d flux = panel.area / 3 * panel.normal * f.transpose();
      for (Index k = 0; k < 3; ++k) products[static_cast<std::size_t>(k)] += f[k] * flux;
    }
  std::vector<Node> nodes;
  for (Index m = 0; m < 3; ++m) {
    const Vector3d f = node_functions().col(m);
    Node node{patch.centre, Eigen::Matrix3d::Zero(), MotionRow::Zero()};
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

/// Rows of the equations at a point, for tests of the given weights.
void add_rankine(Problem& p, const Vector3d& x, const Eigen::VectorXd& test, Index row) {
  for (std::size_t j = 0; j < p.patches.size(); ++j) {
    Seen seen, image;
    add_seen(p.patches[j], p.moments[j], x, kPerSphere, seen);
    add_seen(p.patches[j], p.moments[j], p.plane.mirrored(x), kPerSphere, image);
    const Index column = 3 * static_cast<Index>(j);
    const Index rows = test.size();
    p.rankine.block(row, column, rows, 3) += test * (seen.twofold + image.twofold).transpose();
    p.rising.block(row, column, rows, 3) +=
        test * (image.normal.transpose() * p.plane.up).transpose();
    p.side.middleRows(row, rows) += test * (seen.single + image.single);
  }
}

void fill_rankine(Problem& p, std::size_t i) {
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

/// True for a point inside a closed mesh, by its solid angle.
bool is_inside(const std::vector<bem::Element>& faces, const Vector3d& x) {
  double angle = 0;
  for (const bem::Element& face : faces) angle += bem::solid_angle(face, x);
  return angle > 2 * pi;
}

/// Points spread over the part of the plane that is inside the hull (Roberts' sequence).
void choose_inner(const TriMesh& mesh_H, Problem& p) {
  Eigen::AlignedBox3d box;
  for (const Patch& patch : p.patches)
    for (const bem::Element& panel : patch.panels)
      for (const Vector3d& corner : panel.corners) box.extend(corner);
  const Vector3d size = box.sizes();
  const double kappa = pi * std::hypot(1 / size.x(), 1 / size.y());
  p.sloshing = kappa / std::tanh(kappa * size.z());
  const std::vector<bem::Element> faces = bem::make_elements(mesh_H);
  const int wanted =
      std::max(8, static_cast<int>(kInnerShare * static_cast<double>(p.patches.size())));
  const int most = 20 * wanted;
  int tried = 0;
  for (; tried < most && static_cast<int>(p.inner.size()) < wanted; ++tried) {
    const double a = std::fmod(0.5 + 0.7548776662466927 * tried, 1);
    const double b = std::fmod(0.5 + 0.5698402909980532 * tried, 1);
    const Vector3d x(box.min().x() + a * size.x(), box.min().y() + b * size.y(), p.plane.height);
    // Just below the plane, where a deck in it does not matter.
    if (is_inside(faces, x - 1e-6 * size.z() * p.plane.up)) p.inner.push_back(x);
  }
  if (p.inner.empty()) return;
  double area = 0;
  for (const Patch& patch : p.patches) area += patch.area;
  const double waterplane = size.x() * size.y() * static_cast<double>(p.inner.size()) / tried;
  p.inner_weight = std::sqrt(waterplane / static_cast<double>(p.inner.size()) /
                             (area / static_cast<double>(p.patches.size())));
}

Problem make_problem(const TriMesh& mesh_H, const WaterPlane& plane, int patches) {
  Problem p{.plane = plane,
            .patches = wetted_patches(mesh_H, plane, patches),
            .moments = {},
            .nodes = {},
            .inner = {}};
  for (const Patch& patch : p.patches) {
    p.moments.push_back(moments_of(patch));
    const std::vector<Node> nodes = nodes_of(patch, p.moments.back());
    p.nodes.insert(p.nodes.end(), nodes.begin(), nodes.end());
  }
  if (p.patches.empty()) return p;
  choose_inner(mesh_H, p);
  const Index rows = p.unknowns() + static_cast<Index>(p.inner.size());
  p.rankine = p.rising = MatrixXd::Zero(rows, p.unknowns());
  p.side = SixColumns::Zero(rows, 6);
  parallel_for(p.patches.size(), [&](std::size_t i) { fill_rankine(p, i); });
  const Eigen::VectorXd weight = Eigen::VectorXd::Constant(1, p.inner_weight);
  parallel_for(p.inner.size(), [&](std::size_t i) {
    add_rankine(p, p.inner[i], weight, p.unknowns() + static_cast<Index>(i));
  });
  return p;
}

/// The smooth part of (1) seen from a point: its row of the matrix, and of the right-hand sides.
struct WaveRow {
  explicit WaveRow(Index unknowns) : matrix(unknowns) {}
  Eigen::RowVectorXcd matrix;
  Eigen::Matrix<Complex, 1, 6> side;
};

void find_wave_row(const Problem& p, double k, const Vector3d& x, WaveRow& row) {
  row.matrix.setZero();
  row.side.setZero();
  const double depth = p.plane.depth(x);
  for (std::size_t n = 0; n < p.nodes.size(); ++n) {
    const Node& node = p.nodes[n];
    const Eigen::Vector2d away = (node.at - x).head<2>();
    const double distance = away.norm();
    const WaveGreen green =
        wave_green(k * distance, k * std::max(0.0, depth + p.plane.depth(node.at)));
    const Complex across = distance > 0 ? green.by_x / distance : Complex(0);
    const Eigen::RowVector3d horizontal = away.transpose() * node.flux.topRows<2>();
    row.matrix.segment<3>(3 * static_cast<Index>(n / 3)) -=
        kPerSphere * k * k * (across * horizontal + green.value * node.flux.row(2));
    row.side += kPerSphere * k * green.value * node.source;
  }
}

/// The potentials at one wave number.
SixColumnsC solve_at(const Problem& p, double k) {
  const bool sloshes = k > kBelowSloshing * p.sloshing && !p.inner.empty();
  const Index rows = p.unknowns() + (sloshes ? static_cast<Index>(p.inner.size()) : 0);
  MatrixXcd matrix = (p.rankine.topRows(rows) - 2 * k * p.rising.topRows(rows)).cast<Complex>();
  SixColumnsC side = p.side.topRows(rows).cast<Complex>();
  WaveRow row(p.unknowns());
  for (std::size_t n = 0; n < p.nodes.size(); ++n) {
    const Patch& patch = p.patches[n / 3];
    const Vector3d f = node_functions().col(static_cast<Index>(n % 3));
    find_wave_row(p, k, p.nodes[n].at, row);
    for (Index a = 0; a < 3; ++a) {
      if (a > 0 && patch.slopes[static_cast<std::size_t>(a - 1)].isZero(0)) continue;
      matrix.row(3 * static_cast<Index>(n / 3) + a) += f[a] / 3 * row.matrix;
      side.row(3 * static_cast<Index>(n / 3) + a) += f[a] / 3 * row.side;
    }
  }
  for (Index i = p.unknowns(); i < rows; ++i) {
    find_wave_row(p, k, p.inner[static_cast<std::size_t>(i - p.unknowns())], row);
    matrix.row(i) += p.inner_weight * row.matrix;
    side.row(i) += p.inner_weight * row.side;
  }
  if (!sloshes) return Eigen::PartialPivLU<Eigen::Ref<MatrixXcd>>(matrix).solve(side);
  return Eigen::HouseholderQR<Eigen::Ref<MatrixXcd>>(matrix).solve(side);
}

/// What a point of the surface adds to (3).
struct SurfacePoint {
  Vector3d at;
  Vector3d flux;  ///< n dS
  std::size_t patch;
};

std::vector<SurfacePoint> points_of(const std::vector<Patch>& patches) {
  std::size_t panels = 0;
  for (const Patch& patch : patches) panels += patch.panels.size();
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (const bem::Element& panel : patches[i].panels) {
      const Vector3d flux = panel.area * panel.normal;
      if (panels > kManyPanels) {
        points.push_back({panel.centroid, flux, i});
        continue;
      }
      for (std::size_t e = 0; e < 3; ++e)
        points.push_back({(panel.corners[e] + panel.corners[(e + 1) % 3]) / 2, flux / 3, i});
    }
  return points;
}

/// (3) for all headings.
void add_excitation(const Problem& p, const std::vector<SurfacePoint>& points, double k,
                    double gravity, const SixColumnsC& psi, const std::vector<double>& headings,
                    Loads6cd& froude_krylov, Loads6cd& diffraction) {
  const Complex i(0, 1);
  for (const SurfacePoint& point : points) {
    const Eigen::Matrix<Complex, 6, 1> potential =
        psi.middleRows<3>(3 * static_cast<Index>(point.patch)).transpose() *
        p.patches[point.patch].functions(point.at).cast<Complex>();
    const MotionRow N = motions(point.at, point.flux);
    const double head = std::exp(-k * p.plane.depth(point.at));
    const std::size_t half = headings.size() / 2;
    for (std::size_t h = 0; h < half; ++h) {
      const Eigen::Vector2d d(std::cos(headings[h]), std::sin(headings[h]));
      const double phase = k * d.dot(point.at.head<2>());
      const Complex wave = head * Complex(std::cos(phase), std::sin(phase));
      const double along = d.dot(point.flux.head<2>());
      for (const bool opposite : {false, true}) {
        const Index column = static_cast<Index>(opposite ? h + half : h);
        const Complex crest = opposite ? std::conj(wave) : wave;
        froude_krylov.col(column) -= gravity * crest * N.transpose();
        diffraction.col(column) -=
            gravity * k * crest * (i * (opposite ? -along : along) + point.flux.z()) * potential;
      }
    }
  }
}

std::vector<double> evenly_spaced(int count) {
  std::vector<double> headings;
  for (int h = 0; h < count; ++h) headings.push_back(2 * pi * h / count);
  return headings;
}

/// (4)
Matrix6d damping_of(const Loads6cd& excitation, double k, double omega, double gravity) {
  const Eigen::Matrix<Complex, 6, 6> sum = excitation * excitation.adjoint();
  const double factor =
      k * omega / (4 * pi * gravity * gravity) * 2 * pi / static_cast<double>(excitation.cols());
  return factor * sum.real();
}

/// Signs of the six motions under a mirror in the plane normal to a horizontal axis.
Vector6d mirror_signs(int axis) {
  Vector6d signs;
  if (axis == 0)
    signs << -1, 1, 1, 1, -1, -1;
  else
    signs << 1, -1, 1, -1, 1, -1;
  return signs;
}

/// Takes from the data what a mirror symmetry of the hull forbids: its patches do not have it.
void make_symmetric(int axis, RadiationData& data) {
  const Vector6d signs = mirror_signs(axis);
  const Matrix6d allowed = ((signs * signs.transpose()).array() + 1) / 2;
  for (std::vector<Matrix6d>* matrices : {&data.added_mass, &data.damping})
    for (Matrix6d& matrix : *matrices) matrix = matrix.cwiseProduct(allowed).eval();
  data.infinite_added_mass = data.infinite_added_mass.cwiseProduct(allowed).eval();
  for (std::vector<Loads6cd>* loads : {&data.froude_krylov, &data.diffraction})
    for (Loads6cd& load : *loads) {
      const Loads6cd given = load;
      const Index count = load.cols();
      for (Index h = 0; h < count; ++h) {
        const Index mirrored = ((axis == 0 ? count / 2 - h : -h) + count) % count;
        load.col(h) = (given.col(h) + signs.asDiagonal() * given.col(mirrored)) / 2;
      }
    }
}

TriMesh turned(const TriMesh& mesh_B, const MeanPose& pose) {
  TriMesh mesh = mesh_B;
  mesh.vertices = pose.orientation.toRotationMatrix() * mesh_B.vertices;
  return mesh;
}

}  // namespace

std::vector<double> radiation_frequencies(const TriMesh& mesh_B, const MeanPose& pose,
                                          const LinearWater& water) {
  constexpr int kCount = 16;
  const Eigen::Matrix3Xd at = turned(mesh_B, pose).vertices;
  const Eigen::Vector2d sizes =
      at.topRows<2>().rowwise().maxCoeff() - at.topRows<2>().rowwise().minCoeff();
  const double draught = -pose.height - at.row(2).minCoeff();
  const double lowest = std::sqrt(water.gravity * 0.1 / std::max(sizes.maxCoeff(), 2 * draught));
  const double highest = std::sqrt(water.gravity * 10 / sizes.minCoeff());
  std::vector<double> frequencies;
  for (int i = 0; i < kCount; ++i)
    frequencies.push_back(lowest * std::pow(highest / lowest, i / (kCount - 1.0)));
  return frequencies;
}

RadiationSolution solve_radiation(const TriMesh& mesh_B, const MeanPose& pose,
                                  const LinearWater& water, const RadiationOptions& options) {
  if (std::isfinite(water.depth))
    throw std::invalid_argument("radiation is solved for deep water only");
  const TriMesh mesh_H = turned(mesh_B, pose);
  const WaterPlane plane{.up = Vector3d::UnitZ(), .height = -pose.height};
  const Problem p = make_problem(mesh_H, plane, options.patches);
  if (p.patches.empty()) throw std::invalid_argument("the body is dry in its mean pose");
  RadiationSolution solution{.data = {.pose = pose, .water = water}};
  RadiationData& data = solution.data;
  solution.unknowns = static_cast<int>(p.unknowns());
  data.volume = wetted_volume(mesh_H, plane);
  data.frequencies = options.frequencies.empty() ? radiation_frequencies(mesh_B, pose, water)
                                                 : options.frequencies;
  data.headings = evenly_spaced(options.headings);
  data.infinite_added_mass = solve_under(mesh_H, plane, options.patches).matrix;
  const std::size_t count = data.frequencies.size();
  const Loads6cd none = Loads6cd::Zero(6, options.headings);
  data.added_mass.resize(count);
  data.damping.resize(count);
  data.froude_krylov.assign(count, none);
  data.diffraction.assign(count, none);
  std::vector<Matrix6d> radiated(count);
  const std::vector<SurfacePoint> points = points_of(p.patches);
  parallel_for(count, [&](std::size_t f) {
    const double omega = data.frequencies[f], k = omega * omega / water.gravity;
    const SixColumnsC psi = solve_at(p, k);
    Eigen::Matrix<Complex, 6, 6> sum = Eigen::Matrix<Complex, 6, 6>::Zero();
    for (std::size_t j = 0; j < p.patches.size(); ++j)
      sum += psi.middleRows<3>(3 * static_cast<Index>(j)).transpose() * p.moments[j].load;
    data.added_mass[f] = (sum + sum.transpose()).real() / 2;
    radiated[f] = omega * (sum + sum.transpose()).imag() / 2;
    add_excitation(p, points, k, water.gravity, psi, data.headings, data.froude_krylov[f],
                   data.diffraction[f]);
    data.damping[f] =
        damping_of(data.froude_krylov[f] + data.diffraction[f], k, omega, water.gravity);
  });
  const double size = mesh_H.vertices.cwiseAbs().maxCoeff();
  for (const int axis : {0, 1})
    if (is_mirror_symmetric(mesh_H, axis, kSymmetric * size)) make_symmetric(axis, data);
  double area = 0, largest = 0;
  for (const Patch& patch : p.patches) area += patch.area;
  Vector6d lever = Vector6d::Ones();
  lever.tail<3>() /= std::sqrt(area);
  for (std::size_t f = 0; f < count; ++f) {
    const Matrix6d B = lever.asDiagonal() * data.damping[f] * lever.asDiagonal();
    const Matrix6d other = lever.asDiagonal() * radiated[f] * lever.asDiagonal();
    largest = std::max(largest, B.cwiseAbs().maxCoeff());
    solution.mismatch = std::max(solution.mismatch, (B - other).cwiseAbs().maxCoeff());
  }
  if (largest > 0) solution.mismatch /= largest;
  return solution;
}

}  // namespace hydro
