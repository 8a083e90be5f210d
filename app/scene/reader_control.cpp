#include <fmt/format.h>

#include "app/scene/formula.h"
#include "app/scene/reader_blocks.h"

namespace scene {

namespace {

const char* const kFormulaExpected = "a number or a formula in t";
const char* const kMeasuredExpected = "the name of a measured quantity";

const ChoiceRule<Interpolation> kInterpolations = {
    {{"linear", Interpolation::linear}, {"step", Interpolation::step}}};

}  // namespace

bool read_formula(MapReader& map, const std::string& key, std::string& formula, bool required) {
  const auto value = map.find(key, kFormulaExpected, required ? "required" : "",
                              {{.kind = ValueShape::Kind::text}});
  if (!value) return false;
  if (!value->node.is(YamlNode::Kind::scalar) || value->node.text.empty())
    return value->refuse(kFormulaExpected);
  try {
    const Formula checked(value->node.text);
  } catch (const FormulaError& error) {
    value->fault(error.what());
    return false;
  }
  formula = value->node.text;
  return true;
}

bool read_command_file(MapReader& map, CommandFile& file) {
  const bool found = map.optional("file", file.file, FileRule{});
  map.optional("column", file.column, TextRule{"the name of a column"});
  map.optional("interpolation", file.interpolation, kInterpolations);
  for (const char* key : {"column", "interpolation"}) {
    map.note_condition(key, "", {"file"}, {});
    if (map.has(key) && !map.has("file")) map.fault(key, "is only used with file");
  }
  return found;
}

void read(MapReader& map, PidControl& pid) {
  map.required("of", pid.of, TextRule{kMeasuredExpected});
  read_formula(map, "target", pid.target, true);
  map.required("kp", pid.kp, number());
  map.optional("ki", pid.ki, number());
  map.optional("kd", pid.kd, number());
  if (map.optional("limits", pid.limits, number()) && (*pid.limits)[0] >= (*pid.limits)[1])
    map.fault("limits", "expected the lower limit first: [lo, hi] with lo < hi");
}

void read(MapReader& map, RelayControl& relay) {
  map.required("of", relay.of, TextRule{kMeasuredExpected});
  const bool low = map.required("low", relay.low, number());
  const bool high = map.required("high", relay.high, number());
  map.required("values", relay.values, number());
  if (low && high && relay.low > relay.high)
    map.fault("high",
              fmt::format("found {:g}, expected at least low ({:g})", relay.high, relay.low));
}

void read(MapReader& map, Control& control) {
  map.required("set", control.set, TextRule{"the name of a set point"});
  map.exactly_one_of({"file", "formula", "pid", "relay"});
  CommandFile file;
  if (read_command_file(map, file)) control.source = file;
  std::string formula;
  if (read_formula(map, "formula", formula, false)) control.source = formula;
  map.alternative<PidControl>("pid", control.source);
  map.alternative<RelayControl>("relay", control.source);
  map.optional("start", control.start, not_negative("s"));
  map.optional("rate", control.rate, positive("unit of the set point/s"));
}

}  // namespace scene
