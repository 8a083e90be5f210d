#include "hydro/added_mass/wetted_added_mass.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/plain_wetted_added_mass.h"
#include "hydro/airy_waves.h"
#include "hydro/decompositions.h"
#include "hydro/loads/refine.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/meshes.h"
#include "tests/support/reference_loads.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydro::AddedMassSolution;
using hydro::BodyState;
using hydro::Matrix6d;
using hydro::Sea;
using hydro::TriMesh;
using hydro::WettedAddedMass;
using support::tolerance;

/// Sums of some hundred products: some hundred ulp of the largest.
const double kRoundOff = tolerance(1e-13);

/// Coarse potentials, so that a solve takes little: what is tested holds for any.
AddedMassSolution coarse(const TriMesh& mesh) {
  return hydro::solve_added_mass(mesh, {.tolerance = 1e3});
}

TriMesh star(support::Random& random) {
  const TriMesh mesh = support::random_star(random, 1);
  return hydro::translated(mesh, -hydro::solid_properties(mesh).centroid);
}

double difference(const Matrix6d& a, const Matrix6d& b) {
  return (a - b).cwiseAbs().maxCoeff() / a.cwiseAbs().maxCoeff();
}

Matrix6d symmetric(const Matrix6d& m) { return 0.5 * (m + m.transpose()); }

BodyState at_height(double z) { return {.position = {0, 0, z}}; }

Sea short_waves() {
  Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.1, 1.3, 0.4, 0.2, sea.gravity),
                                    hydro::deep_water_wave(0.05, 0.9, -1.1, 2, sea.gravity)}};
  return sea;
}

/// Corners of a face as a polygon in extended precision.
support::Polygon polygon(const TriMesh& mesh, Index face) {
  support::Polygon corners;
  for (int i = 0; i < 3; ++i)
    corners.push_back(mesh.vertices.col(mesh.faces(i, face)).cast<long double>());
  return corners;
}

/// ψ of one motion anywhere in the plane of a face, from its values at the corners.
std::function<long double(const support::Vector3l&)> interpolated(const support::Polygon& p,
                                                                  const Eigen::RowVector3d& psi) {
  return [=](const support::Vector3l& r) {
    const support::Vector3l n = (p[1] - p[0]).cross(p[2] - p[0]);
    long double value = 0;
    for (std::size_t i = 0; i < 3; ++i)
      value += psi[static_cast<Index>(i)] * (p[(i + 1) % 3] - r).cross(p[(i + 2) % 3] - r).dot(n) /
               n.squaredNorm();
    return value;
  };
}

/// ∫ ψ_m N_n dS over the part of the mesh where `depth` is positive, by quadrature over clipped
/// polygons.
Matrix6d reference_share(const TriMesh& mesh, const AddedMassSolution& solution,
                         const std::function<long double(const support::Vector3l&)>& depth) {
  Matrix6d share = Matrix6d::Zero();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const support::Polygon face = polygon(mesh, f);
    const support::Polygon wet = support::clip(face, depth);
    if (wet.size() < 3) continue;
    const support::Vector3l n = (face[1] - face[0]).cross(face[2] - face[0]).normalized();
    for (int m = 0; m < 6; ++m) {
      const auto psi = interpolated(face, solution.potentials[static_cast<std::size_t>(f)].row(m));
      share.block<1, 3>(m, 0) +=
          support::integrate(wet, [&](const auto& r) -> support::Vector3l { return psi(r) * n; })
              .cast<double>()
              .transpose();
      share.block<1, 3>(m, 3) +=
          support::integrate(
              wet, [&](const auto& r) -> support::Vector3l { return psi(r) * r.cross(n); })
              .cast<double>()
              .transpose();
    }
  }
  return share;
}

/// ψ_m = x_m / 2, as on a sphere of 1 m, without a solver's errors.
AddedMassSolution smooth_sphere(const TriMesh& mesh) {
  AddedMassSolution solution;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::array<Vector3d, 3> corners;
    hydro::CornerPotentials psi = hydro::CornerPotentials::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = mesh.vertices.col(mesh.faces(static_cast<Index>(i), f));
      psi.col(static_cast<Index>(i)).head<3>() = corners[i] / 2;
    }
    solution.matrix += symmetric(hydro::triangle_share(corners, psi));
    solution.potentials.push_back(psi);
  }
  return solution;
}

