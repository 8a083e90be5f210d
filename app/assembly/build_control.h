#pragma once

#include "app/assembly/build_shape.h"
#include "app/scene/rig_names.h"
#include "engine/base/spec.h"

namespace assembly {

/// A measurable quantity of a scene as its specification has it.
struct NamedMeasurement {
  engine::Measurement of;
  double unit = 1;  ///< SI units per unit of the name.
};
NamedMeasurement measurement_of(const scene::Scene& scene, const scene::Measurable& quantity);

/// Adds the controls of a scene to a specification that has all set points and lines: those of the
/// block `controls`, then those of loads with a formula or file. A fault of a command file goes to
/// the log.
void add_controls(engine::SimulationSpec& spec, BuildLog& log);

}  // namespace assembly
