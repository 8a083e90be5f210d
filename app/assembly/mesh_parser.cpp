#include "app/assembly/mesh_parser.h"

#include <assimp/BaseImporter.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/assembly/mesh_file_access.h"
#include "app/assembly/mesh_text.h"
#include "app/assembly/msh_reader.h"
#include "app/assembly/obj_reader.h"
#include "app/assembly/off_reader.h"
#include "app/assembly/panel_reader.h"
#include "app/assembly/ply_reader.h"
#include "app/assembly/polygon_mesh.h"
#include "app/assembly/stl_reader.h"
#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;
using hydro::TriMesh;

/// Formats besides those of this program's readers that are read by default.
constexpr const char* kCommonFormats[] = {".gltf", ".glb"};

/// Greatest depth of nodes below the root. Each level takes some hundred bytes of the stack.
constexpr int kDeepestNode = 1000;

/// The readers of this program.
constexpr std::pair<const char*, MeshFile (*)(const fs::path&, std::string_view)> kOwnReaders[] = {
    {".obj", read_obj}, {".stl", read_stl}, {".ply", read_ply},        {".off", read_off},
    {".gdf", read_gdf}, {".pnl", read_pnl}, {".dat", read_nemoh_mesh}, {".msh", read_msh}};

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

void require_known_format(const fs::path& file, scene::MeshFormats formats,
                          const Assimp::Importer& importer) {
  if (is_common_mesh_format(file)) return;
  const std::string extension = lower_extension(file);
  if (extension.empty() || !importer.IsExtensionSupported(extension))
    throw scene::InputError(file, fmt::format("no mesh format has the extension '{}'; known are "
                                              ".obj, .stl, .ply, .off, .gltf, .glb, panels as "
                                              ".gdf, .pnl, .dat and .msh, and with "
                                              "--any-format .dae, .3ds, .fbx, .3mf and others that "
                                              "assimp reads",
                                              extension));
  if (formats != scene::MeshFormats::any)
    throw scene::InputError(
        file, fmt::format("a mesh of the format {} is read only with the option --any-format (in "
                          "Python any_format=True); without it .obj, .stl, .ply, .off, .gltf and "
                          ".glb are read",
                          extension));
}

void require_readable(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw scene::InputError(file, "there is no such file");
  if (!fs::is_regular_file(file, error)) throw scene::InputError(file, "is not a file");
  if (!std::ifstream(file)) throw scene::InputError(file, "the file cannot be opened");
  if (fs::file_size(file, error) == 0) throw scene::InputError(file, "the file is empty");
}

/// assimp tries the readers of all formats on a file that the one of its extension refuses. For the
/// common formats only their own readers remain.
void keep_common_readers(Assimp::Importer& importer) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    std::istringstream extensions(importer.GetImporterInfo(i)->mFileExtensions);
    bool common = false;
    for (std::string extension; extensions >> extension;)
      common = common || std::ranges::count(kCommonFormats, "." + extension) > 0;
    if (!common) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* other : others) importer.UnregisterLoader(other);
}

Eigen::Affine3d transformation(const aiMatrix4x4& m) {
  Eigen::Affine3d X;
  X.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return X;
}

/// Vertices that a file may have for each of its bytes, where they are more than kMostOfSmallFile.
/// A file of some kilobytes may place a part a billion times, or make spheres.
constexpr std::size_t kVerticesOfByte = 8;
constexpr std::size_t kMostOfSmallFile = 3'000'000;

/// Joins the parts of a file into one mesh.
class Collector {
 public:
  /// @param bytes   Size of all files that the scene has been read from.
  Collector(const fs::path& file, const aiScene& scene, std::size_t bytes)
      : file_(file),
        scene_(scene),
        bytes_(bytes),
        most_(std::min(kMostVertices, std::max(kMostOfSmallFile, kVerticesOfByte * bytes))) {}

