#include "app/pictures/paints.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "app/assembly/mesh_paint.h"
#include "app/pictures/textures.h"

namespace app {
namespace {

/// The colours of a file, whose textures are decoded.
struct FilePaint {
  hydro::TriMesh mesh;      ///< In the axes and unit of the file.
  Eigen::Matrix3Xf colors;  ///< As render::Paint has them.
  std::shared_ptr<const render::TextureMap> textures;
};

/// Returns the textures that could be read; null if none could.
std::shared_ptr<const render::TextureMap> texture_map(const assembly::MeshPaint& paint,
                                                      ReadTextures read) {
  auto map = std::make_shared<render::TextureMap>();
  map->of_face = paint.texture_of;
  bool any = false;
  for (int& texture : map->of_face) {
    if (texture >= 0 && !read.images[static_cast<std::size_t>(texture)]) texture = -1;
    any = any || texture >= 0;
  }
  if (!any) return nullptr;
  map->images = std::move(read.images);
  map->coordinates = paint.coordinates;
  map->tints = paint.tints;
  map->of_light = paint.of_light;
  return map;
}

/// Gives each face with a texture the mean of it.
void take_means(const render::TextureMap& map, Eigen::Matrix3Xf& colors) {
  std::map<int, render::TexelMeans> means;
  for (Eigen::Index f = 0; f < colors.cols(); ++f) {
    if (map.of_face[f] < 0) continue;
    const int texture = map.of_face[f];
    const auto& of_image =
        means.try_emplace(texture, *map.images[static_cast<std::size_t>(texture)]).first->second;
    const Eigen::Vector3f mean = of_image.over(map.corners(static_cast<int>(f)));
    colors.col(f) = render::tinted(mean, map.tints.col(f), map.of_light);
  }
}

std::optional<FilePaint> read_file(const std::filesystem::path& file,
                                   std::vector<std::string>& warnings) {
  std::optional<assembly::MeshPaint> paint = assembly::read_paint(file);
  if (!paint) return std::nullopt;
  FilePaint result{.mesh = std::move(paint->mesh), .colors = std::move(paint->colors)};
  if (paint->textures.empty()) return result;
  ReadTextures read = read_textures(paint->textures, file);
  warnings.insert(warnings.end(), read.warnings.begin(), read.warnings.end());
  result.textures = texture_map(*paint, std::move(read));
  if (result.textures) take_means(*result.textures, result.colors);
  return result;
}

}  // namespace

Paints read_paints(const scene::Scene& scene, const assembly::BuiltScene& built) {
  Paints paints;
  paints.of_bodies.resize(scene.bodies.size());
  // Several bodies may have the same file, each in a frame of its own.
  std::map<std::filesystem::path, std::optional<FilePaint>> read;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!std::holds_alternative<scene::Mesh>(scene.bodies[i].shape) ||
        built.mesh_sources[i].empty() || scene.places.contains(fmt::format("bodies[{}].color", i)))
      continue;
    const assembly::MeshSource& source = built.mesh_sources[i].front();
    auto found = read.find(source.file);
    if (found == read.end())
      found = read.emplace(source.file, read_file(source.file, paints.warnings)).first;
    if (!found->second) continue;
    const FilePaint& paint = *found->second;
    hydro::TriMesh surface_B = hydro::translated(assembly::in_mesh_frame(paint.mesh, source.frame),
                                                 -built.centers_of_mass[i]);
    paints.of_bodies[i] = std::make_shared<const render::Paint>(render::Paint{
        .surface_B = std::move(surface_B), .colors = paint.colors, .textures = paint.textures});
  }
  return paints;
}

Paints shown_paints(const scene::Scene& scene, const assembly::BuiltScene& built) {
  if (!scene.render->pressure_shown) return read_paints(scene, built);
  Paints none;
  none.of_bodies.resize(scene.bodies.size());
  return none;
}

}  // namespace app