TEST(WettedAddedMass, OfASphereHalfUnderHasHalfOfItsHeave) {
  for (const TriMesh& mesh : {hydro::make_sphere(1, 16, 8), hydro::make_sphere(1, 7, 9)}) {
    const AddedMassSolution solution = smooth_sphere(mesh);
    const WettedAddedMass model(mesh, solution);
    for (const double density : {1.0, 1025.0}) {
      const double heave = model.at(at_height(0), {.density = density}, 0)(2, 2);
      const double half = density * solution.matrix(2, 2) / 2;
      EXPECT_NEAR(heave, half, tolerance(1e-12) * half);
    }
  }
}

TEST(WettedAddedMass, OfBothHalvesOfASolvedSphereIsThatOfTheWhole) {
  const TriMesh mesh = hydro::make_sphere(1, 16, 8);
  const AddedMassSolution solution = coarse(mesh);
  const WettedAddedMass model(mesh, solution);
  const Eigen::Quaterniond over(Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitX()));
  const double lower = model.at(at_height(0), {.density = 1}, 0)(2, 2);
  const double upper = model.at({.orientation = over}, {.density = 1}, 0)(2, 2);
  const double whole = solution.matrix(2, 2);
  EXPECT_NEAR(lower + upper, whole, tolerance(1e-12) * whole);
}

/// The solver keeps the symmetries of a mesh, whatever the order of its faces and corners.
TEST(WettedAddedMass, OfASolvedSphereHalfUnderHasHalfOfItsHeave) {
  for (const TriMesh& mesh :
       {hydro::make_icosphere(1, 2), hydro::make_sphere(1, 16, 8), hydro::make_sphere(1, 12, 10)}) {
    const AddedMassSolution solution = coarse(mesh);
    const double half = solution.matrix(2, 2) / 2;
    const double heave = WettedAddedMass(mesh, solution).at(at_height(0), {.density = 1}, 0)(2, 2);
    // Round-off of 1e-15 in each of some thousand equations, and of their solution.
    EXPECT_NEAR(heave, half, tolerance(1e-12) * half);
  }
}

TEST(WettedAddedMass, IsThatOfTheWholeBodyOrZeroWhereNothingIsCut) {
  support::Random random(3);
  const TriMesh mesh = star(random);
  const AddedMassSolution solution = coarse(mesh);
  const WettedAddedMass model(mesh, solution);
  EXPECT_LT(difference(model.whole(), solution.matrix), tolerance(1e-6));
  for (const Sea& sea : {Sea{}, short_waves()}) {
    // Submerged by its box only, and by the sphere around it too.
    EXPECT_EQ(model.at(at_height(-1.65), sea, 0), 1000 * model.whole());
    EXPECT_EQ(model.at(at_height(-1e6), sea, 0), 1000 * model.whole());
    EXPECT_EQ(model.at(at_height(1.65), sea, 0), Matrix6d::Zero());
    EXPECT_EQ(model.at(at_height(1e6), sea, 0), Matrix6d::Zero());
  }
}

TEST(WettedAddedMass, IsTheIntegralOverTheClippedFaces) {
  support::Random random(5);
  const TriMesh mesh = star(random);
  const AddedMassSolution solution = coarse(mesh);
  const WettedAddedMass model(mesh, solution);
  for (int k = 0; k < support::repeats(8); ++k) {
    BodyState state = random.state(1e6, 1);
    const Sea sea = {.density = 1025, .level = state.position.z() + random.uniform(-1, 1)};
    const Matrix3d R = state.orientation.toRotationMatrix();
    const double level = sea.level - state.position.z();
    const Matrix6d reference = reference_share(mesh, solution, [&](const support::Vector3l& r) {
      return level - (R.row(2).cast<long double>() * r)(0);
    });
    EXPECT_LT(difference(1025 * hydro::semi_definite_part(reference), model.at(state, sea, 0)),
              kRoundOff);
  }
}

