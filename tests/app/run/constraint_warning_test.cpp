#include "app/run/constraint_warning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using testing::HasSubstr;

TEST(ConstraintWarning, NamesTheBodyWhoseForcesMissedTheirToleranceMostOften) {
  engine::SimulationSpec spec;
  spec.bodies.resize(3);
  spec.bodies[0].name = "quay";
  spec.bodies[1].name = "crate";
  spec.bodies[2].name = "lid";
  std::vector<engine::Counts> counts(3);
  EXPECT_FALSE(app::constraint_warning(spec, counts));
  EXPECT_FALSE(app::constraint_warning({}, {}));
  counts[1].unconverged = 4;
  counts[1].substeps = 100;
  EXPECT_THAT(
      *app::constraint_warning(spec, counts),
      HasSubstr("on body 'crate' missed their tolerance in 4 of its 100 pieces of motion: "));
  counts[2].unconverged = 3;
  EXPECT_THAT(*app::constraint_warning(spec, counts),
              HasSubstr("'crate' missed their tolerance in 4 of its 100 pieces of motion, and on 1 "
                        "other body in some: "));
}

}  // namespace
