#include "app/export/animated_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "app/assembly/built_scene.h"
#include "app/export/moving_node.h"
#include "app/logs/rig_log.h"
#include "app/pictures/cameras.h"
#include "app/pictures/hanging_line.h"
#include "app/pictures/paints.h"
#include "app/pictures/rig_parts.h"
#include "app/pictures/rigging.h"
#include "app/render/paint.h"
#include "app/render/part_meshes.h"
#include "app/render/srgb.h"
#include "app/render/view.h"
#include "app/report/shapes.h"

namespace app {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

/// Largest number of samples of the water and of lines: each costs 12 bytes a vertex.
constexpr std::size_t kMostSamples = 150;
constexpr int kLinePoints = 24;  // Points of an exported line.
constexpr double kLineGray = 0.35;
constexpr std::array<double, 4> kWater = {0.10, 0.36, 0.50,
                                          0.72};  // RGB as displayed, and opacity.
constexpr std::array<double, 4> kGround = {0.72, 0.66, 0.54, 1};

/// Returns a line as points at even shares of its length.
Eigen::Matrix3Xd evenly_spaced(const Eigen::Matrix3Xd& points, int count) {
  Eigen::VectorXd along = Eigen::VectorXd::Zero(points.cols());
  for (Eigen::Index i = 1; i < points.cols(); ++i)
    along[i] = along[i - 1] + (points.col(i) - points.col(i - 1)).norm();
  Eigen::Matrix3Xd even(3, count);
  Eigen::Index i = 1;
  for (int k = 0; k < count; ++k) {
    const double at = along[along.size() - 1] * k / (count - 1);
    while (i + 1 < points.cols() && along[i] < at) ++i;
    const double length = along[i] - along[i - 1];
    const double part = length > 0 ? std::clamp((at - along[i - 1]) / length, 0.0, 1.0) : 0;
    even.col(k) = points.col(i - 1) + part * (points.col(i) - points.col(i - 1));
  }
  return even;
}

/// The square of water that is exported.
struct WaterSquare {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();  ///< [m, W]
  double half = 1;                                   ///< Half its side [m].
};

/// Writes one run.
class SceneWriter {
 public:
  SceneWriter(const scene::Scene& scene, const assembly::BuiltScene& built, const Paints& paints,
              const ShotSpool& shots, const AnimationOptions& options)
      : scene_(scene),
        built_(built),
        paints_(paints),
        spec_(built.spec),
        shots_(shots),
        options_(options) {
    const bool of_video = shots.of_video() > 0;
    for (std::size_t i = 0; i < shots.size(); ++i) {
      const Shot shot = shots.at(i);
      // A video ends before the final state, a run with it.
      if (of_video && !shot.video && i + 1 < shots.size()) continue;
      chosen_.push_back(i);
      times_.push_back(static_cast<float>(shot.time));
    }
    const std::size_t stride = (chosen_.size() + kMostSamples - 2) / (kMostSamples - 1);
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (i % stride != 0 && i + 1 < chosen_.size()) continue;
      sampled_.push_back(chosen_[i]);
      sample_times_.push_back(times_[i]);
    }
    animation_ = {{"name", "run"}, {"samplers", Json::array()}, {"channels", Json::array()}};
  }

  Glb write() {
    input_ = accessor_of(times_);
    sample_input_ = accessor_of(sample_times_);
    write_poses();
    write_ground();
    if (spec_.sea && options_.water_cells > 0) write_water();
    write_lines();
    // W has z up, glTF y: everything stands in one node that turns it.
    const double half = std::sqrt(0.5);
    const std::size_t root = glb_.append(
        "nodes", {{"name", "world"}, {"rotation", {-half, 0, 0, half}}, {"children", children_}});
    glb_.append("scenes", {{"name", scene_.title.empty() ? "run" : scene_.title},
                           {"nodes", Json::array({root})}});
    glb_.document["scene"] = 0;
    if (!animation_["channels"].empty()) glb_.append("animations", animation_);
    return std::move(glb_);
  }