/// Seas with a flat surface, with waves that bend over large faces and with a grid of heights.
std::vector<Sea> seas() {
  Sea grid{.density = 1025};
  Eigen::MatrixXd heights(40, 50);
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 50; ++column)
      heights(row, column) = 0.2 * std::cos(0.4 * column) + 0.1 * std::cos(0.5 * row + 1);
  grid.surface = hydro::make_height_field(heights, 0.2, {-4, -4});
  Sea long_wave{.density = 1025, .level = 0.2};
  long_wave.surface = hydro::WaveSurface{{hydro::deep_water_wave(0.3, 40, 0.4, 1, 9.81)}};
  return {{.density = 1025}, short_waves(), long_wave, grid};
}

/// Potentials near x_m / 2 that jump from face to face.
AddedMassSolution any_solution(const TriMesh& mesh, support::Random& random) {
  AddedMassSolution solution = smooth_sphere(mesh);
  solution.matrix.setZero();
  for (Index f = 0; f < mesh.face_count(); ++f) {
    hydro::CornerPotentials& psi = solution.potentials[static_cast<std::size_t>(f)];
    for (double& value : psi.reshaped()) value += random.uniform(-0.1, 0.1);
    std::array<Vector3d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = mesh.vertices.col(mesh.faces(static_cast<Index>(i), f));
    solution.matrix += symmetric(hydro::triangle_share(corners, psi));
  }
  return solution;
}

TEST(WettedAddedMass, AgreesWithThePlainSum) {
  support::Random random(17);
  // Large faces, many faces, a thin plate with slivers, and a rough body.
  const std::vector<TriMesh> meshes = {hydro::make_box({2, 1.5, 1}), hydro::make_icosphere(1, 3),
                                       hydro::make_cylinder(1, 0.02, 40, 2), star(random)};
  for (const TriMesh& mesh : meshes) {
    const AddedMassSolution solution = any_solution(mesh, random);
    const WettedAddedMass model(mesh, solution);
    const double whole = 1025 * solution.matrix.cwiseAbs().maxCoeff();
    for (const Sea& sea : seas()) {
      for (int k = 0; k < support::repeats(5); ++k) {
        const BodyState state = {.position = random.vector(0.5), .orientation = random.rotation()};
        const Matrix6d plain = hydro::plain_wetted_added_mass(mesh, solution, state, sea, 0.7);
        const Matrix6d error = plain - model.at(state, sea, 0.7);
        EXPECT_LT(error.cwiseAbs().maxCoeff(), tolerance(1e-12) * whole)
            << mesh.face_count() << " faces, sea " << sea.surface.index() << ' ' << sea.level;
      }
    }
  }
}

/// The sea turned with the body about the y axis, given by its heights, is another sea with the
/// same added mass in body axes.
TEST(WettedAddedMass, InASeaThatSlopesAsAPlaneIsThatOfTheTurnedBody) {
  support::Random random(7);
  const TriMesh mesh = star(random);
  const WettedAddedMass model(mesh, coarse(mesh));
  const double angle = 0.3;
  Eigen::MatrixXd heights(2, 2);
  heights << -10, 10, -10, 10;
  Sea sloping;
  sloping.surface = hydro::make_height_field(std::tan(angle) * heights, 20, {-10, -10});
  for (int k = 0; k < support::repeats(8); ++k) {
    const BodyState flat = {.position = random.vector(0.8), .orientation = random.rotation()};
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(-angle, Vector3d::UnitY()));
    const BodyState turned = {.position = turn * flat.position,
                              .orientation = turn * flat.orientation};
    EXPECT_LT(difference(model.at(flat, Sea{}, 0), model.at(turned, sloping, 0)),
              tolerance(1e-12));  // one more turn, and tan(0.3) in the heights
  }
}

/// Each face in four, the potentials as they are at the new corners.
std::pair<TriMesh, AddedMassSolution> split(const TriMesh& mesh, const AddedMassSolution& of_mesh) {
  const Index faces = mesh.face_count();
  TriMesh finer{Eigen::Matrix3Xd(3, 12 * faces), Eigen::Matrix3Xi(3, 4 * faces)};
  AddedMassSolution solution = of_mesh;
  solution.potentials.clear();
  const double h = 0.5;
  std::array<Matrix3d, 4> weights;  // barycentric coordinates of the corners, a column each
  weights[0] << 1, h, h, 0, h, 0, 0, 0, h;
  weights[1] << h, 0, 0, h, 1, h, 0, 0, h;
  weights[2] << h, 0, 0, 0, h, 0, h, h, 1;
  weights[3] << h, 0, h, h, h, 0, 0, h, h;
  for (Index f = 0; f < faces; ++f) {
    Matrix3d corners;
    for (int i = 0; i < 3; ++i) corners.col(i) = mesh.vertices.col(mesh.faces(i, f));
    for (std::size_t k = 0; k < 4; ++k) {
      const Index piece = 4 * f + static_cast<Index>(k);
      finer.vertices.middleCols(3 * piece, 3) = corners * weights[k];
      finer.faces.col(piece) << Eigen::Vector3i::LinSpaced(3, 3 * static_cast<int>(piece),
                                                           3 * static_cast<int>(piece) + 2);
      solution.potentials.push_back(of_mesh.potentials[static_cast<std::size_t>(f)] * weights[k]);
    }
  }
  return {finer, solution};
}

