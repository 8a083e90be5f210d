#include "app/run/radiation_warning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "hydro/mesh/primitives.h"

namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

/// A box that lies 20° heeled at rest.
engine::SimulationSpec heeled_box() {
  hydro::RadiationData data;
  data.pose.orientation = AngleAxisd(20 * M_PI / 180, Vector3d::UnitX());
  data.frequencies = {1};
  data.added_mass = {hydro::Matrix6d::Identity()};
  data.damping = {hydro::Matrix6d::Zero()};
  data.infinite_added_mass = hydro::Matrix6d::Identity();
  const hydro::TriMesh box = hydro::make_box({1, 1, 1});
  engine::BodySpec body{.name = "box", .mesh_B = box, .mass = 500};
  body.radiation = std::make_shared<const hydro::FloatingBody>(box, data);
  return {.bodies = {body}};
}

hydro::BodyState heeled_by(double degrees) {
  return {.orientation = Quaterniond(AngleAxisd(2, Vector3d::UnitZ())) *
                         AngleAxisd(degrees * M_PI / 180, Vector3d::UnitX())};
}

TEST(RadiationWarning, IsOfABodyThatTurnsFarFromItsMeanPose) {
  const engine::SimulationSpec spec = heeled_box();
  for (const double heel : {-9.0, 20.0, 49.0})
    EXPECT_FALSE(app::radiation_warning(spec, {heeled_by(heel)})) << heel;
  for (const double heel : {-11.0, 51.0, 180.0})
    EXPECT_THAT(*app::radiation_warning(spec, {heeled_by(heel)}),
                testing::HasSubstr("body 'box' has turned more than 30°"));
}

TEST(RadiationWarning, IsNotOfBodiesThatAreRoundOrWithoutRadiation) {
  engine::SimulationSpec spec = heeled_box();
  hydro::RadiationData data = spec.bodies[0].radiation->data();
  data.infinite_added_mass.bottomRightCorner<3, 3>() *= 1e-4;
  spec.bodies[0].radiation =
      std::make_shared<const hydro::FloatingBody>(spec.bodies[0].mesh_B, data);
  EXPECT_FALSE(app::radiation_warning(spec, {heeled_by(180)}));
  // One with ballast below its middle.
  const hydro::WaveFrame middle{.origin = {0, 0, 0.2}};
  data.infinite_added_mass = middle.tensor_out(data.infinite_added_mass);
  const hydro::TriMesh raised = hydro::translated(spec.bodies[0].mesh_B, {0, 0, 0.2});
  spec.bodies[0].radiation = std::make_shared<const hydro::FloatingBody>(raised, data);
  EXPECT_FALSE(app::radiation_warning(spec, {heeled_by(180)}));
  spec.bodies[0].radiation.reset();
  EXPECT_FALSE(app::radiation_warning(spec, {heeled_by(180)}));
}

}  // namespace