 private:
  std::size_t accessor_of(const std::vector<float>& numbers) {
    return glb_.add(Eigen::Map<const Eigen::MatrixXf>(numbers.data(), 1,
                                                      static_cast<Eigen::Index>(numbers.size())),
                    Glb::Use::animation);
  }

  std::size_t material(const std::array<double, 4>& color) {
    const auto [found, is_new] = materials_.emplace(color, materials_.size());
    if (!is_new) return found->second;
    Json material = {{"pbrMetallicRoughness",
                      {{"baseColorFactor",
                        {render::light_of(color[0]), render::light_of(color[1]),
                         render::light_of(color[2]), color[3]}},
                       {"metallicFactor", 0},
                       {"roughnessFactor", color == kWater ? 0.15 : 0.6}}}};
    if (color[3] < 1) material["alphaMode"] = "BLEND";
    if (color == kWater || color == kGround) material["doubleSided"] = true;
    return glb_.append("materials", std::move(material));
  }
  std::size_t material(const Vector3d& color) {
    return material(std::array{color.x(), color.y(), color.z(), 1.0});
  }

  /// Adds a mesh with smooth normals, and with colours of its vertices if there are any.
  std::size_t mesh_of(const render::ShadedMesh& skin, const Eigen::Matrix3Xf& colors,
                      const Vector3d& color) {
    Json attributes = {{"POSITION", glb_.add(skin.vertices.cast<float>(), Glb::Use::vertices)},
                       {"NORMAL", glb_.add(skin.normals.cast<float>(), Glb::Use::vertices)}};
    if (colors.size() > 0)
      attributes["COLOR_0"] = glb_.add(
          colors.unaryExpr([](float c) { return static_cast<float>(render::light_of(c)); }),
          Glb::Use::vertices);
    Json primitive = {{"attributes", std::move(attributes)},
                      {"indices", glb_.add(skin.triangles)},
                      {"material", material(colors.size() > 0 ? Vector3d::Ones() : color)}};
    return glb_.append("meshes", {{"primitives", Json::array({std::move(primitive)})}});
  }

  /// Adds the meshes of the bodies, each once for a shape and colour. @return one for each body
  std::vector<std::size_t> body_meshes() {
    std::size_t faces = 0;
    for (const engine::BodySpec& body : spec_.bodies)
      faces += static_cast<std::size_t>(body.mesh_B.face_count());
    const Shapes shapes = find_shapes(spec_.bodies, static_cast<Eigen::Index>(faces));
    const auto& paints = paints_.of_bodies;
    std::map<std::pair<std::size_t, std::array<double, 3>>, std::size_t> known;
    std::vector<std::size_t> meshes;
    for (std::size_t i = 0; i < spec_.bodies.size(); ++i) {
      const Vector3d& color = scene_.bodies[i].color;
      const render::ShadedMesh skin =
          render::make_shaded_mesh(shapes.shapes[shapes.of_body[i]].mesh_B);
      if (paints[i]) {
        const render::PaintedSkin painted =
            render::painted_skin(skin, render::without_textures(*paints[i]), color.cast<float>());
        meshes.push_back(mesh_of(painted.skin, painted.colors, color));
        continue;
      }
      const std::pair key(shapes.of_body[i], std::array{color.x(), color.y(), color.z()});
      const auto found = known.find(key);
      meshes.push_back(found != known.end() ? found->second : mesh_of(skin, {}, color));
      known.emplace(key, meshes.back());
    }
    return meshes;
  }

