#include "engine/constraints/joint_rows.h"

#include "engine/base/constants.h"
#include "engine/contacts/contact_memory.h"
#include "tests/engine/prelude.h"

/// Rows of joints, contacts and lines against the velocities and separations that they stand for.

namespace {

using engine::ConstraintBlock;
using Type = JointSpec::Type;

constexpr double kSubstep = 0.01;  // [s]
const BodyState kWorldState;

Vector6d velocity_of(const BodyState& state) {
  return engine::to_vector6(state.linear_velocity, state.angular_velocity);
}

/// The state after a short time at its velocities.
BodyState moved(BodyState state, double time) {
  state.position += time * state.linear_velocity;
  const double angle = time * state.angular_velocity.norm();
  state.orientation =
      Eigen::AngleAxisd(angle, state.angular_velocity.normalized()) * state.orientation;
  return state;
}

/// J u and c of all rows of a joint.
struct Rows {
  Eigen::VectorXd rates, targets;
};
Rows rows_of(const engine::JointFrames& joint, const BodyState& first, const BodyState& second) {
  std::vector<ConstraintBlock> blocks;
  engine::add_joint_blocks(joint, first, second, blocks);
  EXPECT_EQ(static_cast<int>(blocks.size()), joint.blocks());
  std::vector<double> rates, targets;
  for (const ConstraintBlock& block : blocks)
    for (int i = 0; i < block.rows; ++i) {
      rates.push_back(block.J[0].row(i).dot(velocity_of(first)) +
                      block.J[1].row(i).dot(velocity_of(second)));
      targets.push_back(block.target[i]);
    }
  return {Eigen::Map<Eigen::VectorXd>(rates.data(), static_cast<Eigen::Index>(rates.size())),
          Eigen::Map<Eigen::VectorXd>(targets.data(), static_cast<Eigen::Index>(targets.size()))};
}

JointSpec joint_of(Type type) {
  return {.type = type,
          .first = 0,
          .second = 1,
          .anchor_W = {0.3, -0.2, 0.5},
          .axis_W = Vector3d(1, 2, -1).normalized(),
          .axis2_W = Vector3d(2, -1, 0).normalized()};
}

constexpr std::pair<Type, int> kRows[] = {
    {Type::ball, 3}, {Type::hinge, 5}, {Type::slider, 5}, {Type::fixed, 6}, {Type::universal, 4}};

TEST(JointRows, AreMetAtTheStartAndLeaveTheFreedomOfTheJoint) {
  support::Random random(1);
  for (const auto& [type, count] : kRows) {
    const BodyState first = random.state(1, 1), second = random.state(1, 1);
    const auto joint = engine::joint_frames(joint_of(type), 0, {0, 1}, first, second);
    const Rows rows = rows_of(joint, first, second);
    EXPECT_EQ(rows.targets.size(), count);
    EXPECT_LT(rows.targets.norm(), tolerance(1e-11));
  }
}

/// A state carried along with another one: turned about its centre of mass, and shifted, in W.
BodyState carried(BodyState state, const Eigen::Quaterniond& turn, const Vector3d& about,
                  const Vector3d& shift) {
  state.position = about + turn * (state.position - about) + shift;
  state.orientation = turn * state.orientation;
  return state;
}

TEST(JointRows, TheGapOfAJointIsWhatItDoesNotLeaveFree) {
  support::Random random(5);
  const double angle = 0.02, way = 0.3;
  for (const auto& [type, count] : kRows) {
    SCOPED_TRACE(count);
    const BodyState first = random.state(1, 1), second = random.state(1, 1);
    const JointSpec spec = joint_of(type);
    const auto joint = engine::joint_frames(spec, 0, {0, 1}, first, second);
    const Vector3d across = spec.axis_W.unitOrthogonal();
    const Vector3d at =
        type == Type::slider || type == Type::fixed ? second.position : spec.anchor_W;
    const auto gap = [&](const Vector3d& axis, double turn, const Vector3d& shift) {
      return engine::gap_of(
          joint, first,
          carried(second, Eigen::Quaterniond(Eigen::AngleAxisd(turn, axis)), at, shift));
    };
    const Vector3d none = Vector3d::Zero();
    const bool turns = type == Type::ball || type == Type::hinge || type == Type::universal;
    const auto free = gap(spec.axis_W, turns ? angle : 0,
                          type == Type::slider ? Vector3d(way * spec.axis_W) : none);
    EXPECT_LT(free.separation + free.turn, tolerance(1e-12));
    EXPECT_NEAR(gap(across, 0, way * across).separation, way, tolerance(1e-12));
    // A universal joint resists a turn about the normal of its axes.
    const Vector3d held =
        type == Type::universal ? Vector3d(spec.axis_W.cross(spec.axis2_W)) : across;
    EXPECT_NEAR(gap(held, angle, none).turn, type == Type::ball ? 0 : angle, tolerance(1e-12));
    EXPECT_LT(gap(held, angle, none).separation, tolerance(1e-12));
  }
}

// What two bodies come apart by in a short time is what their rows are asked to take back.
TEST(JointRows, TakeBackWhatTheirVelocitiesBringBetweenTheBodies) {
  support::Random random(2);
  const double time = 1e-6;
  for (const auto& [type, count] : kRows)
    for (const bool to_world : {false, true}) {
      SCOPED_TRACE(count);
      BodyState first = random.state(1, 1), second = to_world ? kWorldState : random.state(1, 1);
      const auto joint =
          engine::joint_frames(joint_of(type), 0, {0, to_world ? kWorld : 1}, first, second);
      const Rows before = rows_of(joint, first, second);
      const BodyState later = to_world ? second : moved(second, time);
      const Rows after = rows_of(joint, moved(first, time), later);
      const Eigen::VectorXd expected = -time * before.rates;
      EXPECT_LT((after.targets - expected).norm(), tolerance(1e-3 * expected.norm() + 1e-12));
    }
}

TEST(JointRows, OfASliderAndAHingeAllowTheirMotion) {
  support::Random random(3);
  BodyState first = random.state(1, 0), second = random.state(1, 0);
  const JointSpec spec = joint_of(Type::slider);
  const auto slider = engine::joint_frames(spec, 0, {0, 1}, first, second);
  second.position += 0.7 * spec.axis_W;
  second.linear_velocity = 2 * spec.axis_W;
  const Rows slid = rows_of(slider, first, second);
  EXPECT_LT(slid.rates.norm(), tolerance(1e-12));
  EXPECT_LT(slid.targets.norm(), tolerance(1e-11));

  const auto hinge = engine::joint_frames(joint_of(Type::hinge), 0, {0, 1}, first, second);
  const Vector3d arm = second.position - spec.anchor_W;
  second.angular_velocity = 3 * spec.axis_W;
  second.linear_velocity = second.angular_velocity.cross(arm);
  EXPECT_LT(rows_of(hinge, first, second).rates.norm(), tolerance(1e-12));
}

TEST(ContactBlock, HasTheVelocityOfItsPointAlongNormalAndTangents) {
  support::Random random(4);
  const BodyState first = random.state(1, 1), second = random.state(1, 1);
  engine::Contact contact{.pair = {0, 1},
                          .point = {.position_W = random.vector(1),
                                    .normal_W = random.vector(1).normalized(),
                                    .depth = 0.01},
                          .row = {.speed = 0.3, .compliance = 0.01},
                          .friction = 0.4};
  const ConstraintBlock block =
      engine::contact_block(contact, first.position, second.position, kSubstep);
  const Vector3d rates = block.J[0] * velocity_of(first) + block.J[1] * velocity_of(second);
  const auto at = [&](const BodyState& s) {
    return Vector3d(s.linear_velocity +
                    s.angular_velocity.cross(contact.point.position_W - s.position));
  };
  const Vector3d parting = at(first) - at(second);
  EXPECT_NEAR(rates[0], parting.dot(contact.point.normal_W), tolerance(1e-14));
  EXPECT_NEAR(rates.norm(), parting.norm(), tolerance(1e-14));
  EXPECT_NEAR(block.target[0], 0.3, tolerance(1e-14));
  EXPECT_EQ(block.limit, 0.4);
}

TEST(ContactMemory, GivesPointsTheForcesThatTurnedWithTheirBodies) {
  support::Random random(5);
  const BodyState before = random.state(1, 0), after = random.state(1, 0);
  const Eigen::Quaterniond turn = after.orientation * before.orientation.conjugate();
  std::vector<engine::Contact> contacts;
  for (int i = 0; i < 4; ++i)
    contacts.push_back({.pair = {kWorld, 2},
                        .point = {.position_W = random.vector(1), .normal_W = Vector3d::UnitZ()},
                        .row = {},
                        .force_W = random.vector(1)});
  const std::vector<engine::Contact> then = contacts;
  const auto memory = engine::remembered(contacts, [&](BodyId) { return before; });
  for (engine::Contact& contact : contacts)
    contact.point.position_W = after.position + turn * (contact.point.position_W - before.position);
  contacts.push_back({.pair = {kWorld, 5}, .point = {}, .row = {}, .force_W = {1, 1, 1}});
  engine::recall(
      memory, [&](BodyId) { return after; }, contacts);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT((contacts[i].force_W - turn * then[i].force_W).norm(), tolerance(1e-13));
  EXPECT_EQ(contacts[4].force_W, Vector3d::Zero());
}

TEST(ContactMemory, SharesForcesAmongMorePoints) {
  std::vector<engine::Contact> contacts{
      {.pair = {0, 1}, .point = {}, .row = {}, .force_W = {0, 0, 8}}};
  const auto at_origin = [](BodyId) { return BodyState{}; };
  const auto memory = engine::remembered(contacts, at_origin);
  contacts.resize(4, contacts.front());
  engine::recall(memory, at_origin, contacts);
  for (const engine::Contact& contact : contacts) EXPECT_EQ(contact.force_W, Vector3d(0, 0, 2));
}

}  // namespace
