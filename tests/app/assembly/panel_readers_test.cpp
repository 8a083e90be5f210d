#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "app/assembly/msh_reader.h"
#include "app/assembly/panel_reader.h"
#include "app/scene/diagnostics.h"
#include "hydro/mesh/mending/mend.h"
#include "hydro/mesh/weld.h"
#include "tests/support/tolerance.h"

/// @file
/// Panels of a box of 4 x 2 x 1 m below the waterline, open there, as potential codes have them.

namespace {

using assembly::MeshFile;
using testing::HasSubstr;

using Reader = MeshFile (*)(const std::filesystem::path&, std::string_view);

/// The quarter of the box with x, y > 0: bottom, bow and side.
constexpr double kQuarter[3][4][3] = {{{0, 0, -1}, {0, 1, -1}, {2, 1, -1}, {2, 0, -1}},
                                      {{2, 0, 0}, {2, 0, -1}, {2, 1, -1}, {2, 1, 0}},
                                      {{0, 1, 0}, {2, 1, 0}, {2, 1, -1}, {0, 1, -1}}};

/// Vertices of the half of the box with y > 0, and its panels.
constexpr double kHalfVertices[8][3] = {{-2, 0, -1}, {2, 0, -1}, {2, 1, -1}, {-2, 1, -1},
                                        {-2, 0, 0},  {2, 0, 0},  {2, 1, 0},  {-2, 1, 0}};
constexpr int kHalfPanels[4][4] = {{1, 4, 3, 2}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}};

/// Formats the vertices, and the panels, of the half one to a line.
std::string half_vertices(const std::function<std::string(int)>& head) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("{}{} {} {}\n", head(i + 1), kHalfVertices[i][0], kHalfVertices[i][1],
                        kHalfVertices[i][2]);
  return text;
}
std::string half_panels(const std::function<std::string(int)>& head) {
  std::string text;
  for (int i = 0; i < 4; ++i)
    text += fmt::format("{}{} {} {} {}\n", head(i + 1), kHalfPanels[i][0], kHalfPanels[i][1],
                        kHalfPanels[i][2], kHalfPanels[i][3]);
  return text;
}

std::string gdf(const std::string& head = "1.0 9.80665  ULEN GRAV\n1 1  ISX ISY\n3\n") {
  std::string text = "a box\n" + head;
  for (const auto& panel : kQuarter)
    for (const auto& v : panel) text += fmt::format("{} {} {}\n", v[0], v[1], v[2]);
  return text;
}

std::string nemoh() {
  const auto number = [](int i) { return fmt::format("{} ", i); };
  return "2 1\n" + half_vertices(number) + "0 0. 0. 0.\n" +
         half_panels([](int) { return std::string(); }) + "0 0 0 0\n";
}

std::string pnl() {
  return "    --------------Hull Mesh File---------------\n\n"
         "    # Number of Panels, Nodes, X-Symmetry and Y-Symmetry\n  4 8 0 1\n\n"
         "    #Start Definition of Node Coordinates     ! node_number   x   y   z\n" +
         half_vertices([](int i) { return fmt::format("{} ", i); }) +
         "   #End Definition of Node Coordinates\n\n"
         "   #Start Definition of Node Relations   ! panel_number  number_of_vertices ...\n" +
         half_panels([](int i) { return fmt::format("{} 4 ", i); }) +
         "   #End Definition of Node Relations\n";
}

std::string old_msh() {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n" +
         half_vertices([](int i) { return fmt::format("{} ", 10 * i); }) +
         "$EndNodes\n$Elements\n6\n1 15 2 0 1 10\n2 1 2 0 1 10 20\n3 3 2 0 1 10 40 30 20\n"
         "4 3 2 0 1 20 30 70 60\n5 3 2 0 1 30 40 80 70\n6 3 2 0 1 40 10 50 80\n$EndElements\n";
}

std::string new_msh() {
  std::string tags;
  for (int i = 1; i <= 8; ++i) tags += fmt::format("{}\n", i);
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n$EndEntities\n"
         "$Nodes\n1 8 1 8\n2 1 0 8\n" +
         tags + half_vertices([](int) { return std::string(); }) +
         "$EndNodes\n$Elements\n2 6 1 6\n1 1 1 1\n1 1 2\n2 1 3 4\n" +
         half_panels([](int i) { return fmt::format("{} ", i + 1); }) + "$EndElements\n";
}