  /// Adds nodes for bodies, parts of machines and cameras, with all their poses.
  void write_poses() {
    const std::vector<std::size_t> meshes = body_meshes();
    const std::vector<scene::Camera> cameras = cameras_of(*scene_.render);
    const RigPictures rig(spec_, false);
    std::vector<Json> nodes;
    for (std::size_t i = 0; i < spec_.bodies.size(); ++i)
      nodes.push_back({{"name", spec_.bodies[i].name}, {"mesh", meshes[i]}});
    for (const render::Part& part : rig.of(shots_.at(chosen_.front())).parts)
      nodes.push_back({{"name", "part"},
                       {"mesh", mesh_of(render::make_shaded_mesh(*part.mesh_P), {}, part.color)}});
    const Shot first = shots_.at(chosen_.front());
    for (const scene::Camera& camera : cameras) {
      const std::string name = name_of(camera);
      nodes.push_back({{"name", name}, {"camera", add_camera(name, view_of(camera, first))}});
    }
    std::vector<PoseTrack> tracks(nodes.size());
    for (const std::size_t number : chosen_) {
      const Shot shot = shots_.at(number);
      std::size_t node = 0;
      for (const hydro::BodyState& state : shot.states) {
        tracks[node++].add(pose_of(state));
        path_.extend(state.position);
      }
      for (const render::Part& part : rig.of(shot).parts) tracks[node++].add(part.X_WP);
      for (const scene::Camera& camera : cameras)
        tracks[node++].add(pose_of(view_of(camera, shot)));
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      tracks[i].put_first(nodes[i]);
      children_.push_back(glb_.append("nodes", nodes[i]));
      tracks[i].animate(glb_, animation_, children_.back(), input_);
    }
  }

  /// The scene's name of a camera: cameras_of gives none to a single one.
  std::string name_of(const scene::Camera& camera) const {
    if (!camera.name.empty()) return camera.name;
    return scene_.render->cameras.empty() ? "camera" : scene_.render->cameras.front().name;
  }

  render::View view_of(const scene::Camera& camera, const Shot& shot) const {
    const auto& size = scene_.render->size;
    return render::make_view(camera_at(camera, built_, shot), size[0], size[1]);
  }

