#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/shape.h"
#include "hydro/mesh/mesh.h"

/// @file
/// The way of a mesh from the axes and unit of its file to its mesh frame: z up, metres.

namespace assembly {

/// Frame that a mesh file states.
struct StatedFrame {
  std::optional<scene::UpAxis> up;  ///< The axis that points up.
  std::optional<double> unit;       ///< Length of a unit of the coordinates [m].
};

/// Precision of the coordinates in a mesh file.
enum class Rounding {
  as_written,  ///< To the digits of a text, or to doubles.
  of_floats    ///< With a relative precision of 6e-8.
};

/// A mesh as its file has it: nothing is turned or scaled.
struct MeshFile {
  hydro::TriMesh mesh;                      ///< In the axes and unit of the file.
  StatedFrame frame;                        ///< Frame that the file states.
  Rounding rounding = Rounding::of_floats;  ///< Precision of its coordinates.
  Eigen::Index dropped = 0;                 ///< Faces without area that `read_welded` dropped.
};

/// Whose word an axis or a unit is.
enum class SaidBy { nobody, file, author };

/// The axis and unit that hold for a mesh, with those who said so.
struct AppliedFrame {
  scene::UpAxis up = scene::UpAxis::z;  ///< Axis of the file that points up.
  double unit = 1;                      ///< [m]
  double scale = 1;                     ///< Factor after the unit [-].
  SaidBy up_by = SaidBy::nobody;        ///< Origin of the axis.
  SaidBy unit_by = SaidBy::nobody;      ///< Origin of the unit.

  /// True if the coordinates of the file are those of the mesh frame.
  bool changes_nothing() const { return up == scene::UpAxis::z && unit * scale == 1; }
};

/// Decides between the author's word, which comes first, that of the file, and z and metres.
AppliedFrame applied_frame(const StatedFrame& stated, const scene::MeshFrame& wanted);

/// Turns and scales a mesh as its file has it.
hydro::TriMesh in_mesh_frame(hydro::TriMesh mesh, const AppliedFrame& frame);

/// The changes that made a solid of a mesh.
struct MendingRecord {
  std::optional<double> volume_before;  ///< [m^3]; none if the mesh was open.
  double volume_after = 0;              ///< [m^3]
  std::vector<std::string> changes;     ///< One sentence each.
};

/// A mesh file of a body.
struct MeshSource {
  std::filesystem::path file;                ///< Path of the file.
  AppliedFrame frame;                        ///< Axes and unit that hold for it.
  std::optional<MendingRecord> mended = {};  ///< None where the scene asks for no mending.
};

/// Describes a frame in words: `y up in the file, as it says; its unit is mm`.
std::string description(const AppliedFrame& frame);

/// Warns of a mesh whose unit the author does not name if its longest side is more than 500 m, a
/// length that no ship has: its file is likely in millimetres. @return empty for other meshes
/// @param mesh      In the mesh frame.
/// @param setting   Text that sets a unit: `unit: ` or `--unit `.
std::string size_warning(const hydro::TriMesh& mesh, const MeshSource& source,
                         const std::string& setting);

/// Warns of a mean density that only a wrong unit explains: far less than that of gas, or more than
/// four times that of the heaviest metal. @return empty for other densities
/// @param volume   Volume of a body whose shape is the mesh of this file [m^3].
std::string density_warning(double mass, double volume, const MeshSource& source);

}  // namespace assembly