TEST(WettedAddedMass, InShortWavesDoesNotDependOnTheSizeOfTheFaces) {
  const TriMesh box = hydro::make_box({2, 1.5, 1}, 1);
  const AddedMassSolution of_box = coarse(box);
  auto [finer, solution] = split(box, of_box);
  for (int i = 0; i < 3; ++i) std::tie(finer, solution) = split(finer, solution);
  const WettedAddedMass model(box, of_box);
  const WettedAddedMass fine(finer, solution);
  support::Random random(9);
  for (int k = 0; k < support::repeats(6); ++k) {
    const BodyState state = {.position = random.vector(0.3), .orientation = random.rotation()};
    // The surface departs from linear by kSagTolerance of its deviation, of either sign.
    EXPECT_LT(difference(fine.at(state, short_waves(), 1), model.at(state, short_waves(), 1)),
              tolerance(hydro::kSagTolerance));
  }
}

TEST(WettedAddedMass, IsSymmetricAndTakesWorkForEveryMotion) {
  support::Random random(11);
  for (int k = 0; k < support::repeats(4); ++k) {
    const TriMesh mesh = star(random);
    const WettedAddedMass model(mesh, coarse(mesh));
    for (int i = 0; i < 50; ++i) {
      const BodyState state = {.position = random.vector(1.2), .orientation = random.rotation()};
      const Matrix6d A = model.at(state, i % 5 == 0 ? short_waves() : Sea{}, 0);
      EXPECT_EQ(A, A.transpose());
      const hydro::Vector6d eigenvalues = hydro::eigenvalues(A);
      EXPECT_GE(eigenvalues[0], -tolerance(1e-14) * eigenvalues[5]);
    }
  }
}

TEST(MovedOrigin, GivesTheIntegralsAboutTheNewOrigin) {
  support::Random random(13);
  const TriMesh mesh = star(random);
  const Vector3d p(0.4, -0.3, 0.8);
  const AddedMassSolution moved = hydro::moved_origin(coarse(mesh), p);
  const TriMesh mesh_there = hydro::translated(mesh, -p);
  const Matrix6d sum =
      reference_share(mesh_there, moved, [](const support::Vector3l&) { return 1.0L; });
  EXPECT_LT(difference(moved.matrix, symmetric(sum)), kRoundOff);
  // Solved there it is the same but for the integrals over pairs of panels, good to 1e-5.
  const AddedMassSolution solved = coarse(mesh_there);
  EXPECT_LT(difference(solved.matrix, moved.matrix), tolerance(1e-4));
  for (std::size_t f = 0; f < solved.potentials.size(); ++f)
    EXPECT_LT((solved.potentials[f] - moved.potentials[f]).cwiseAbs().maxCoeff(), tolerance(1e-2));
}

TEST(SemiDefinitePart, KeepsWhatIsNotNegative) {
  const Eigen::Matrix<double, 6, 1> values{3, 2, 1, 0, -1, -2};
  support::Random random(15);
  Matrix6d any;
  for (double& entry : any.reshaped()) entry = random.uniform(-1, 1);
  const Matrix6d turn = any.householderQr().householderQ();
  const Matrix6d matrix = turn * values.asDiagonal() * turn.transpose();
  const Matrix6d expected = turn * values.cwiseMax(0).asDiagonal() * turn.transpose();
  EXPECT_LT(difference(expected, hydro::semi_definite_part(matrix)), kRoundOff);
  EXPECT_LT(difference(expected, hydro::semi_definite_part(expected)), kRoundOff);
}