  /// Adds the parts of a node and of those below. @param X   From the node to the file's frame.
  void add(const aiNode& node, const Eigen::Affine3d& X, int depth = 0) {
    if (depth > kDeepestNode)
      throw scene::InputError(file_,
                              fmt::format("its nodes are nested more than {} deep", kDeepestNode));
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], X);
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      const aiNode& child = *node.mChildren[i];
      add(child, X * transformation(child.mTransformation), depth + 1);
    }
  }

  TriMesh mesh() const {
    return {Eigen::Map<const Eigen::Matrix3Xd>(vertices_.data(), 3,
                                               static_cast<Eigen::Index>(vertices_.size() / 3)),
            Eigen::Map<const Eigen::Matrix3Xi>(faces_.data(), 3,
                                               static_cast<Eigen::Index>(faces_.size() / 3))};
  }

 private:
  void add(const aiMesh& part, const Eigen::Affine3d& X) {
    if (vertices_.size() / 3 + part.mNumVertices > most_)
      throw scene::InputError(
          file_, fmt::format("its parts, with all instances, have more than {} vertices, the most "
                             "that are read from {} bytes",
                             most_, bytes_));
    const int first = static_cast<int>(vertices_.size() / 3);
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const aiVector3D& v = part.mVertices[i];
      require_finite({v.x, v.y, v.z});
      const Eigen::Vector3d p = X * Eigen::Vector3d(v.x, v.y, v.z);
      vertices_.insert(vertices_.end(), p.begin(), p.end());
    }
    const bool mirrored = X.linear().determinant() < 0;
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices == 3) add_face(part, face, first, mirrored);
    }
  }

  void require_finite(const Eigen::Vector3d& p) const {
    if (p.allFinite()) return;
    std::ostringstream text;
    text << "vertex " << vertices_.size() / 3 + 1 << " in the order of reading is (" << p.x()
         << ", " << p.y() << ", " << p.z() << "), expected finite coordinates of a float's range";
    throw scene::InputError(file_, text.str());
  }

  /// A mirroring transformation would reverse the face.
  void add_face(const aiMesh& part, const aiFace& face, int first, bool mirrored) {
    for (const int corner : {0, mirrored ? 2 : 1, mirrored ? 1 : 2}) {
      if (face.mIndices[corner] >= part.mNumVertices)
        throw scene::InputError(file_,
                                "a face names vertex " + std::to_string(face.mIndices[corner]) +
                                    ", expected less than " + std::to_string(part.mNumVertices));
      faces_.push_back(first + static_cast<int>(face.mIndices[corner]));
    }
  }

  const fs::path& file_;
  const aiScene& scene_;
  std::size_t bytes_;
  std::size_t most_;
  std::vector<double> vertices_;
  std::vector<int> faces_;
};

/// Refuses a face without corners, on which the triangulation of assimp 5.2 ends the process.
void require_corners(const fs::path& file, const aiScene& scene) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
      if (scene.mMeshes[m]->mFaces[f].mNumIndices == 0)
        throw scene::InputError(file, "face " + std::to_string(f + 1) + " has no vertices");
}

constexpr scene::UpAxis kAxes[] = {scene::UpAxis::x, scene::UpAxis::y, scene::UpAxis::z};
constexpr scene::UpAxis kDownAxes[] = {scene::UpAxis::minus_x, scene::UpAxis::minus_y,
                                       scene::UpAxis::minus_z};

/// Finds `<up_axis>Y_UP</up_axis>` and `<unit meter="0.01"/>` in a Collada file, whose reader keeps
/// them to itself. Without them y is up and a unit is a metre.
StatedFrame collada_frame(const fs::path& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  StatedFrame frame{.up = scene::UpAxis::y, .unit = 1};
  const std::size_t up = text.find("<up_axis>");
  const std::size_t axis =
      up == std::string::npos ? std::string::npos : text.find_first_of("XYZ", up);
  if (axis != std::string::npos) frame.up = kAxes[text[axis] - 'X'];
  const std::size_t unit = text.find("<unit");
  const std::size_t end = unit == std::string::npos ? unit : text.find('>', unit);
  const std::size_t meter = end == std::string::npos ? end : text.find("meter", unit);
  if (meter == std::string::npos || meter > end) return frame;
  const std::size_t number = text.find_first_of("0123456789.", meter);
  if (number == std::string::npos || number > end) return frame;
  double length = 0;
  std::from_chars(text.data() + number, text.data() + end, length);
  if (std::isfinite(length) && length > 0) frame.unit = length;
  return frame;
}

