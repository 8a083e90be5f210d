#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "app/logs/motion_columns.h"
#include "app/pages/packing.h"
#include "app/pages/thinning.h"
#include "app/report/shapes.h"
#include "hydro/mesh/primitives.h"

/// What keeps the page of a report small: fewer rows, fewer triangles, packed numbers.

namespace {

using app::base64;
using app::coarsened;
using app::packed_column;
using app::spread_rows;
using app::Thinning;
using testing::ElementsAre;

std::vector<double> ramp(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i));
  return values;
}

TEST(ReportThinning, KeepsEveryRowOfAShortLog) {
  const Thinning thinning(10, 10);
  EXPECT_FALSE(thinning.thins());
  EXPECT_EQ(thinning.values(ramp(10)), ramp(10));
  EXPECT_EQ(thinning.times(ramp(12)), ramp(10));  // rows behind the last common one are left out
}

TEST(ReportThinning, KeepsNoMoreThanAskedFor) {
  for (const std::size_t rows : {5u, 17u, 100u, 9999u})
    for (const std::size_t most : {4u, 5u, 16u, 50u}) {
      const Thinning thinning(rows, most);
      const std::size_t kept = thinning.times(ramp(rows)).size();
      EXPECT_LE(kept, most + (rows <= most ? rows : 0));
      EXPECT_EQ(kept, thinning.thins() ? 2 * ((most - 2) / 2) + 2 : rows);
      EXPECT_EQ(thinning.values(ramp(rows)).size(), kept);
    }
}

TEST(ReportThinning, KeepsAscendingTimesFromTheFirstToTheLast) {
  for (const std::size_t rows : {17u, 18u, 100u, 9999u}) {
    const std::vector<double> times = Thinning(rows, 16).times(ramp(rows));
    EXPECT_EQ(times.front(), 0);
    EXPECT_EQ(times.back(), static_cast<double>(rows - 1));
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end(), std::less_equal<>()))
        << testing::PrintToString(times);
  }
}

TEST(ReportThinning, KeepsAPeakOfASingleRowWhereverItIs) {
  constexpr std::size_t kRows = 100;
  for (std::size_t i = 0; i < kRows; ++i) {
    std::vector<double> values(kRows, 0.0);
    values[i] = 7;
    const std::vector<double> peak = Thinning(kRows, 12).values(values);
    EXPECT_EQ(std::count(peak.begin(), peak.end(), 7), 1) << i;
    values[i] = -7;
    const std::vector<double> dip = Thinning(kRows, 12).values(values);
    EXPECT_EQ(std::count(dip.begin(), dip.end(), -7), 1) << i;
  }
}

TEST(ReportThinning, KeepsTheOrderOfLeastAndLargest) {
  std::vector<double> falling = ramp(100);
  std::reverse(falling.begin(), falling.end());
  const std::vector<double> kept = Thinning(100, 12).values(falling);
  EXPECT_TRUE(std::is_sorted(kept.rbegin(), kept.rend()));
}

