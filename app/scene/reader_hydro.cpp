#include <fmt/format.h>

#include "app/scene/reader_blocks.h"
#include "hydro/decompositions.h"

namespace scene {

namespace {

using Law = hydro::ViscousDrag::Law;

/// Returns the shapes of a coefficient, of `false`, and the others.
std::vector<ValueShape> coefficient_or(const std::vector<ValueShape>& others) {
  std::vector<ValueShape> shapes = {shape(not_negative(), false, 0),
                                    {.kind = ValueShape::Kind::off}};
  shapes.insert(shapes.end(), others.begin(), others.end());
  return shapes;
}

/// Reads a coefficient, or `false`, which switches its load off.
void read_coefficient(MapReader& map, const std::string& key, double& coefficient) {
  const std::string expected = "a number >= 0, or false";
  const auto value = map.find(key, expected, number_text(coefficient), coefficient_or({}));
  if (!value) return;
  if (value->node.is_truth(false))
    coefficient = 0;
  else
    read_number(*value, not_negative(), expected, coefficient);
}

std::string drag_text(const hydro::PressureDrag& drag) {
  if (drag.front == drag.back) return number_text(drag.front);
  return "{front: " + number_text(drag.front) + ", back: " + number_text(drag.back) + "}";
}

/// Reads one C_p, `false`, or a block.
void read_pressure_drag(MapReader& map, hydro::PressureDrag& drag) {
  const std::string expected = "a number >= 0, false, or {front, back, blunt}";
  const auto value =
      map.find_unless_block("pressure_drag", expected, drag_text(drag), drag, coefficient_or({}));
  if (!value) return;
  double coefficient = 0;
  if (value->node.is_truth(false))
    drag.front = drag.back = 0;
  else if (read_number(*value, not_negative(), expected, coefficient))
    drag.front = drag.back = coefficient;
}

std::string law_text(const hydro::ViscousDrag& drag) {
  switch (drag.law) {
    case Law::none:
      return "false";
    case Law::constant:
      return number_text(drag.coefficient);
    case Law::thesis:
      return "thesis";
    case Law::ittc57:
      return "ittc57";
  }
  return "";
}

void read_viscous_drag(MapReader& map, hydro::ViscousDrag& drag) {
  const std::string expected = "a number >= 0, false, thesis or ittc57";
  const auto value = map.find("viscous_drag", expected, law_text(drag),
                              coefficient_or({words_shape({"thesis", "ittc57"})}));
  if (!value) return;
  double coefficient = 0;
  if (value->node.is_word("thesis"))
    drag.law = Law::thesis;
  else if (value->node.is_word("ittc57"))
    drag.law = Law::ittc57;
  else if (value->node.is_truth(false))
    drag.law = Law::none;
  else if (read_number(*value, not_negative(), expected, coefficient))
    drag.law = Law::constant;
  drag.coefficient = coefficient;
}

/// Reads the length of the friction line.
void read_length(MapReader& map, hydro::ViscousDrag& drag) {
  std::optional<double> length;
  if (map.optional("length", length, positive("m"))) drag.length = *length;
  if (map.has("length") && drag.law != Law::ittc57)
    map.fault("length", "is only used with viscous_drag: ittc57");
}

enum class Preset { fitted, thesis };
const ChoiceRule<Preset> kPresets = {{{"fitted", Preset::fitted}, {"thesis", Preset::thesis}}};

void read_preset(MapReader& map, hydro::Coefficients& coefficients) {
  Preset preset = Preset::fitted;
  if (!map.optional("preset", preset, kPresets)) return;
  coefficients = preset == Preset::thesis ? hydro::thesis_coefficients() : hydro::Coefficients{};
}

using Model = AddedMass::Model;
const ChoiceRule<Model> kModels = {
    {{"none", Model::none}, {"deep", Model::deep}, {"surface", Model::surface}}};

std::string model_text(const AddedMass& added_mass) {
  return added_mass.model == Model::matrix    ? "a matrix"
         : added_mass.model == Model::none    ? "none"
         : added_mass.model == Model::surface ? "{model: surface}"
                                              : "deep";
}

/// Reads a word for the model, or a block with its options.
void read_added_mass(MapReader& map, AddedMass& added_mass) {
  const std::string expected = "none, deep, {model, tolerance}, or {matrix}";
  const auto value = map.find_unless_block("added_mass", expected, model_text(added_mass),
                                           added_mass, {words_shape({"none", "deep"})});
  if (!value) return;
  if (value->node.is_word("none"))
    added_mass = {.model = Model::none};
  else if (value->node.is_word("deep"))
    added_mass = {.model = Model::deep};
  else
    value->refuse(expected);
}

using Source = Radiation::Source;

/// Reads a word, or a block with a file.
void read_radiation(MapReader& map, Radiation& radiation) {
  const std::string expected = "auto, none, {pose}, or {file}";
  const std::string before = radiation.source == Source::none        ? "none"
                             : radiation.source == Source::automatic ? "auto"
                             : radiation.source == Source::file      ? "a file"
                                                                     : "";
  const auto value = map.find_unless_block("radiation", expected, before, radiation,
                                           {words_shape({"auto", "none"})});
  if (!value) return;
  if (value->node.is_word("auto"))
    radiation = {.source = Source::automatic};
  else if (value->node.is_word("none"))
    radiation = {.source = Source::none};
  else
    value->refuse(expected);
}

using From = Resistance::Source;
const ChoiceRule<From> kWaveTheories = {{{"michell", From::michell}}};

/// Reads `none`, or a block.
void read_resistance(MapReader& map, Resistance& resistance) {
  const std::string expected = "none, {file}, or {wave}";
  const std::string before = resistance.source == From::file      ? "a file"
                             : resistance.source == From::michell ? "{wave: michell}"
                                                                  : "none";
  const auto value =
      map.find_unless_block("resistance", expected, before, resistance, {words_shape({"none"})});
  if (!value) return;
  if (value->node.is_word("none"))
    resistance = {};
  else
    value->refuse(expected);
}

using Pose = Radiation::Pose;
const ChoiceRule<Pose> kPoses = {{{"equilibrium", Pose::equilibrium}, {"start", Pose::start}}};

/// Reads a body of a database: a name, or its number.
void read_database_body(MapReader& map, std::string& body) {
  const std::string expected = "a name, or a number >= 1";
  const auto value = map.find("body", expected, "",
                              {{.kind = ValueShape::Kind::text}, shape(between(1, 1e6), true, 0)});
  if (!value) return;
  if (value->node.is(YamlNode::Kind::scalar) && !value->node.text.empty())
    body = value->node.text;
  else
    value->refuse(expected);
}

/// Round-off of a matrix that was computed elsewhere and printed, relative to its largest entry.
constexpr double kMatrixRoundOff = 1e-9;

/// Adds a fault unless the matrix is a possible added mass.
void check_matrix(MapReader& map, const hydro::Matrix6d& matrix) {
  const double scale = matrix.cwiseAbs().maxCoeff();
  Eigen::Index row, column;
  const double asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff(&column, &row);
  if (asymmetry > kMatrixRoundOff * scale)
    return map.fault(
        "matrix",
        fmt::format("found {:g} in row {}, column {}, and {:g} in row {}, column {}; expected a "
                    "symmetric matrix",
                    matrix(row, column), row + 1, column + 1, matrix(column, row), column + 1,
                    row + 1));
  if (scale == 0) return;
  const double least = hydro::eigenvalues(hydro::Matrix6d(matrix / scale))[0];
  if (least < -kMatrixRoundOff)
    map.fault("matrix", fmt::format("found the eigenvalue {:.6g}, expected a matrix without "
                                    "negative ones",
                                    scale * least));
}

/// Reads six rows of six numbers. @return true if they are present and valid
bool read_matrix(MapReader& map, hydro::Matrix6d& matrix) {
  const std::string expected = "a list of 6 lists of 6 numbers [kg, kg m, kg m^2]";
  const auto value = map.find("matrix", expected, "", {list_shape(shape(number(), false, 6), 6)});
  if (!value) return false;
  if (!value->node.is(YamlNode::Kind::list) || value->node.items.size() != 6)
    return value->refuse(expected);
  bool all = true;
  for (std::size_t i = 0; i < 6; ++i) {
    hydro::Vector6d row = hydro::Vector6d::Zero();
    all = read_numbers(value->item(i), number(), {row.data(), 6}) && all;
    matrix.row(static_cast<Eigen::Index>(i)) = row;
  }
  if (all) check_matrix(map, matrix);
  return all;
}

}  // namespace

void read(MapReader& map, hydro::PressureDrag& drag) {
  map.optional("front", drag.front, not_negative());
  map.optional("back", drag.back, not_negative());
  map.optional("blunt", drag.blunt, not_negative());
}

/// Reads a block that replaces all earlier settings, as a single key does.
void read(MapReader& map, AddedMass& added_mass) {
  added_mass = {.model = Model::deep};
  map.optional("model", added_mass.model, kModels);
  map.optional("tolerance", added_mass.tolerance, positive());
  map.note_condition("model", "none", {}, {"tolerance"});
  map.note_condition("model", "surface", {}, {"tolerance"});
  map.note_condition("matrix", "", {}, {"model", "tolerance"});
  if (!map.has("matrix")) {
    if (added_mass.model != Model::deep && map.has("tolerance"))
      map.fault("tolerance", "is only used with model: deep");
  } else {
    for (const char* key : {"model", "tolerance"})
      if (map.has(key)) map.fault(key, "given beside matrix, which is taken as it is");
  }
  if (read_matrix(map, added_mass.matrix)) added_mass.model = Model::matrix;
}

/// Reads a block that replaces all earlier settings, as a word does.
void read(MapReader& map, Radiation& radiation) {
  radiation = {.source = Source::file};
  RadiationFile& database = radiation.database;
  map.optional("pose", radiation.pose, kPoses);
  map.optional("file", database.file, FileRule{});
  for (const char* key : {"body", "reference_point", "center_of_mass", "heading_deg", "length"})
    map.note_condition(key, "", {"file"}, {});
  if (!map.has("file")) {
    radiation.source = Source::automatic;
    for (const char* key : {"body", "reference_point", "center_of_mass", "heading_deg", "length"})
      if (map.has(key) && map.has("pose")) map.fault(key, "is only used with file");
    if (!map.has("pose")) map.fault("file", "missing, expected a file, or pose");
  }
  read_database_body(map, database.body);
  map.optional("reference_point", database.reference_point, number("m"));
  map.optional("center_of_mass", database.center_of_mass, number("m"));
  map.optional("heading_deg", database.heading, degrees());
  map.optional("length", database.length, positive("m"));
  std::optional<std::array<double, 2>>& range = database.frequencies;
  if (map.optional("frequencies", range, not_negative("rad/s")) && !((*range)[0] < (*range)[1]))
    map.fault("frequencies", fmt::format("found [{:g}, {:g}], expected the least and then the "
                                         "greatest frequency",
                                         (*range)[0], (*range)[1]));
}

/// Reads a block that replaces all earlier settings, as `none` does.
void read(MapReader& map, Resistance& resistance) {
  resistance = {.source = From::file, .file = {}};
  map.optional("file", resistance.file, FileRule{});
  map.optional("wave", resistance.source, kWaveTheories);
  map.exactly_one_of({"file", "wave"});
}

void read(MapReader& map, Hydro& hydro) {
  read_preset(map, hydro);
  map.optional("buoyancy", hydro.buoyancy, TruthRule{});
  read_pressure_drag(map, hydro.pressure_drag);
  read_coefficient(map, "lift", hydro.lift);
  read_viscous_drag(map, hydro.viscous_drag);
  read_length(map, hydro.viscous_drag);
  read_added_mass(map, hydro.added_mass);
  read_radiation(map, hydro.radiation);
  read_resistance(map, hydro.resistance);
  map.optional("wave_tolerance", hydro.wave_tolerance, not_negative());
}

}  // namespace scene