StatedFrame fbx_frame(const aiScene& scene) {
  StatedFrame frame;
  if (scene.mMetaData == nullptr) return frame;
  int axis = -1, sign = 1;
  scene.mMetaData->Get("UpAxisSign", sign);
  if (scene.mMetaData->Get("UpAxis", axis) && axis >= 0 && axis <= 2)
    frame.up = sign < 0 ? kDownAxes[axis] : kAxes[axis];
  // The factor is that of centimetres; its type depends on the version of assimp.
  float single = 0;
  double factor = 0;
  if (!scene.mMetaData->Get("UnitScaleFactor", factor) &&
      scene.mMetaData->Get("UnitScaleFactor", single))
    factor = single;
  if (std::isfinite(factor) && factor > 0) frame.unit = factor / 100;
  return frame;
}

StatedFrame stated_frame(const fs::path& file, const aiScene& scene) {
  const std::string extension = lower_extension(file);
  if (extension == ".gltf" || extension == ".glb") return {.up = scene::UpAxis::y, .unit = 1};
  if (extension == ".dae") return collada_frame(file);
  if (extension == ".fbx") return fbx_frame(scene);
  return {};
}

/// Returns the transformation from the root of the nodes to the axes and unit of the file, without
/// what the reader of its format has done to them.
Eigen::Affine3d root_to_file(const fs::path& file, const aiNode& root, const StatedFrame& frame) {
  const std::string extension = lower_extension(file);
  // The root of an FBX file has no transformation of its own. The transformation that its reader
  // gives it scales and turns, or not, depending on the version of assimp, and may be singular.
  if (extension == ".fbx") return Eigen::Affine3d::Identity();
  const Eigen::Affine3d X = transformation(root.mTransformation);
  // The Collada reader converts to metres.
  return extension == ".dae" ? Eigen::Scaling(1 / frame.unit.value_or(1)) * X : X;
}

/// assimp's errors may repeat bytes of the file.
std::string printable(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  return text.substr(0, 300);
}

MeshFile parse_by_assimp(const fs::path& file, scene::MeshFormats formats) {
  // Neither this nor the scene is freed: to do so recurses through all nodes, and takes time.
  auto& importer = *new Assimp::Importer;
  require_known_format(file, formats, importer);
  if (is_common_mesh_format(file)) keep_common_readers(importer);
  auto& access = *new MeshFileAccess(file);  // The importer's from here on.
  importer.SetIOHandler(&access);
  // Keep the file's frame: the Collada reader would turn it to y up.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure);
  if (scene) {
    require_corners(file, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (!scene)
    throw scene::InputError(file, "not a sound mesh file: " + printable(importer.GetErrorString()));
  const StatedFrame frame = stated_frame(file, *scene);
  Collector parts(file, *scene, static_cast<std::size_t>(access.bytes_opened()));
  if (const aiNode* root = scene->mRootNode) parts.add(*root, root_to_file(file, *root, frame));
  return {parts.mesh(), frame, Rounding::of_floats};
}

}  // namespace

bool is_common_mesh_format(const fs::path& file) {
  const std::string extension = lower_extension(file);
  return std::ranges::count(kCommonFormats, extension) > 0 ||
         std::ranges::count(kOwnReaders, extension,
                            [](const auto& reader) { return reader.first; });
}

MeshFile parse_mesh(const fs::path& file, scene::MeshFormats formats) {
  require_readable(file);
  for (const auto& [extension, read] : kOwnReaders)
    if (lower_extension(file) == extension) return read(file, bytes_of_mesh(file));
  return parse_by_assimp(file, formats);
}

}  // namespace assembly
