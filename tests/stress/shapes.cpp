#include "tests/stress/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/mesh_io.h"
#include "hydro/added_mass/constant_added_mass.h"
#include "hydro/added_mass/deep_added_mass.h"
#include "hydro/interior/lids.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/primitives.h"
#include "hydro/radiation/diffraction_load.h"
#include "hydro/radiation/radiation_solve.h"
#include "hydro/water/hull_sources.h"
#include "hydro/water/simulated_water.h"
#include "tests/stress/run_name.h"
#include "tests/support/hollows.h"

namespace stress {
namespace {

// The solution is accurate enough to stress the mechanics and takes a second.
constexpr hydro::AddedMassOptions kSolver{.tolerance = 0.02, .most_panels = 1500};

hydro::TriMesh stored_mesh(const std::string& name) {
  return assembly::read_mesh(std::string(PLIMSOLL_SOURCE_DIR) + "/scenes/meshes/" + name + ".obj");
}

/// Returns the mesh with every triangle cut into four at the midpoints of its edges.
hydro::TriMesh quartered(const hydro::TriMesh& mesh) {
  std::map<std::pair<int, int>, int> middles;
  std::vector<Eigen::Vector3d> added;
  const auto middle = [&](int a, int b) {
    const int next = static_cast<int>(mesh.vertex_count()) + static_cast<int>(added.size());
    const auto [place, is_new] = middles.try_emplace(std::minmax(a, b), next);
    if (is_new) added.push_back((mesh.vertices.col(a) + mesh.vertices.col(b)) / 2);
    return place->second;
  };
  hydro::TriMesh fine{.vertices = mesh.vertices,
                      .faces = Eigen::Matrix3Xi(3, 4 * mesh.faces.cols())};
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) {
    const int a = mesh.faces(0, f), b = mesh.faces(1, f), c = mesh.faces(2, f);
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.faces.middleCols<4>(4 * f) << a, b, c, ab,  //
        ab, bc, ca, bc,                              //
        ca, ab, bc, ca;
  }
  fine.vertices.conservativeResize(3,
                                   mesh.vertex_count() + static_cast<Eigen::Index>(added.size()));
  for (std::size_t i = 0; i < added.size(); ++i)
    fine.vertices.col(mesh.vertex_count() + static_cast<Eigen::Index>(i)) = added[i];
  return fine;
}

hydro::TriMesh raw_mesh(const std::string& name) {
  if (name == "cube") return hydro::make_box({1, 1, 1});
  if (name == "ball" || name == "shell") return hydro::make_icosphere(0.5, 2);
  if (name == "plate") return hydro::make_box({1, 1, 0.01});
  if (name == "needle") return hydro::make_box({1, 0.01, 0.01});
  if (name == "tub") return support::open_box();
  if (name == "tank") return support::divided_box(0.6);
  if (name == "teapot") return stored_mesh("teapot_1k");
  if (name == "teapot80k") return quartered(stored_mesh("teapot_20k"));
  throw std::invalid_argument(fmt::format("'{}' is no shape", name));
}

/// Returns a mesh with largest extent 1 and its centroid in the origin.
hydro::TriMesh unit_mesh(const std::string& name) {
  const hydro::TriMesh mesh = raw_mesh(name);
  const Eigen::Vector3d center = hydro::solid_properties(mesh).centroid;
  return hydro::scaled(hydro::translated(mesh, -center),
                       1 / hydro::bounding_box(mesh).sizes().maxCoeff());
}

/// Returns the mesh with the mouths of its pockets closed, as it is upright.
hydro::TriMesh outside(const hydro::TriMesh& mesh) {
  return hydro::with_lids(mesh, hydro::find_pockets(mesh, Eigen::Vector3d::UnitZ()));
}

/// Returns the solution for a mesh `size` times as large: φ scales with size, and with its square
/// for rotations.
hydro::AddedMassSolution scaled_solution(hydro::AddedMassSolution solution, double size) {
  hydro::Vector6d arm;
  arm << 1, 1, 1, size, size, size;
  solution.matrix = std::pow(size, 3) * arm.asDiagonal() * solution.matrix * arm.asDiagonal();
  for (hydro::CornerPotentials& potentials : solution.potentials)
    potentials = size * arm.asDiagonal() * potentials;
  return solution;
}

std::shared_ptr<const hydro::AddedMassModel> deep(const std::string& shape, double size,
                                                  const engine::BodySpec& body) {
  const hydro::TriMesh unit = outside(unit_mesh(shape));
  assembly::AddedMassStore store(assembly::cache_folder());
  auto stored = store.find(unit, kSolver);
  if (!stored) stored = store.keep(unit, kSolver, hydro::solve_added_mass(unit, kSolver));
  return std::make_shared<hydro::DeepAddedMass>(outside_B(body),
                                                scaled_solution(*stored->solution, size));
}

std::shared_ptr<const hydro::FloatingBody> floating(const engine::BodySpec& body,
                                                    const hydro::Sea& sea) {
  // As for the added mass: accurate enough to stress the mechanics.
  const hydro::RadiationData data =
      hydro::solve_radiation(outside_B(body), {}, {.gravity = sea.gravity}, {.patches = 80}).data;
  auto [load, momentum] = hydro::scattered_waves(data, sea);
  return std::make_shared<hydro::FloatingBody>(outside_B(body), data, std::move(load),
                                               std::move(momentum));
}

/// Shorter horizontal side of the mesh [m].
double breadth_of(const hydro::TriMesh& mesh_B) {
  const Eigen::Vector3d sides =
      mesh_B.vertices.rowwise().maxCoeff() - mesh_B.vertices.rowwise().minCoeff();
  return std::min(sides.x(), sides.y());
}

void add_sources(const hydro::PeriodicSquare& square, const hydro::Sea& sea,
                 engine::BodySpec& body) {
  const hydro::TriMesh& mesh_B = outside_B(body);
  if (breadth_of(mesh_B) < square.cell) return;
  body.sources =
      std::make_shared<const hydro::HullSources>(hydro::make_hull_sources(mesh_B, {}, square, 80));
  body.radiation = hydro::floating_hull(*body.sources, mesh_B, sea);
  body.added_mass = body.radiation;
}

std::shared_ptr<const hydro::AddedMassModel> given(double ratio, const engine::BodySpec& body) {
  const Eigen::Vector3d moments = body.inertia_B.diagonal();
  hydro::Vector6d diagonal;
  diagonal << body.mass, body.mass / 2, body.mass / 4, moments.x() / 2, moments.y(),
      moments.z() / 4;
  hydro::Matrix6d A = (ratio * diagonal).asDiagonal();
  A(0, 4) = A(4, 0) = 0.3 * std::sqrt(A(0, 0) * A(4, 4));
  return std::make_shared<hydro::ConstantAddedMass>(outside_B(body), A);
}

}  // namespace

