#include "app/pictures/paints.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "app/assembly/mesh_paint.h"

namespace app {

std::vector<std::shared_ptr<const render::Paint>> paints_of(const scene::Scene& scene,
                                                            const assembly::BuiltScene& built) {
  std::vector<std::shared_ptr<const render::Paint>> paints(scene.bodies.size());
  // Several bodies may have the same file, each in a frame of its own.
  std::map<std::filesystem::path, std::optional<assembly::MeshPaint>> read;
  for (std::size_t i = 0; i < paints.size(); ++i) {
    if (!std::holds_alternative<scene::Mesh>(scene.bodies[i].shape) ||
        built.mesh_sources[i].empty() || scene.places.contains(fmt::format("bodies[{}].color", i)))
      continue;
    const assembly::MeshSource& source = built.mesh_sources[i].front();
    auto found = read.find(source.file);
    if (found == read.end())
      found = read.emplace(source.file, assembly::read_paint(source.file)).first;
    if (!found->second) continue;
    const assembly::MeshPaint& paint = *found->second;
    hydro::TriMesh surface_B = hydro::translated(assembly::in_mesh_frame(paint.mesh, source.frame),
                                                 -built.centers_of_mass[i]);
    paints[i] =
        std::make_shared<const render::Paint>(render::Paint{std::move(surface_B), paint.colors});
  }
  return paints;
}

}  // namespace app
