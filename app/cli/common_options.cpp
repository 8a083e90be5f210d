#include "app/cli/common_options.h"

#include <CLI/CLI.hpp>

namespace app {

CLI::Option* add_sets(CLI::App* command, std::vector<std::string>& sets, const char* what) {
  return command->add_option("--set", sets, what)
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

CLI::Option* add_any_format(CLI::App* command, scene::MeshFormats& formats) {
  return command->add_flag_callback(
      "--any-format", [&formats] { formats = scene::MeshFormats::any; },
      "Read meshes in any format, beyond .obj, .stl, .ply, .off, .gltf and .glb");
}

}  // namespace app
