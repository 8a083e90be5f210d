#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hydro/mesh/weld.h"

namespace support {

/// A mesh of triangles from a file in scenes/meshes, welded.
inline hydro::TriMesh stored_mesh(const std::string& name) {
  std::ifstream file(std::string(PLIMSOLL_SOURCE_DIR) + "/scenes/meshes/" + name);
  std::vector<double> coordinates;
  std::vector<int> corners;
  for (std::string line, kind; std::getline(file, line);) {
    std::istringstream words(line);
    if (!(words >> kind) || (kind != "v" && kind != "f")) continue;
    for (int i = 0; i < 3; ++i) {
      std::string word;
      words >> word;
      if (kind == "v") coordinates.push_back(std::stod(word));
      if (kind == "f") corners.push_back(std::stoi(word) - 1);
    }
  }
  hydro::TriMesh mesh;
  mesh.vertices = Eigen::Map<Eigen::Matrix3Xd>(coordinates.data(), 3,
                                               static_cast<Eigen::Index>(coordinates.size() / 3));
  mesh.faces = Eigen::Map<Eigen::Matrix3Xi>(corners.data(), 3,
                                            static_cast<Eigen::Index>(corners.size() / 3));
  return hydro::welded(mesh, 1e-9);
}

}  // namespace support
