#include "app/pictures/rigging.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/pictures/trail.h"
#include "app/render/renderer.h"
#include "hydro/mesh/primitives.h"
#include "tests/support/random_pose.h"
#include "tests/support/tolerance.h"

/// What pictures show of lines and machines.

namespace {

using app::RigPart;
using app::RigPictures;
using app::Shot;
using Eigen::Isometry3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using engine::LineSpec;

const double kPoseRoundOff = support::tolerance(1e-12);

/// Two boxes of 1 m in arbitrary poses, with what a test adds.
engine::SimulationSpec two_boxes() {
  support::Random random(11);
  engine::SimulationSpec spec;
  for (const char* name : {"a", "b"}) {
    engine::BodySpec body;
    body.name = name;
    body.mesh_B = hydro::make_box({1, 1, 1});
    body.initial = random.state(3, 0);
    spec.bodies.push_back(body);
  }
  return spec;
}

LineSpec line_between(LineSpec::Kind kind, double length) {
  return {.name = "l",
          .kind = kind,
          .first = {.body = 0, .at = {0.5, 0.2, 0.1}},
          .second = {.body = 1, .at = {-0.5, 0, 0.3}},
          .length = length,
          .stiffness = 1e4};
}

Shot shot_of(const engine::SimulationSpec& spec) {
  Shot shot;
  for (const engine::BodySpec& body : spec.bodies) shot.states.push_back(body.initial);
  shot.rig = app::rig_at_rest(spec, shot.states, 0);
  return shot;
}

render::Tube only_tube(const engine::SimulationSpec& spec, const Shot& shot) {
  RigPictures pictures(spec, false);
  pictures.include(shot);
  const render::Rigging rigging = pictures.of(shot);
  EXPECT_EQ(rigging.tubes.size(), 1u);
  return rigging.tubes.at(0);
}

TEST(RigPictures, DrawATautRopeStraightBetweenItsEnds) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::rope, 0.5)};
  const Shot shot = shot_of(spec);
  const Matrix3Xd points = only_tube(spec, shot).points_W;
  ASSERT_EQ(points.cols(), 2);
  EXPECT_EQ(points.col(0), app::place_of(spec.lines[0].first, shot.states));
  EXPECT_EQ(points.col(1), app::place_of(spec.lines[0].second, shot.states));
}

TEST(RigPictures, LetASlackRopeHangBelowItsChordAndLieOnTheGround) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::rope, 20)};
  const Shot shot = shot_of(spec);
  const Matrix3Xd hanging = only_tube(spec, shot).points_W;
  const double lower = std::min(hanging(2, 0), hanging(2, hanging.cols() - 1));
  EXPECT_LT(hanging.row(2).minCoeff(), lower - 3);
  spec.ground = engine::PlaneGround{lower - 1};
  const render::Tube tube = only_tube(spec, shot);
  EXPECT_NEAR(tube.points_W.row(2).minCoeff(), lower - 1 + tube.radius, kPoseRoundOff);
}

TEST(RigPictures, DrawAMooringFromItsFairleadToItsAnchorOnTheBottom) {
  engine::SimulationSpec spec = two_boxes();
  LineSpec line = line_between(LineSpec::Kind::mooring, 80);
  line.second = {.body = engine::kWorld, .at = {60, 20, -30}};
  line.stiffness = 1e8;
  line.weight = 500;
  spec.lines = {line};
  const Shot shot = shot_of(spec);
  EXPECT_GT(shot.rig.lines[0].tension, 0);
  const Matrix3Xd points = only_tube(spec, shot).points_W;
  const Vector3d fairlead = app::place_of(line.first, shot.states);
  EXPECT_LE((points.leftCols<1>() - fairlead).norm(), support::tolerance(1e-6));
  EXPECT_LE((points.rightCols<1>() - line.second.at).norm(), support::tolerance(1e-6));
  EXPECT_NEAR(points.row(2).minCoeff(), -30, support::tolerance(1e-6));
  const Vector3d across = Vector3d::UnitZ().cross(fairlead - line.second.at).normalized();
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    EXPECT_NEAR(across.dot(points.col(i) - fairlead), 0, support::tolerance(1e-6));
}

