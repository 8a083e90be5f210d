#include "engine/rig/moordyn/moordyn_system.h"

/// @file
/// Replaces moordyn_library.cpp in a build without the library.

namespace engine {

std::string why_no_moordyn() {
  return "this plimsoll was built without MoorDyn; build and install MoorDyn v2 "
         "(https://github.com/FloatingArrayDesign/MoorDyn) and build plimsoll again from a new "
         "configuration, with -DCMAKE_PREFIX_PATH=PREFIX for an installation in another folder";
}

std::string moordyn_version() { return ""; }

struct MoorDynSystem::Library {};

MoorDynSystem::MoorDynSystem(const std::filesystem::path&, const std::string&,
                             const MoorDynSurroundings&) {
  throw MoorDynFault(why_no_moordyn());
}
MoorDynSystem::~MoorDynSystem() = default;

const std::vector<std::string>& MoorDynSystem::warnings() const {
  static const std::vector<std::string> none;
  return none;
}
const std::vector<Eigen::Vector3d>& MoorDynSystem::coupled_points() const {
  static const std::vector<Eigen::Vector3d> none;
  return none;
}
const std::vector<MoorDynSpec::Line>& MoorDynSystem::lines() const {
  static const std::vector<MoorDynSpec::Line> none;
  return none;
}
void MoorDynSystem::start(const std::vector<Eigen::Vector3d>&) {}
void MoorDynSystem::step(const std::vector<PointMotion>&, const std::vector<PointMotion>&, double,
                         double) {}
std::vector<Eigen::Vector3d> MoorDynSystem::forces() const { return {}; }
std::vector<EndHold> MoorDynSystem::holds() const { return {}; }
std::vector<LineReading> MoorDynSystem::readings() const { return {}; }
std::vector<std::uint64_t> MoorDynSystem::save() const { return {}; }
void MoorDynSystem::load(const std::vector<std::uint64_t>&) {}

}  // namespace engine
