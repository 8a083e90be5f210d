#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "engine/simulation.h"
#include "tests/engine/specs.h"
#include "tests/support/random_pose.h"
#include "tests/support/repeats.h"
#include "tests/support/tolerance.h"

/// @file
/// What the test files of the engine begin with. Test programs only.

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using engine::BodyId;
using engine::BodySpec;
using engine::CollisionShape;
using engine::JointSpec;
using engine::kWorld;
using engine::Simulation;
using engine::SimulationSpec;
using hydro::BodyState;
using hydro::Matrix6d;
using hydro::Vector6d;
using support::distance;
using support::kGravity;
using support::kStep;
using support::tolerance;