TEST(RigPictures, DrawASpringAsACoilThatStretches) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::spring, 1)};
  Shot shot = shot_of(spec);
  const Matrix3Xd before = only_tube(spec, shot).points_W;
  shot.states[0].position += 3 * (before.leftCols<1>() - before.rightCols<1>());
  const Matrix3Xd after = only_tube(spec, shot).points_W;
  EXPECT_EQ(before.cols(), after.cols());
  EXPECT_NEAR((after.leftCols<1>() - after.rightCols<1>()).norm(),
              4 * (before.leftCols<1>() - before.rightCols<1>()).norm(), kPoseRoundOff);
}

TEST(RigPictures, ShowABrokenLineHangingFromItsBodies) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::rope, 0.5)};
  Shot shot = shot_of(spec);
  shot.rig.lines[0].broken = true;
  const render::Rigging rigging = RigPictures(spec, false).of(shot);
  ASSERT_EQ(rigging.tubes.size(), 2u);
  for (const render::Tube& tube : rigging.tubes) {
    EXPECT_LE(tube.color.maxCoeff(), 0.2);
    EXPECT_EQ(tube.points_W(0, 0), tube.points_W(0, 1));
    EXPECT_LT(tube.points_W(2, 1), tube.points_W(2, 0));
  }
}

TEST(RigPictures, ColorLinesByTheLargestTensionOfTheSequence) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::rope, 0.5)};
  RigPictures pictures(spec, false);
  Shot shot = shot_of(spec);
  for (const double tension : {0.0, 3.1e3, 118e3}) {
    shot.rig.lines[0].tension = tension;
    pictures.include(shot);
  }
  EXPECT_EQ(pictures.scale_top(), 120e3);
  render::Annotations notes;
  pictures.explain(notes);
  ASSERT_TRUE(notes.ramp);
  EXPECT_EQ(notes.ramp->name, "tension 0 to 120 kN");
  const auto color = [&](double tension) {
    shot.rig.lines[0].tension = tension;
    return pictures.of(shot).tubes[0].color;
  };
  const Vector3d slack = color(0), green = color(40e3), yellow = color(80e3), red = color(120e3);
  EXPECT_LT(slack.maxCoeff() - slack.minCoeff(), 0.1);
  EXPECT_GT(green.y(), 2 * green.x());
  EXPECT_GT(std::min(yellow.x(), yellow.y()), 2 * yellow.z());
  EXPECT_GT(red.x(), 4 * red.y());
}

TEST(RigPictures, ColorASpringThatPushesBlue) {
  engine::SimulationSpec spec = two_boxes();
  spec.lines = {line_between(LineSpec::Kind::spring, 30)};
  RigPictures pictures(spec, false);
  const Shot shot = shot_of(spec);
  ASSERT_LT(shot.rig.lines[0].tension, 0);
  pictures.include(shot);
  const Vector3d color = pictures.of(shot).tubes[0].color;
  EXPECT_GT(color.z(), 2 * color.x());
  render::Annotations notes;
  pictures.explain(notes);
  EXPECT_EQ(notes.ramp->name.find("tension -"), 0u);
}

TEST(RigPictures, OfASceneWithoutLinesHaveNoLegend) {
  const engine::SimulationSpec spec = two_boxes();
  RigPictures pictures(spec, true);
  pictures.include(shot_of(spec));
  render::Annotations notes;
  pictures.explain(notes);
  EXPECT_FALSE(notes.ramp);
  EXPECT_TRUE(pictures.of(shot_of(spec)).empty());
}

/// A rudder and a propeller in arbitrary directions of the first box.
engine::SimulationSpec with_machines() {
  support::Random random(4);
  engine::SimulationSpec spec = two_boxes();
  const Eigen::Matrix3d axes = random.rotation().toRotationMatrix();
  spec.set_points = {{.name = "speed", .initial = 2}, {.name = "azimuth"}, {.name = "angle"}};
  engine::FoilSpec foil;
  foil.at_B = {1, 2, 3};
  foil.chord_B = axes.col(0);
  foil.span_B = axes.col(1);
  foil.foil.span = 2;
  foil.foil.chord = 1;
  foil.angle = 2;
  spec.foils = {foil};
  engine::PropellerSpec propeller;
  propeller.at_B = {-1, 0, 0.5};
  propeller.axis_B = axes.col(0);
  propeller.pivot_B = axes.col(1);
  propeller.speed = 0;
  propeller.azimuth = 1;
  spec.propellers = {propeller};
  return spec;
}

