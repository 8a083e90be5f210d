#include "tests/app/fmu/units.h"

#include <gtest/gtest.h>

#include "app/base/atomic_file.h"
#include "app/fmu/model_description.h"
#include "app/fmu/packed_scene.h"
#include "app/fmu/unit.h"

namespace support {

UnitFolder packed_unit(const std::string& scene, const std::string& file) {
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  UnitFolder unit;
  unit.folder = std::filesystem::path(testing::TempDir()) /
                (std::string("plimsoll_fmu_") + test.test_suite_name() + "_" + test.name());
  std::filesystem::remove_all(unit.folder);
  unit.resources = unit.folder / "resources";
  app::write_whole(unit.folder / file, scene);
  fmu::write_resources({.file = unit.folder / file}, unit.resources);
  const fmu::Unit loaded(fmu::load_scene(unit.resources, app::quiet()));
  scene::Scene named = loaded.scene();
  named.file = file;
  unit.xml = fmu::model_description(named, loaded.interface(), fmu::token_of(unit.resources));
  unit.description = described(unit.xml);
  return unit;
}

}  // namespace support