  /// The pose of a camera of glTF, which looks along −z with y up.
  static Eigen::Isometry3d pose_of(const render::View& view) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() << view.right_W, view.up_W, -view.forward_W;
    pose.translation() = view.eye_W;
    return pose;
  }
  static Eigen::Isometry3d pose_of(const hydro::BodyState& state) { return app::pose_of(state); }

  std::size_t add_camera(const std::string& name, const render::View& view) {
    return glb_.append("cameras", {{"name", name},
                                   {"type", "perspective"},
                                   {"perspective",
                                    {{"aspectRatio", view.half_width / view.half_height},
                                     {"yfov", 2 * std::atan(view.half_height)},
                                     {"znear", view.near},
                                     {"zfar", view.far}}}});
  }

  void write_still(const std::string& name, const hydro::TriMesh& mesh_W) {
    SampledSurface surface(name, mesh_W.faces);
    surface.add(mesh_W.vertices);
    children_.push_back(surface.write(glb_, animation_, material(kGround), sample_input_));
  }

  void write_ground() {
    if (const auto* mesh = std::get_if<engine::MeshGround>(&spec_.ground))
      write_still("ground", mesh->mesh_W);
    if (const auto* plane = std::get_if<engine::PlaneGround>(&spec_.ground)) {
      const WaterSquare square = square_about_paths();
      hydro::TriMesh mesh;
      mesh.vertices = grid(square, 1, [&](double, double) { return plane->z; });
      mesh.faces = grid_faces(1);
      write_still("ground", mesh);
    }
  }

  /// A square about the paths of the bodies, with as much water around them again as they take.
  WaterSquare square_about_paths() const {
    double size = 0;
    for (const engine::BodySpec& body : spec_.bodies)
      size = std::max(size, body.mesh_B.vertices.colwise().norm().maxCoeff());
    if (path_.isEmpty()) return {.half = 10};
    const Vector3d extent = path_.sizes();
    return {.middle = path_.center().head<2>(), .half = extent.head<2>().maxCoeff() + 6 * size};
  }

  template <class Height>
  static Eigen::Matrix3Xd grid(const WaterSquare& square, int cells, Height height) {
    Eigen::Matrix3Xd vertices(3, (cells + 1) * (cells + 1));
    for (int j = 0; j <= cells; ++j)
      for (int i = 0; i <= cells; ++i) {
        const double x = square.middle.x() + square.half * (2.0 * i / cells - 1);
        const double y = square.middle.y() + square.half * (2.0 * j / cells - 1);
        vertices.col(j * (cells + 1) + i) << x, y, height(x, y);
      }
    return vertices;
  }

  static Eigen::Matrix3Xi grid_faces(int cells) {
    Eigen::Matrix3Xi faces(3, 2 * cells * cells);
    for (int j = 0; j < cells; ++j)
      for (int i = 0; i < cells; ++i) {
        const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
        faces.col(2 * (j * cells + i)) << a, b, d;
        faces.col(2 * (j * cells + i) + 1) << a, d, c;
      }
    return faces;
  }

  void write_water() {
    const WaterSquare square = square_about_paths();
    const hydro::Sea& sea = *spec_.sea;
    SampledSurface surface("water", grid_faces(options_.water_cells));
    for (const std::size_t number : sampled_) {
      const Shot shot = shots_.at(number);
      surface.add(grid(square, options_.water_cells, [&](double x, double y) {
        const double raised = shot.water ? shot.water->at(x, y) : 0;
        return sea.level + hydro::surface_elevation(sea, x, y, shot.time) + raised;
      }));
    }
    children_.push_back(surface.write(glb_, animation_, material(kWater), sample_input_));
  }

  /// Adds springs, ropes and moorings as tubes. A broken line shrinks to its first end, and so does
  /// one of no length.
  void write_lines() {
    const GroundHeight ground(spec_.ground);
    Eigen::Matrix3Xd along_x = Eigen::Matrix3Xd::Zero(3, kLinePoints);
    along_x.row(0).setLinSpaced(0, 1);
    const hydro::TriMesh straight = render::tube_mesh(along_x, 0.01);
    for (std::size_t i = 0; i < spec_.lines.size(); ++i) {
      const engine::LineSpec& line = spec_.lines[i];
      const double radius = line_radius(spec_, line);
      SampledSurface surface(log_name(line), straight.faces);
      Vector3d toward = Vector3d::Zero();
      for (const std::size_t number : sampled_) {
        const Shot shot = shots_.at(number);
        const DrawnLine& now = shot.rig.lines[i];
        const Eigen::Matrix3Xd points = shape_of(line, now, shot.states, ground, radius);
        const hydro::TriMesh tube =
            render::tube_mesh(evenly_spaced(points, kLinePoints),
                              Eigen::VectorXd::Constant(kLinePoints, radius), toward);
        Eigen::Matrix3Xd vertices = tube.vertices;
        if (now.broken || vertices.cols() != straight.vertices.cols())
          vertices = points.col(0).replicate(1, straight.vertices.cols()).eval();
        else
          toward = vertices.col(0) - points.col(0);
        surface.add(vertices);
      }
      children_.push_back(
          surface.write(glb_, animation_, material(Vector3d::Constant(kLineGray)), sample_input_));
    }
  }

  const scene::Scene& scene_;
  const assembly::BuiltScene& built_;
  const Paints& paints_;
  const engine::SimulationSpec& spec_;
  const ShotSpool& shots_;
  const AnimationOptions& options_;
  std::vector<std::size_t> chosen_, sampled_;  ///< Numbers of shots.
  std::vector<float> times_, sample_times_;    ///< Their times [s].
  Glb glb_;
  Json animation_;
  std::size_t input_ = 0, sample_input_ = 0;  ///< Accessors of the times.
  std::map<std::array<double, 4>, std::size_t> materials_;
  std::vector<std::size_t> children_;  ///< Nodes of the world.
  Eigen::AlignedBox3d path_;           ///< Box about the places of all bodies [m, W].
};

}  // namespace

Glb animated_scene(const scene::Scene& scene, const assembly::BuiltScene& built,
                   const Paints& paints, const ShotSpool& shots, const AnimationOptions& options) {
  return SceneWriter(scene, built, paints, shots, options).write();
}

}  // namespace app