RigPart part_of(const engine::SimulationSpec& spec, RigPart::Kind kind) {
  for (const RigPart& part : app::rig_parts(spec, false))
    if (part.kind == kind) return part;
  throw std::logic_error("no such part");
}

TEST(RigParts, TurnAFoilAboutItsSpan) {
  const engine::SimulationSpec spec = with_machines();
  const engine::FoilSpec& foil = spec.foils[0];
  app::DrawnRig rig = shot_of(spec).rig;
  const RigPart part = part_of(spec, RigPart::Kind::foil);
  for (const double angle : {0.0, 0.4, -1.0}) {
    rig.foil_angles[0] = angle;
    const Isometry3d pose_B = part.turned_B(spec, rig);
    const Vector3d side = foil.span_B.cross(foil.chord_B);
    EXPECT_LE((pose_B.translation() - foil.at_B).norm(), kPoseRoundOff);
    EXPECT_LE(
        (pose_B.linear().col(0) - (std::cos(angle) * foil.chord_B - std::sin(angle) * side)).norm(),
        kPoseRoundOff);
    EXPECT_LE((pose_B.linear().col(2) - foil.span_B).norm(), kPoseRoundOff);
    EXPECT_NEAR(pose_B.linear().determinant(), 1, kPoseRoundOff);
  }
}

TEST(RigParts, TurnAPropellerByItsShaftAndThenByItsAzimuth) {
  engine::SimulationSpec spec = with_machines();
  for (const bool right_handed : {true, false}) {
    spec.propellers[0].right_handed = right_handed;
    const engine::PropellerSpec& p = spec.propellers[0];
    app::DrawnRig rig = shot_of(spec).rig;
    rig.propellers[0] = {.turn = 0.3, .azimuth = 0};
    const RigPart part = part_of(spec, RigPart::Kind::propeller);
    const Isometry3d turned = part.turned_B(spec, rig);
    EXPECT_LE((turned.linear().col(0) - p.axis_B).norm(), kPoseRoundOff);
    const Vector3d before = part.X_BP.linear().col(2), after = turned.linear().col(2);
    EXPECT_NEAR(before.cross(after).dot(p.axis_B), std::sin(right_handed ? 0.3 : -0.3),
                kPoseRoundOff);
    rig.propellers[0].azimuth = M_PI / 2;
    EXPECT_LE((part.turned_B(spec, rig).linear().col(0) - p.pivot_B.cross(p.axis_B)).norm(),
              kPoseRoundOff);
  }
}

TEST(RigParts, HaveAnAnchorThatPointsAtItsFairlead) {
  engine::SimulationSpec spec = two_boxes();
  LineSpec line = line_between(LineSpec::Kind::mooring, 80);
  line.second = {.body = engine::kWorld, .at = {60, 20, -30}};
  spec.lines = {line};
  const std::vector<RigPart> parts = app::rig_parts(spec, false);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].body, engine::kWorld);
  EXPECT_EQ(parts[0].X_BP.translation(), line.second.at);
  const Vector3d shank = parts[0].X_BP.linear().col(0);
  Vector3d toward = app::place_of(line.first, shot_of(spec).states) - line.second.at;
  toward.z() = 0;
  EXPECT_NEAR(shank.dot(toward.normalized()), 1, kPoseRoundOff);
}

TEST(RigParts, HaveJointsOnRequestThatMoveWithTheirFirstBody) {
  engine::SimulationSpec spec = two_boxes();
  using Type = engine::JointSpec::Type;
  for (const Type type : {Type::ball, Type::hinge, Type::slider, Type::fixed, Type::universal})
    spec.joints.push_back({.name = "j",
                           .type = type,
                           .first = 0,
                           .second = 1,
                           .anchor_W = {1, 2, 3},
                           .axis_W = Vector3d(1, 2, 2) / 3,
                           .axis2_W = Vector3d(2, 1, -2) / 3});
  EXPECT_TRUE(app::rig_parts(spec, false).empty());
  const std::vector<RigPart> parts = app::rig_parts(spec, true);
  ASSERT_EQ(parts.size(), 4u);  // A fixed joint has none.
  const Isometry3d X_WB = app::pose_of(spec.bodies[0].initial);
  for (const RigPart& part : parts) {
    EXPECT_EQ(part.body, 0);
    const Isometry3d X_WP = X_WB * part.turned_B(spec, {});
    const bool slides = &part == &parts[2];
    const Vector3d at = slides ? spec.bodies[1].initial.position : Vector3d(1, 2, 3);
    EXPECT_LE((X_WP.translation() - at).norm(), kPoseRoundOff);
    if (&part == &parts[0]) continue;
    EXPECT_LE((X_WP.linear().col(2) - Vector3d(1, 2, 2) / 3).norm(), kPoseRoundOff);
  }
}