Shape make_shape(const std::string& name, double size) {
  Shape shape{.mesh_B = hydro::scaled(unit_mesh(name), size)};
  const hydro::SolidProperties solid = hydro::solid_properties(shape.mesh_B);
  // A thin shell has 2/3 m r², a solid ball 2/5 m r².
  const double hollow = name == "shell" ? 5.0 / 3 : 1;
  shape.closed_mesh_B = outside(shape.mesh_B);
  shape.volume = hydro::solid_properties(shape.closed_mesh_B).volume;
  shape.inertia = hollow / solid.volume * solid.inertia;
  return shape;
}

hydro::PeriodicSquare square_for(const engine::BodySpec& body, const hydro::Sea& sea, double step) {
  const hydro::TriMesh& mesh_B = outside_B(body);
  const double cell = std::max(breadth_of(mesh_B) / 4, hydro::smallest_cell(step, sea.gravity));
  return {.cells = 64,
          .cell = cell,
          .deepest = -mesh_B.vertices.row(2).minCoeff(),
          .layers = 5,
          .gravity = sea.gravity,
          .depth = sea.depth};
}

void add_inertia_of_water(const std::string& added, const std::string& shape, double size,
                          const hydro::Sea& sea, double step, engine::BodySpec& body) {
  if (added == "none") return;
  if (added == "simulated") {
    add_sources(square_for(body, sea, step), sea, body);
    return;
  }
  if (added == "waves") {
    body.radiation = floating(body, sea);
    body.added_mass = body.radiation;
  } else if (added == "deep") {
    body.added_mass = deep(shape, size, body);
  } else {
    body.added_mass = given(RunName().with(Key::added, added).number(Key::added), body);
  }
}

}  // namespace stress
