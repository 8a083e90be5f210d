#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "app/assembly/added_mass_store.h"
#include "app/assembly/build.h"
#include "app/assembly/build_added_mass.h"
#include "app/assembly/mesh_io.h"
#include "app/assembly/radiation_store.h"
#include "app/hydrostatics/hydrostatics.h"
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/threads.h"
#include "app/scene/diagnostics.h"
#include "hydro/added_mass/added_mass.h"
#include "hydro/interior/lids.h"
#include "hydro/mesh/mass_properties.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/primitives.h"
#include "hydro/parallel.h"
#include "hydro/radiation/radiation_solve.h"

namespace python {
namespace {

using hydro::TriMesh;

TriMesh mesh_from(const Array& vertices,
                  const py::array_t<int, py::array::c_style | py::array::forcecast>& faces) {
  if (vertices.ndim() != 2 || vertices.shape(1) != 3)
    throw py::value_error("vertices: expected an array of V rows of three numbers");
  if (faces.ndim() != 2 || faces.shape(1) != 3)
    throw py::value_error("faces: expected an array of F rows of three indices");
  TriMesh mesh;
  mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(vertices.data(), 3, vertices.shape(0));
  mesh.faces = Eigen::Map<const Eigen::Matrix3Xi>(faces.data(), 3, faces.shape(0));
  if (mesh.faces.size() > 0 &&
      (mesh.faces.minCoeff() < 0 || mesh.faces.maxCoeff() >= mesh.vertices.cols()))
    throw py::value_error("faces: an index names no vertex");
  return mesh;
}

/// @throws py::value_error with every fault unless the mesh bounds a solid
const TriMesh& solid(const TriMesh& mesh) {
  const std::vector<std::string> faults = hydro::describe(hydro::check_mesh(mesh));
  if (faults.empty()) return mesh;
  std::string text = "the mesh is no solid";
  for (const std::string& fault : faults) text += "; " + fault;
  throw py::value_error(text);
}

Eigen::Vector3d center_of(const TriMesh& mesh, const py::object& center) {
  return center.is_none() ? hydro::solid_properties(mesh).centroid
                          : to_vector(center.cast<Array>(), "center_of_mass");
}

/// Runs `work` without the GIL on some threads.
template <class Work>
auto computed(int threads, Work&& work) {
  const Unlocked unlocked;
  return shared_threads(threads).execute(std::forward<Work>(work));
}

/// The matrix, and what is known of its error, about the centre of mass.
py::dict added_mass(const TriMesh& mesh, double density, const py::object& center, double tolerance,
                    int threads) {
  const Eigen::Vector3d com = center_of(solid(mesh), center);
  const Eigen::Vector3d centroid = hydro::solid_properties(mesh).centroid;
  const hydro::AddedMassOptions options{.tolerance = tolerance};
  const hydro::AddedMassSolution solution = computed(threads, [&] {
    const TriMesh mesh_C = hydro::translated(mesh, -centroid);
    assembly::AddedMassStore store(assembly::cache_folder());
    const assembly::StoredAddedMass stored =
        assembly::solved_added_mass("the mesh", mesh_C, options, store, app::quiet());
    return hydro::moved_origin(*stored.solution, com - centroid);
  });
  py::dict result;
  result["matrix"] = to_array(Eigen::MatrixXd(density * solution.matrix));
  result["error_estimate"] = solution.error_estimate;
  result["panels"] = solution.panels;
  return result;
}

/// Stacks a matrix for each frequency: (F, rows, columns), transposed where asked.
template <class Number, class Matrix>
py::array stacked(const std::vector<Matrix>& matrices, double factor, bool transposed) {
  const Eigen::Index rows = matrices.front().rows(), columns = matrices.front().cols();
  py::array_t<Number> array({static_cast<py::ssize_t>(matrices.size()),
                             static_cast<py::ssize_t>(transposed ? columns : rows),
                             static_cast<py::ssize_t>(transposed ? rows : columns)});
  Number* number = array.mutable_data();
  for (const Matrix& matrix : matrices)
    for (Eigen::Index i = 0; i < (transposed ? columns : rows); ++i)
      for (Eigen::Index j = 0; j < (transposed ? rows : columns); ++j)
        *number++ = factor * (transposed ? matrix(j, i) : matrix(i, j));
  return array;
}

py::dict radiation(const TriMesh& mesh, const py::object& height, const py::object& orientation,
                   const py::object& center, const py::object& frequencies, double density,
                   double gravity, double depth, int headings, int threads) {
  const Eigen::Vector3d com = center_of(solid(mesh), center);
  hydro::MeanPose pose;
  if (!orientation.is_none())
    pose.orientation = to_rotation(orientation.cast<Array>(), "orientation");
  pose.height = height.is_none() ? com.z() : height.cast<double>();
  hydro::RadiationOptions options{.headings = headings};
  if (!frequencies.is_none()) options.frequencies = frequencies.cast<std::vector<double>>();
  if (headings < 0 || headings % 2 != 0) throw py::value_error("headings: expected an even number");
  for (std::size_t i = 0; i < options.frequencies.size(); ++i)
    if (!(options.frequencies[i] > (i == 0 ? 0 : options.frequencies[i - 1])))
      throw py::value_error("frequencies: expected positive, ascending numbers");
  const hydro::LinearWater water{.gravity = gravity, .depth = depth};
  const std::shared_ptr<const hydro::RadiationSolution> solution = computed(threads, [&] {
    assembly::RadiationStore store(assembly::cache_folder());
    const TriMesh mesh_B = hydro::translated(mesh, -com);
    return assembly::solved_radiation(
               "the mesh", {.mesh_B = mesh_B, .pose = pose, .water = water, .options = options},
               store, app::quiet())
        .solution;
  });
  const hydro::RadiationData& data = solution->data;
  py::dict result;
  result["frequencies"] = to_array(data.frequencies);
  result["headings"] = to_array(data.headings);
  result["added_mass"] = stacked<double>(data.added_mass, density, false);
  result["damping"] = stacked<double>(data.damping, density, false);
  result["infinite_added_mass"] = to_array(Eigen::MatrixXd(density * data.infinite_added_mass));
  result["froude_krylov"] = stacked<std::complex<double>>(data.froude_krylov, density, true);
  result["diffraction"] = stacked<std::complex<double>>(data.diffraction, density, true);
  return result;
}

py::object hydrostatics(const TriMesh& mesh, double mass, double density, const py::object& center,
                        double gravity, const py::object& orientation,
                        const std::vector<double>& heels) {
  if (!(mass > 0 && density > 0 && gravity > 0))
    throw py::value_error("expected a positive mass, density and gravity");
  app::FloatingBody body{.name = "body",
                         .com_M = center_of(solid(mesh), center),
                         .mass = mass,
                         .density = density,
                         .gravity = gravity};
  body.mesh_B = hydro::translated(mesh, -body.com_M);
  if (!orientation.is_none()) body.start = to_rotation(orientation.cast<Array>(), "orientation");
  std::string text;
  {
    const Unlocked unlocked;
    text = app::floating_json({app::floating_report(body, heels)});
  }
  return py::module_::import("json").attr("loads")(text)["bodies"]["body"];
}

/// The sea and the coefficients of blocks of a scene, for a body of another mesh.
struct Water {
  hydro::Sea sea;
  hydro::Coefficients coefficients;
};

Water water_from(const TriMesh& mesh_B, const py::object& water, const py::object& air,
                 const py::object& hydro_block) {
  py::dict body, scene;
  body["name"] = "body";
  body["box"] = py::dict(py::arg("size") = py::make_tuple(1, 1, 1));
  body["mass"] = 1;
  if (!hydro_block.is_none()) body["hydro"] = hydro_block;
  py::list bodies;
  bodies.append(body);
  scene["plimsoll"] = 1;
  scene["duration"] = 0;
  scene["water"] = water.is_none() ? py::object(py::dict()) : water;
  if (!air.is_none()) scene["air"] = air;
  scene["bodies"] = bodies;
  const std::shared_ptr<SceneSource> source = scene_from(scene, py::none());
  const Unlocked unlocked;
  const assembly::BuiltScene built = assembly::build_without_added_mass(source->scene());
  return {.sea = *built.spec.sea,
          .coefficients = hydro::for_mesh(source->scene().bodies.front().hydro, mesh_B,
                                          source->scene().water->viscosity)};
}

py::array wrench_array(const hydro::Wrench& wrench) {
  hydro::Vector6d six;
  six << wrench.force, wrench.moment;
  return to_array(six);
}

py::dict loads(const TriMesh& mesh, const py::object& position, const py::object& orientation,
               const py::object& velocity, const py::object& angular_velocity,
               const py::object& center, const py::object& water, const py::object& air,
               const py::object& hydro_block, double time) {
  const Eigen::Vector3d com = center_of(solid(mesh), center);
  const hydro::BodyState state =
      moved({.position = com}, position, orientation, velocity, angular_velocity);
  const TriMesh mesh_B = hydro::translated(mesh, -com);
  const Water around = water_from(mesh_B, water, air, hydro_block);
  hydro::Loads found;
  {
    const Unlocked unlocked;
    found = hydro::compute_loads(hydro::make_hull(mesh_B), state, around.sea, time,
                                 around.coefficients);
  }
  py::dict result;
  result["buoyancy"] = wrench_array(found.buoyancy);
  result["pressure_drag"] = wrench_array(found.pressure_drag);
  result["viscous_drag"] = wrench_array(found.viscous_drag);
  result["lift"] = wrench_array(found.lift);
  result["wind"] = wrench_array(found.wind);
  result["total"] = wrench_array(found.total());
  result["wetted_area"] = found.wetted_area;
  result["displaced_volume"] = found.displaced_volume;
  return result;
}

/// Finds a word of a scene. @throws ValueError for another word
template <class T>
std::optional<T> chosen(const std::optional<std::string>& word, const char* argument,
                        const std::vector<std::pair<std::string, T>>& choices) {
  if (!word) return std::nullopt;
  std::string known;
  for (const auto& [name, value] : choices) {
    if (name == *word) return value;
    known += (known.empty() ? "" : ", ") + name;
  }
  throw py::value_error(std::string(argument) + ": found " + *word + ", expected one of " + known);
}

TriMesh loaded(const std::filesystem::path& file, bool any_format,
               const std::optional<std::string>& up, const std::optional<std::string>& unit,
               double scale) {
  if (!(scale > 0 && std::isfinite(scale)))
    throw py::value_error("scale: expected a positive number");
  const scene::MeshFrame frame{.up = chosen(up, "up", scene::up_axes()),
                               .unit = chosen(unit, "unit", scene::length_units()),
                               .scale = scale};
  const Unlocked unlocked;
  return assembly::read_solid(file, app::quiet(), formats_from(any_format), frame);
}

double area(const TriMesh& mesh) {
  double area = 0;
  for (Eigen::Index f = 0; f < mesh.face_count(); ++f) area += hydro::area_vector(mesh, f).norm();
  return area;
}

void bind_mesh(py::module_& module) {
  py::class_<TriMesh>(module, "Mesh",
                      "A triangle mesh. Faces are counter-clockwise seen from outside; lengths are "
                      "in metres.")
      .def(py::init(&mesh_from), py::arg("vertices"), py::arg("faces"),
           "vertices (V, 3) [m]; faces (F, 3): indices of vertices.")
      .def_static(
          "load", &loaded, py::arg("file"), py::arg("any_format") = false,
          py::arg("up") = py::none(), py::arg("unit") = py::none(), py::arg("scale") = 1.0,
          "Reads a mesh file that bounds a solid; one that is inward as a whole is "
          "reversed. any_format: formats beyond .obj, .stl, .ply, .off, .gltf and .glb are "
          "read, too. up (x, y, z, -x, -y, -z), unit (mm, cm, m, in, ft) and scale: as in a "
          "scene. Raises SceneError with what is wrong.")
      .def_static(
          "box",
          [](const Array& size, int divisions) {
            return hydro::make_box(to_vector(size, "size"), divisions);
          },
          py::arg("size"), py::arg("divisions") = 1,
          "size (3,) [m]; 12 divisions² triangles about the origin.")
      .def_static("sphere", &hydro::make_sphere, py::arg("radius"), py::arg("slices") = 32,
                  py::arg("stacks") = 16,
                  "radius [m]; 2 slices (stacks - 1) triangles about the origin, poles on z.")
      .def_static("icosphere", &hydro::make_icosphere, py::arg("radius"),
                  py::arg("subdivisions") = 3,
                  "radius [m]; 20 · 4^subdivisions triangles about the origin.")
      .def_static("cylinder", &hydro::make_cylinder, py::arg("radius"), py::arg("height"),
                  py::arg("slices") = 32, py::arg("stacks") = 8,
                  "radius and height [m], about z and the origin.")
      .def_static(
          "ellipsoid",
          [](const Array& axes, int slices, int stacks) {
            return hydro::make_ellipsoid(to_vector(axes, "semi_axes"), slices, stacks);
          },
          py::arg("semi_axes"), py::arg("slices") = 32, py::arg("stacks") = 16,
          "semi_axes (3,) [m], about the origin.")
      .def_property_readonly(
          "vertices",
          [](const TriMesh& mesh) { return to_array(Eigen::MatrixXd(mesh.vertices.transpose())); },
          "(V, 3) [m], a copy.")
      .def_property_readonly(
          "faces",
          [](const TriMesh& mesh) {
            py::array_t<int> faces({mesh.faces.cols(), Eigen::Index{3}});
            std::copy_n(mesh.faces.data(), mesh.faces.size(), faces.mutable_data());
            return faces;
          },
          "(F, 3): indices of vertices, a copy.")
      .def_property_readonly(
          "volume", [](const TriMesh& mesh) { return hydro::solid_properties(mesh).volume; },
          "[m^3]")
      .def_property_readonly("area", &area, "[m^2]")
      .def_property_readonly(
          "centroid",
          [](const TriMesh& mesh) { return to_array(hydro::solid_properties(mesh).centroid); },
          "(3,): of the volume [m].")
      .def_property_readonly(
          "inertia",
          [](const TriMesh& mesh) {
            return to_array(Eigen::MatrixXd(hydro::solid_properties(mesh).inertia));
          },
          "(3, 3): about the centroid for density 1 [m^5].")
      .def(
          "faults", [](const TriMesh& mesh) { return hydro::describe(hydro::check_mesh(mesh)); },
          "Why the mesh bounds no solid, a sentence each; empty if it does.")
      .def(
          "moved",
          [](const TriMesh& mesh, const Array& by) {
            return hydro::translated(mesh, to_vector(by, "by"));
          },
          py::arg("by"), "The mesh moved by (3,) [m].")
      .def(
          "scaled", [](const TriMesh& mesh, double f) { return hydro::scaled(mesh, f); },
          py::arg("factor"), "The mesh scaled about its origin.")
      .def("__repr__", [](const TriMesh& mesh) {
        return fmt::format("<Mesh of {} triangles on {} vertices>", mesh.face_count(),
                           mesh.vertex_count());
      });
}

}  // namespace

void bind_hydro(py::module_& module) {
  bind_mesh(module);
  const auto none = py::none();
  module.def(
      "loads", &loads, py::arg("mesh"), py::kw_only(), py::arg("position") = none,
      py::arg("orientation") = none, py::arg("velocity") = none, py::arg("angular_velocity") = none,
      py::arg("center_of_mass") = none, py::arg("water") = none, py::arg("air") = none,
      py::arg("hydro") = none, py::arg("time") = 0.0,
      "The loads of water and wind on a body in a state of motion: each as (6,), force [N] "
      "and moment [N m] about the centre of mass, in W; `wetted_area` [m^2] and "
      "`displaced_volume` [m^3].\n\n"
      "position (3,) of the centre of mass, by default where the mesh has it; orientation "
      "(4,); velocity and angular_velocity (3,), in W; center_of_mass (3,), in the frame of "
      "the mesh, by default its centroid. water, air, hydro: dicts as in a scene. time [s].");
  module.def("added_mass", &added_mass, py::arg("mesh"), py::kw_only(), py::arg("density") = 1000.0,
             py::arg("center_of_mass") = none,
             py::arg("tolerance") = hydro::AddedMassOptions().tolerance, py::arg("threads") = 0,
             "The added mass of a wholly submerged body: `matrix` (6, 6) about the centre of mass, "
             "surge to yaw [kg, kg m, kg m^2], its relative `error_estimate`, and the number of "
             "`panels`. Solutions are kept in the user's cache.");
  module.def("radiation", &radiation, py::arg("mesh"), py::kw_only(), py::arg("height") = none,
             py::arg("orientation") = none, py::arg("center_of_mass") = none,
             py::arg("frequencies") = none, py::arg("density") = 1000.0,
             py::arg("gravity") = hydro::LinearWater().gravity,
             py::arg("depth") = hydro::LinearWater().depth,
             py::arg("headings") = hydro::RadiationOptions().headings, py::arg("threads") = 0,
             "The waves that a floating body makes and scatters, by boundary elements.\n\n"
             "height: of the centre of mass above the still water [m], by default its z in the "
             "mesh; frequencies: ascending [rad/s], by default sixteen that suit the body; depth "
             "[m]; headings: an even number, by default at least 36 and enough for the body.\n\n"
             "Returns frequencies (F,), headings (H,) [rad], added_mass and damping (F, 6, 6), "
             "infinite_added_mass (6, 6), froude_krylov and diffraction (F, H, 6), complex, per "
             "metre of amplitude, for time as exp(-i omega t). They are about the centre of mass.");
  module.def("hydrostatics", &hydrostatics, py::arg("mesh"), py::arg("mass"), py::kw_only(),
             py::arg("density") = 1000.0, py::arg("center_of_mass") = none,
             py::arg("gravity") = hydro::LinearWater().gravity, py::arg("orientation") = none,
             py::arg("heels") = std::vector<double>(),
             "Floating position, stability and, at heels [rad], righting arms of a body, as "
             "`plimsoll hydrostatics --json` gives them: `start` at the given attitude and `rest` "
             "in equilibrium.");
}

}  // namespace python