TEST(DrawnRig, AtRestHasWhatTheSpecificationSays) {
  engine::SimulationSpec spec = with_machines();
  spec.lines = {line_between(LineSpec::Kind::rope, 0.5), line_between(LineSpec::Kind::rope, 50)};
  std::vector<hydro::BodyState> states = shot_of(spec).states;
  const app::DrawnRig rig = app::rig_at_rest(spec, states, 3);
  const double distance =
      (app::place_of(spec.lines[0].first, states) - app::place_of(spec.lines[0].second, states))
          .norm();
  EXPECT_NEAR(rig.lines[0].tension, 1e4 * (distance - 0.5), support::tolerance(1e-8));
  EXPECT_EQ(rig.lines[1].tension, 0);
  EXPECT_EQ(rig.lines[1].length, 50);
  EXPECT_NEAR(rig.propellers[0].turn, 12 * M_PI, kPoseRoundOff * 100);
  EXPECT_EQ(rig.foil_angles[0], 0);
}

TEST(DrawnRig, BetweenTwoTimesIsLinear) {
  const app::DrawnRig a = {.lines = {{.tension = 10, .length = 2}},
                           .propellers = {{.turn = 1, .azimuth = 0}},
                           .foil_angles = {0.2}};
  const app::DrawnRig b = {.lines = {{.tension = 30, .length = 4, .broken = true}},
                           .propellers = {{.turn = 3, .azimuth = 1}},
                           .foil_angles = {-0.2}};
  EXPECT_EQ(app::between(a, b, 1), b);
  const app::DrawnRig half = app::between(a, b, 0.5);
  EXPECT_EQ(half.lines[0].tension, 20);
  EXPECT_EQ(half.lines[0].length, 3);
  EXPECT_TRUE(half.lines[0].broken);
  EXPECT_EQ(half.propellers[0].turn, 2);
  EXPECT_EQ(half.propellers[0].azimuth, 0.5);
  EXPECT_EQ(half.foil_angles[0], 0);
}

TEST(Trail, FollowsTheBodyBetweenShots) {
  // A quarter of a circle in two shots: the cubic is within 2 % of its radius.
  const engine::SimulationSpec spec = two_boxes();
  const auto shot = [](double angle) {
    Shot made{.time = angle, .states = {{}, {}}};
    made.states[1].position = 5 * Vector3d(std::cos(angle), std::sin(angle), 0);
    made.states[1].linear_velocity = 5 * Vector3d(-std::sin(angle), std::cos(angle), 0);
    return made;
  };
  app::Trail trail(spec, "b");
  render::Rigging rigging;
  trail.add(shot(0));
  trail.draw(rigging);
  EXPECT_TRUE(rigging.tubes.empty());
  trail.add(shot(M_PI / 4));
  trail.add(shot(M_PI / 2));
  trail.draw(rigging);
  ASSERT_EQ(rigging.tubes.size(), 1u);
  const Matrix3Xd& points = rigging.tubes[0].points_W;
  EXPECT_GT(points.cols(), 50);
  EXPECT_EQ(points.col(0), Vector3d(5, 0, 0));
  EXPECT_EQ(points.rightCols<1>(), shot(M_PI / 2).states[1].position);
  for (const auto& point : points.colwise()) EXPECT_NEAR(point.norm(), 5, support::tolerance(0.1));
}

TEST(Trail, WithoutABodyToFollowIsOfThoseThatCanMove) {
  engine::SimulationSpec spec = two_boxes();
  spec.bodies[0].locked.fill(true);
  app::Trail trail(spec, "");
  render::Rigging rigging;
  for (const double time : {0.0, 1.0}) {
    Shot shot{.time = time, .states = {{}, {}}};
    shot.states[0].position.x() = shot.states[1].position.y() = time;
    trail.add(shot);
  }
  trail.draw(rigging);
  ASSERT_EQ(rigging.tubes.size(), 1u);
  EXPECT_EQ(rigging.tubes[0].points_W.rightCols<1>(), Vector3d(0, 1, 0));
}

}  // namespace
