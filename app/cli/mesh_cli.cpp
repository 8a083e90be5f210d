#include "app/cli/mesh_cli.h"

#include <CLI/CLI.hpp>
#include <string>

#include "app/cli/common_options.h"

namespace app {

void add_mesh(CLI::App& program, MeshCommand& command) {
  CLI::App* mesh = program.add_subcommand(
      "mesh", "Say what a mesh file is, and make a solid of it where that is possible");
  mesh->add_option("file", command.file, "Mesh file")->type_name("FILE")->required();
  mesh->add_flag(
      "--repair", command.repair,
      "Weld cracks, stitch T-junctions, drop repeated faces and those without area, turn "
      "faces outward");
  mesh->add_option("--weld", command.mending.weld,
                   "Widest crack that is closed [m] [1e-5 of the diagonal]")
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("M");
  mesh->add_flag("--cap", command.mending.cap, "Fill flat open loops");
  mesh->add_option_function<std::string>(
          "--mirror",
          [&command](const std::string& word) { command.mending.mirror = word[0] - 'x'; },
          "Add the mirror image of a half in the plane through the origin normal to x, y or z")
      ->check(CLI::IsMember({"x", "y", "z"}).description(""))
      ->type_name("AXIS");
  mesh->add_flag("--unite", command.mending.unite, "Unite closed parts that overlap");
  mesh->add_option("--thickness", command.mending.thickness,
                   "Make plates of this thickness of what is open [m]")
      ->check(CLI::PositiveNumber.description(""))
      ->type_name("M");
  mesh->add_option("-o,--out", command.out, "Write the mesh, in metres with z up: .obj or .stl")
      ->type_name("OUT");
  add_mesh_frame(mesh, command.frame);
  add_any_format(mesh, command.formats);
}

}  // namespace app
