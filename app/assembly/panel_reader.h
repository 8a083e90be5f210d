#pragma once

#include <filesystem>
#include <string_view>

#include "app/assembly/mesh_frame.h"

/// @file
/// Readers of the panel files of potential codes. Their meshes end at the waterline as a rule. A
/// body of which the file has a half or a quarter becomes whole: panels are repeated in the planes
/// of symmetry, and coinciding vertices are left for the caller to weld.
///
/// @param file    Named in faults.
/// @throws InputError with the line of the fault

namespace assembly {

/// Reads a low-order WAMIT file (.gdf): a line of text, ULEN and GRAV, ISX and ISY, the number of
/// panels, and four vertices of each. GRAV tells the unit: feet if it is near 32.2, else metres.
/// ULEN, which scales results and no coordinates, is left out.
MeshFile read_gdf(const std::filesystem::path& file, std::string_view bytes);

/// Reads a mesh of Nemoh and Capytaine (.dat): `2` and 1 for symmetry about y = 0, numbered
/// vertices up to a number 0, panels of four vertices up to one of zeros.
MeshFile read_nemoh_mesh(const std::filesystem::path& file, std::string_view bytes);

/// Reads a mesh of HAMS (.pnl): numbers of panels and vertices, flags of symmetry about x = 0 and
/// y = 0, numbered vertices, and numbered panels of three or four vertices. Lines that do not begin
/// with a number are comments.
MeshFile read_pnl(const std::filesystem::path& file, std::string_view bytes);

}  // namespace assembly
