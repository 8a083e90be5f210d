#include "hydro/mesh/terrain.h"

#include <stdexcept>
#include <string>

namespace hydro {

TriMesh terrain_mesh(const HeightField& field) {
  const int rows = static_cast<int>(field.heights.rows());
  const int columns = static_cast<int>(field.heights.cols());
  if (rows < 2 || columns < 2)
    throw std::invalid_argument("the height field has " + std::to_string(rows) + " x " +
                                std::to_string(columns) + " heights, expected at least 2 x 2");
  if (!(field.cell > 0))
    throw std::invalid_argument("cell is " + std::to_string(field.cell) +
                                ", expected a positive length [m]");
  TriMesh mesh{Eigen::Matrix3Xd(3, rows * columns),
               Eigen::Matrix3Xi(3, 2 * (rows - 1) * (columns - 1))};
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j)
      mesh.vertices.col(i * columns + j) << field.origin + field.cell * Eigen::Vector2d(j, i),
          field.heights(i, j);
  Eigen::Index face = 0;
  for (int i = 0; i + 1 < rows; ++i) {
    for (int j = 0; j + 1 < columns; ++j) {
      const int a = i * columns + j, b = a + 1, c = b + columns, d = a + columns;
      const bool cut_ac = (i + j) % 2 == 0;
      mesh.faces.col(face++) << a, b, (cut_ac ? c : d);
      mesh.faces.col(face++) << (cut_ac ? a : b), c, d;
    }
  }
  return mesh;
}

}  // namespace hydro
