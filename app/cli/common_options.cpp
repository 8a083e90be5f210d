#include "app/cli/common_options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>

namespace app {

CLI::Option* add_sets(CLI::App* command, std::vector<std::string>& sets, const char* what) {
  return command->add_option("--set", sets, what)
      ->type_name("KEY.PATH=VALUE")
      ->allow_extra_args(false)
      ->take_all();
}

void add_mesh_frame(CLI::App* command, scene::MeshFrame& frame) {
  const auto words = [](const auto& choices) {
    std::vector<std::string> all;
    for (const auto& choice : choices) all.push_back(choice.first);
    return all;
  };
  const std::vector<std::string> axes = words(scene::up_axes());
  const std::vector<std::string> units = words(scene::length_units());
  // The axes of a mesh may begin with a dash, which would else begin an option: --up=-y.
  command
      ->add_option_function<std::string>(
          "--up",
          [&frame](const std::string& word) {
            for (const auto& [name, axis] : scene::up_axes())
              if (name == word) frame.up = axis;
          },
          "Axis of a mesh's file that points up: x, y, z, or --up=-y [that of the file, or z]")
      ->check(CLI::IsMember(axes).description(""))
      ->type_name("AXIS");
  command
      ->add_option_function<std::string>(
          "--unit",
          [&frame](const std::string& word) {
            for (const auto& [name, length] : scene::length_units())
              if (name == word) frame.unit = length;
          },
          "Unit of a mesh's file: mm, cm, m, in or ft [that of the file, or m]")
      ->check(CLI::IsMember(units).description(""))
      ->type_name("UNIT");
  command
      ->add_option("--scale", frame.scale, "Factor of a mesh's coordinates, besides the unit [1]")
      ->check(CLI::Validator(
          [](const std::string& word) {
            char* end = nullptr;
            const double factor = std::strtod(word.c_str(), &end);
            const bool right = *end == '\0' && factor > 0 && std::isfinite(factor);
            return right ? "" : "found " + word + ", expected a positive number";
          },
          ""))
      ->type_name("FACTOR");
}

CLI::Option* add_any_format(CLI::App* command, scene::MeshFormats& formats) {
  return command->add_flag_callback(
      "--any-format", [&formats] { formats = scene::MeshFormats::any; },
      "Read meshes in any format, beyond .obj, .stl, .ply, .off, .gltf, .glb and files of panels");
}

}  // namespace app
