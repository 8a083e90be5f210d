#include "app/run/piece_warning.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hydro/loads/refine.h"
#include "hydro/mesh/primitives.h"
#include "hydro/wave_spectrum.h"

namespace {

using testing::HasSubstr;
using testing::Optional;

/// A box in a chop whose waves are about 1 m long.
engine::SimulationSpec box_in_chop(const Eigen::Vector3d& size) {
  engine::SimulationSpec spec;
  hydro::Sea& sea = spec.sea.emplace();
  sea.surface =
      hydro::jonswap_sea({.significant_height = 0.07, .peak_period = 0.83, .components = 64}, sea);
  spec.bodies.resize(1);
  spec.bodies[0].name = "box";
  spec.bodies[0].mesh_B = hydro::make_box(size);
  spec.bodies[0].wet = true;
  return spec;
}

TEST(PieceWarning, NamesABodyThatIsSplitNoFurther) {
  const engine::SimulationSpec spec = box_in_chop({40, 10, 6});
  EXPECT_THAT(app::piece_warning(spec),
              Optional(testing::AllOf(HasSubstr("body 'box'"), HasSubstr("hydro.wave_tolerance"))));
}

TEST(PieceWarning, IsSilentWherePiecesDo) {
  engine::SimulationSpec spec = box_in_chop({1, 1, 1});
  EXPECT_FALSE(app::piece_warning(spec));
  spec.bodies[0].summation.wave_tolerance = 1e-6;
  EXPECT_TRUE(app::piece_warning(spec));
  spec.bodies[0].wet = false;
  EXPECT_FALSE(app::piece_warning(spec));
  spec.sea->surface = hydro::FlatSurface{};
  EXPECT_FALSE(app::piece_warning(spec));
}

}  // namespace