/// A body in waves of some wavelengths, near the surface and below it.
Sea two_waves(double depth) {
  Sea sea{.density = 1025, .depth = depth};
  sea.surface = hydro::WaveSurface{
      {hydro::linear_wave(sea, 0.2, 0.5, 0.4, 0.2), hydro::linear_wave(sea, 0.1, 0.9, -1.1, 2)}};
  return sea;
}

TEST(WaveLoad, IsThatOfThePlainSum) {
  support::Random random(31);
  const TriMesh mesh = hydro::make_icosphere(1, 3);
  AddedMassSolution solution = smooth_sphere(mesh);
  for (auto& psi : solution.potentials)  // as uneven as the potentials of some body
    for (int m = 0; m < 6; ++m) psi.row(m).array() += random.uniform(-0.1, 0.1);
  const WettedAddedMass model(mesh, solution);
  for (const double depth : {std::numeric_limits<double>::infinity(), 4.0}) {
    const Sea sea = two_waves(depth);
    for (int i = 0; i < support::repeats(20); ++i) {
      const BodyState state{
          .position = {random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-1.6, 1)},
          .orientation = random.rotation()};
      const hydro::Wrench fast = model.wave_load(state, sea, 1.5);
      const hydro::Wrench plain = hydro::plain_wave_load(mesh, solution, state, sea, 1.5);
      const double scale = sea.density * 4;  // of some m³ accelerated by 1 m/s²
      EXPECT_LT((fast.force - plain.force).norm(), tolerance(1e-3) * scale);
      EXPECT_LT((fast.moment - plain.moment).norm(), tolerance(1e-3) * scale);
    }
  }
}

/// (6) on a deep sphere is ½ρV u̇ at its centre for every length of the waves: the mean of a
/// harmonic function.
TEST(WaveLoad, OnADeepSphereIsThatOfItsCentre) {
  const TriMesh mesh = hydro::make_icosphere(1, 4);
  const AddedMassSolution solution = smooth_sphere(mesh);
  const double volume = hydro::solid_properties(mesh).volume;
  for (const double kR : {0.1, 0.5, 1.0, 2.0}) {
    Sea sea;
    sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, 1e-4, kR, 0.4, 0.3)}};
    const BodyState state{.position = {0.2, 0.1, -1.5}};
    const Vector3d u = hydro::water_at(sea, state.position, 0.7).acceleration;
    const hydro::Wrench load = hydro::plain_wave_load(mesh, solution, state, sea, 0.7);
    EXPECT_LT((load.force - 0.5 * sea.density * volume * u).norm(), 5e-3 * load.force.norm())
        << "kR = " << kR;
    EXPECT_LT(load.moment.norm(), 5e-3 * load.force.norm());
  }
}

TEST(WaveLoad, InAUniformFlowIsTheAddedMassTimesItsAcceleration) {
  support::Random random(32);
  Sea sea;
  sea.surface = hydro::WaveSurface{{hydro::linear_wave(sea, 2, 1e-5, 0.4, 0.3)}};
  for (int i = 0; i < support::repeats(5); ++i) {
    const TriMesh mesh = star(random);
    const AddedMassSolution solution = coarse(mesh);
    const BodyState state{.position = {0, 0, random.uniform(-2, 2)},
                          .orientation = random.rotation()};
    const Vector3d u = hydro::water_at(sea, state.position, 0).acceleration;
    const hydro::ConstantAddedMass constant(mesh, 1000 * solution.matrix);
    const WettedAddedMass wetted(mesh, solution);
    for (const hydro::AddedMassModel* model :
         {static_cast<const hydro::AddedMassModel*>(&constant),
          static_cast<const hydro::AddedMassModel*>(&wetted)}) {
      const hydro::Wrench load = model->wave_load(state, sea, 0);
      const hydro::Vector6d A_u =
          model->at(state, sea, 0).leftCols<3>() * (state.orientation.conjugate() * u);
      const Vector3d force = state.orientation * A_u.head<3>();
      const Vector3d moment = state.orientation * A_u.tail<3>();
      EXPECT_LT((load.force - force).norm(), 1e-4 * force.norm());
      EXPECT_LT((load.moment - moment).norm(), 1e-4 * force.norm());
    }
  }
}

}  // namespace
