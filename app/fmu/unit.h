#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/assembly/built_scene.h"
#include "app/base/reporter.h"
#include "app/fmu/interface.h"
#include "app/held/held_simulation.h"
#include "app/scene/scene.h"

/// @file
/// An instance of a unit: a scene that an importer sets, steps and reads.

namespace fmu {

/// A scene in the resources of a unit, ready to be simulated on one thread.
struct LoadedScene {
  scene::Scene scene;
  assembly::BuiltScene built;
};

/// Reads the scene and its solutions. One that the resources lack is computed, and stored there.
/// @throws scene::InputError
LoadedScene load_scene(const std::filesystem::path& resources, app::Reporter& reporter);

/// Returns the token of the resources. @throws std::runtime_error if they have none
std::string token_of(const std::filesystem::path& resources);

/// The states of an instance, by which the standard says what may be called.
enum class Mode { instantiated, initialization, step, terminated, failed };

/// An instance of a unit. A call that is wrong leaves it as it was; one for which the simulation
/// cannot go on leaves it `failed`, from which reset() and restore() return.
class Unit {
 public:
  explicit Unit(LoadedScene loaded);

  const Interface& interface() const { return interface_; }
  const scene::Scene& scene() const { return loaded_.scene; }
  Mode mode() const { return mode_; }
  double time() const { return simulation_.engine().time(); }  ///< [s]

  /// @param start   Time of the importer [s]. @throws std::invalid_argument unless it is 0
  void enter_initialization(double start);
  void exit_initialization();
  void terminate();
  /// Goes back to time 0 and to the start values of the inputs.
  void reset();

  /// Sets an input. @throws std::invalid_argument for a variable that is none, or a value that the
  /// input cannot have
  void set(ValueReference variable, double value);
  /// Returns the value of any variable. @throws std::invalid_argument for an unknown one
  double get(ValueReference variable) const;

  /// Takes the steps of the scene from a time of the importer on.
  /// @param point   The unit's time [s].  @param size   A whole multiple of the scene's step [s].
  /// @throws std::invalid_argument for others, before any step; engine::SimulationError
  void do_step(double point, double size);

  /// Everything that changes, as bytes. @throws engine::SimulationError after a step that failed
  std::string save() const;
  /// @throws std::invalid_argument unless they are the bytes of a unit of the same scene
  void restore(std::string_view bytes);

 private:
  /// Refuses a call in the wrong mode. @throws std::logic_error
  void expect(Mode mode) const;

  LoadedScene loaded_;
  app::MotionArrays motions_;
  app::HeldSimulation simulation_;
  Interface interface_;
  Mode mode_ = Mode::instantiated;
  std::vector<double> inputs_;
  mutable std::optional<std::vector<double>> outputs_;  ///< None until they are asked for.
};

}  // namespace fmu