/// The volume of the mesh with a lid at the waterline.
double volume_with_lid(const MeshFile& read, bool is_half) {
  const hydro::MendedMesh mended = hydro::mended(
      welded(read.mesh, 1e-6), {.cap = true, .mirror = is_half ? std::optional(1) : std::nullopt});
  EXPECT_THAT(describe(mended.report), testing::IsEmpty());
  EXPECT_THAT(mended.failures, testing::IsEmpty());
  return mended.report.volume;
}

std::string fault_of_panels(Reader reader, const std::string& text) {
  try {
    reader("hull", text);
  } catch (const scene::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PanelReaders, EveryFormatGivesTheWholeBoxBelowTheWaterline) {
  EXPECT_NEAR(volume_with_lid(assembly::read_gdf("a", gdf()), false), 8, support::tolerance(1e-12));
  EXPECT_NEAR(volume_with_lid(assembly::read_nemoh_mesh("a", nemoh()), false), 8,
              support::tolerance(1e-12));
  EXPECT_NEAR(volume_with_lid(assembly::read_pnl("a", pnl()), false), 8, support::tolerance(1e-12));
  EXPECT_NEAR(volume_with_lid(assembly::read_msh("a", old_msh()), true), 8,
              support::tolerance(1e-12));
  EXPECT_NEAR(volume_with_lid(assembly::read_msh("a", new_msh()), true), 8,
              support::tolerance(1e-12));
}

TEST(PanelReaders, TheGravityOfWamitTellsTheUnit) {
  EXPECT_EQ(assembly::read_gdf("a", gdf()).frame.unit, 1);
  EXPECT_EQ(assembly::read_gdf("a", gdf("1 32.174\n1 1\n3\n")).frame.unit, 0.3048);
}

TEST(PanelReaders, WithoutSymmetryNothingIsRepeated) {
  EXPECT_EQ(assembly::read_gdf("a", gdf("1 9.81\n0 0\n3\n")).mesh.face_count(), 6);
  EXPECT_EQ(assembly::read_gdf("a", gdf("1 9.81\n0 1\n3\n")).mesh.face_count(), 12);
  EXPECT_EQ(assembly::read_gdf("a", gdf()).mesh.face_count(), 24);
}

TEST(PanelReaders, FaultsHaveTheirLine) {
  EXPECT_THAT(fault_of_panels(assembly::read_gdf, gdf("1 9.81\n1 2\n3\n")),
              HasSubstr("hull:3: ISY is 2, expected 0 or 1"));
  EXPECT_THAT(fault_of_panels(assembly::read_gdf, gdf("1 9.81\n1 1\n4\n")),
              HasSubstr("the file is cut short"));
  EXPECT_THAT(fault_of_panels(assembly::read_gdf, gdf("1 9.81\n1 1\n3 2\n")),
              HasSubstr("high order"));
  EXPECT_THAT(fault_of_panels(assembly::read_nemoh_mesh, "3 1\n"), HasSubstr("hull:1: "));
  EXPECT_THAT(fault_of_panels(assembly::read_nemoh_mesh, "2 0\n1 0 0 0\n3 0 0 0\n"),
              HasSubstr("hull:3: found vertex 3, expected 2"));
  EXPECT_THAT(
      fault_of_panels(assembly::read_pnl, "1 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n1 5 1 2 3\n"),
      HasSubstr("hull:5: a panel has 5 vertices, expected 3 or 4"));
  EXPECT_THAT(fault_of_panels(assembly::read_msh, "$MeshFormat\n4.0 0 8\n"),
              HasSubstr("hull:2: the version is '4.0', expected 2.2 or 4.1"));
  EXPECT_THAT(fault_of_panels(assembly::read_msh, "$MeshFormat\n2.2 1 8\n"), HasSubstr("binary"));
  EXPECT_THAT(fault_of_panels(assembly::read_msh,
                              "$MeshFormat\n2.2 0 8\n$Elements\n1\n1 2 0 1 2 3\n$EndElements\n"),
              HasSubstr("hull:5: an element names node 1"));
}

}  // namespace