TEST(ReportThinning, SpreadsRowsFromTheFirstToTheLast) {
  EXPECT_THAT(spread_rows(5, 9), ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(spread_rows(101, 5), ElementsAre(0, 25, 50, 75, 100));
  EXPECT_THAT(spread_rows(1, 5), ElementsAre(0));
}

TEST(ReportPacking, WritesBase64AsRfc4648Has) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(ReportPacking, WritesAConstantColumnAsOneNumber) {
  EXPECT_EQ(packed_column({2.5, 2.5, 2.5}), 2.5);
}

TEST(ReportPacking, KeepsSmallChangesOfALargeNumber) {
  const nlohmann::ordered_json column = packed_column({1e6, 1e6 + 0.25, 1e6 - 0.5});
  EXPECT_EQ(column["base"], 1e6);
  const std::vector<float> differences = {0, 0.25F, -0.5F};
  EXPECT_EQ(column["data"], app::packed<float>(differences));
}

TEST(ReportShapes, LeavesASmallMeshAsItIs) {
  const hydro::TriMesh box = hydro::make_box({1, 2, 3}, 4);
  EXPECT_TRUE(hydro::same_mesh(coarsened(box, box.face_count()), box));
}

TEST(ReportShapes, MakesALargeMeshCoarserAndKeepsItsForm) {
  const hydro::TriMesh sphere = hydro::make_icosphere(2, 5);
  const hydro::TriMesh coarse = coarsened(sphere, 1000);
  EXPECT_LE(coarse.face_count(), 1000);
  EXPECT_GT(coarse.face_count(), 300);
  // A vertex at the mean of a cell's lies within the sphere, by a small part of the radius.
  for (const auto& v : coarse.vertices.colwise()) {
    EXPECT_LE(v.norm(), 2 * (1 + 1e-12));
    EXPECT_GT(v.norm(), 1.9);
  }
  for (Eigen::Index i = 0; i < coarse.face_count(); ++i)
    EXPECT_GT(hydro::area_vector(coarse, i).dot(coarse.vertices.col(coarse.faces(0, i))), 0);
}

TEST(ReportHeights, LeavesASmallFieldAsItIs) {
  const Eigen::MatrixXd heights = Eigen::MatrixXd::Random(3, 5);
  const hydro::HeightField field = hydro::make_height_field(heights, 0.5, {1, 2});
  EXPECT_EQ(coarsened(field, 15).heights, heights);
}

// On its points, and beyond the edges, the coarser field is the field.
TEST(ReportHeights, MakesALargeFieldCoarserAndKeepsItsEdges) {
  for (const Eigen::Index columns : {1, 2, 90, 91, 92}) {
    const Eigen::MatrixXd heights = Eigen::MatrixXd::Random(100, columns);
    const hydro::Sea sea = {.surface = hydro::make_height_field(heights, 0.5, {1, 2})};
    const auto coarse = coarsened(std::get<hydro::HeightField>(sea.surface), 50);
    EXPECT_LE(coarse.heights.size(), 50);
    EXPECT_GE(coarse.heights.size(), 20);
    EXPECT_EQ(coarse.origin, Eigen::Vector2d(1, 2));
    for (Eigen::Index i = 0; i < coarse.heights.rows(); ++i)
      for (Eigen::Index j = 0; j < coarse.heights.cols(); ++j) {
        const double x = 1 + coarse.cell * static_cast<double>(j);
        const double y = 2 + coarse.cell * static_cast<double>(i);
        EXPECT_NEAR(coarse.heights(i, j), hydro::surface_elevation(sea, x, y, 0), 1e-12);
      }
    const Eigen::Index last = coarse.heights.rows() - 1;
    EXPECT_EQ(coarse.heights(last, 0), heights(99, 0));
  }
}

TEST(ReportShapes, HasEachMeshOnce) {
  std::vector<engine::BodySpec> bodies(4);
  bodies[0].mesh_B = bodies[2].mesh_B = hydro::make_box({1, 1, 1}, 2);
  bodies[1].mesh_B = hydro::make_box({1, 1, 2}, 2);
  bodies[3].mesh_B = hydro::make_icosphere(1, 2);
  const app::Shapes shapes = app::find_shapes(bodies, 10'000);
  EXPECT_EQ(shapes.shapes.size(), 3u);
  EXPECT_THAT(shapes.of_body, ElementsAre(0, 1, 0, 2));
}

TEST(ReportShapes, SharesOutTrianglesByTheMeshesOwn) {
  std::vector<engine::BodySpec> bodies(2);
  bodies[0].mesh_B = hydro::make_icosphere(1, 4);
  bodies[1].mesh_B = hydro::make_icosphere(1, 5);
  const app::Shapes shapes = app::find_shapes(bodies, 2000);
  EXPECT_LE(shapes.shapes[0].mesh_B.face_count(), 400);
  EXPECT_LE(shapes.shapes[1].mesh_B.face_count(), 1600);
  EXPECT_GT(shapes.shapes[1].mesh_B.face_count(), 400);
  EXPECT_EQ(shapes.shapes[1].of_faces, 20 * 4 * 4 * 4 * 4 * 4);
}

/// A body that turns steadily about an axis is plotted without jumps, also where its pitch passes
/// the vertical.
TEST(ReportMotion, OfASteadyTurnHasNoJumps) {
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 1, 0),
                                      Eigen::Vector3d(1, 0, 0.2), Eigen::Vector3d(0.1, 1, 0.1)}) {
    app::BodyTrack track;
    for (int i = 0; i <= 900; ++i) {
      track.times.push_back(i);
      track.states.emplace_back();
      track.states.back().orientation = Eigen::AngleAxisd(i * M_PI / 180, axis.normalized());
    }
    const std::vector<std::vector<double>> columns = app::motion_of(track);
    double largest = 0;
    for (std::size_t k = 3; k < 6; ++k)
      for (std::size_t i = 1; i < columns[k].size(); ++i)
        largest = std::max(largest, std::abs(columns[k][i] - columns[k][i - 1]));
    // Near the vertical the angles of a turn by 1° turn by up to 1° over the sine of the tilt.
    EXPECT_LT(largest, 12) << axis.transpose();
  }
}

}  // namespace
