#include "app/assembly/mesh_io.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/assembly/ply_head.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mesh_check.h"
#include "hydro/mesh/weld.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;
using hydro::TriMesh;

/// Welding distance relative to the largest coordinate: one step of a float, 2^-23.
constexpr double kWeld = 0x1p-23;

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// Compares the numbers of vertices and faces that an OFF file announces with its size; each
/// element takes a line. assimp allocates memory for these numbers before it reaches the end of the
/// file.
void require_true_off_counts(const fs::path& file) {
  std::ifstream in(file);
  const double size = static_cast<double>(fs::file_size(file));
  std::string line, word;
  for (int found = 0; found < 2 && std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    double count = 0;
    while (found < 2 && words >> word)
      if (std::istringstream(word) >> count) {
        ++found;
        if (!(count >= 0 && count <= size))
          throw scene::InputError(file, "the file is cut short: its head announces " + word +
                                            " elements, but it has only " +
                                            std::to_string(fs::file_size(file)) + " bytes");
      }
  }
}

void require_readable(const fs::path& file, const Assimp::Importer& importer) {
  std::error_code error;
  if (!fs::exists(file, error)) throw scene::InputError(file, "there is no such file");
  if (!fs::is_regular_file(file, error)) throw scene::InputError(file, "is not a file");
  if (!std::ifstream(file)) throw scene::InputError(file, "the file cannot be opened");
  if (fs::file_size(file) == 0) throw scene::InputError(file, "the file is empty");
  const std::string extension = lower_extension(file);
  if (extension.empty() || !importer.IsExtensionSupported(extension))
    throw scene::InputError(file,
                            "no mesh format has the extension '" + extension +
                                "'; known are .obj, .stl, .ply, .off, .glb, .gltf, .dae, .3ds, "
                                ".fbx, .3mf and others that assimp reads");
  if (extension == ".ply") require_whole_ply(file);
  if (extension == ".off") require_true_off_counts(file);
}

Eigen::Affine3d transformation(const aiMatrix4x4& m) {
  Eigen::Affine3d X;
  X.matrix() << m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4, m.d1, m.d2,
      m.d3, m.d4;
  return X;
}

/// Joins the parts of a file into one mesh.
class Collector {
 public:
  Collector(const fs::path& file, const aiScene& scene) : file_(file), scene_(scene) {}

  void add(const aiNode& node, const Eigen::Affine3d& X_parent) {
    const Eigen::Affine3d X = X_parent * transformation(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) add(*scene_.mMeshes[node.mMeshes[i]], X);
    for (unsigned i = 0; i < node.mNumChildren; ++i) add(*node.mChildren[i], X);
  }

  TriMesh mesh() const {
    return {Eigen::Map<const Eigen::Matrix3Xd>(vertices_.data(), 3,
                                               static_cast<Eigen::Index>(vertices_.size() / 3)),
            Eigen::Map<const Eigen::Matrix3Xi>(faces_.data(), 3,
                                               static_cast<Eigen::Index>(faces_.size() / 3))};
  }

 private:
  void add(const aiMesh& part, const Eigen::Affine3d& X) {
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

TriMesh read_all_parts(const fs::path& file) {
  Assimp::Importer importer;
  require_readable(file, importer);
  // Keep the file's frame: the Collada reader would turn it to y up.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_ValidateDataStructure);
  if (scene) {
    require_corners(file, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
  }
  if (!scene)
    throw scene::InputError(file,
                            std::string("not a sound mesh file: ") + importer.GetErrorString());
  Collector parts(file, *scene);
  if (scene->mRootNode) parts.add(*scene->mRootNode, Eigen::Affine3d::Identity());
  return parts.mesh();
}

}  // namespace

TriMesh read_mesh(const fs::path& file) {
  const TriMesh parts = read_all_parts(file);
  if (parts.face_count() == 0) throw scene::InputError(file, "the file holds no triangles");
  TriMesh mesh = welded(parts, kWeld * parts.vertices.cwiseAbs().maxCoeff());
  if (mesh.face_count() == 0)
    throw scene::InputError(file, "all triangles of the file are degenerate");
  return mesh;
}

TriMesh read_solid(const fs::path& file, app::Reporter& reporter) {
  hydro::RepairedMesh repaired = hydro::repaired(read_mesh(file));
  std::vector<scene::Fault> faults;
  for (const std::string& fault : hydro::describe(repaired.report))
    faults.push_back({{file}, "", fault});
  if (!faults.empty()) throw scene::InputError(std::move(faults));
  for (const std::string& note : repaired.notes) reporter.note(file.string() + ": note: " + note);
  return std::move(repaired.mesh);
}

}  // namespace assembly
