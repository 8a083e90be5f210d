#include "app/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/scene/include.h"
#include "app/scene/reader_blocks.h"
#include "app/scene/reader_overrides.h"
#include "app/scene/repeat.h"
#include "app/scene/rig_names.h"
#include "app/scene/variables.h"
#include "app/scene/yaml_reader.h"
#include "app/scene/yaml_text.h"

namespace scene {

namespace {

/// Keys of the top level that begin so are places for anchors.
const char* const kUnread = "x-";

const char* const kVersion = "1";
const char* const kVersionExpected = "1, the version of the scene format";

/// Interval of the log, a flag for the log of forces, and the probes.
struct LogBlock {
  std::optional<double> every;
  bool forces = false;
  std::vector<Probe> probes;
};

void read(MapReader& map, LogBlock& log) {
  map.optional("every", log.every, not_negative("s"));
  if (log.every == 0.0) log.every.reset();
  map.optional("forces", log.forces, TruthRule{});
  map.blocks("probes", log.probes);
}

/// Stands for a variable in the list of keys.
struct VariableBlock {};

void read(MapReader& map, std::vector<VariableBlock>&) {
  for (const std::string& name : map.names())
    map.find(name, "a number or a text", "", {{.kind = ValueShape::Kind::text}});
}

/// The ground and its surface.
struct GroundBlock {
  Ground ground;
  double friction = Scene().ground_friction;
  double restitution = Scene().ground_restitution;
  std::optional<BedSuction> suction;
};

void read(MapReader& map, GroundBlock& block) {
  read(map, block.ground);
  read_surface(map, block.friction, block.restitution);
  map.block("suction", block.suction);
}

/// Adds a fault for each name of a body that there is not. `list` is the path of the list.
template <class T>
void check_bodies_of(MapReader& map, const Scene& scene, const std::string& list,
                     const std::vector<T>& pairs) {
  std::vector<std::string> known = names_of(scene.bodies);
  known.push_back("world");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const std::string& name = pairs[i].bodies[k];
      if (name.empty() || std::find(known.begin(), known.end(), name) != known.end()) continue;
      map.fault(fmt::format("{}[{}].bodies[{}]", list, i, k),
                fmt::format("there is no body named {}{}", name, app::did_you_mean(name, known)));
    }
  }
}

/// Checks what `start: equilibrium` needs from other blocks of the scene.
void check_starts(MapReader& map, const Scene& scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (scene.bodies[i].start != Start::equilibrium) continue;
    const std::string key = fmt::format("bodies[{}].start", i);
    if (!scene.water && !map.has("water"))
      map.fault(key, "equilibrium needs water, and the scene has none");
    if (scene.gravity == 0) map.fault(key, "equilibrium needs gravity, which is 0 in this scene");
  }
}

/// Refuses air without water, above which it is.
void check_air(MapReader& map, const Scene& scene) {
  if (scene.air && !map.has("water"))
    map.fault("air", "needs water, and the scene has none: wind acts on what is above the water");
}

/// Refuses waves without gravity, which is what moves them.
void check_waves(MapReader& map, const Scene& scene) {
  if (scene.gravity != 0 || !scene.water) return;
  const Surface& surface = scene.water->surface;
  if (!std::holds_alternative<Flat>(surface) && !std::holds_alternative<HeightField>(surface))
    map.fault("water.surface", "waves need gravity, which is 0 in this scene");
}

/// Refuses lines, machines and suction under ODE's own step, which does not know them.
void check_method(MapReader& map, const Scene& scene) {
  if (scene.integrator.method != Integrator::Method::ode) return;
  if (scene.suction)
    map.fault("integrator.method", "method ode knows no ground.suction; expected split");
  for (const char* list : {"springs", "ropes", "moorings", "propellers", "rudders", "sails"})
    if (map.has(list))
      return map.fault("integrator.method",
                       fmt::format("method ode knows no lines and machines, and the scene has {}; "
                                   "expected split",
                                   list));
}

void name_nameless_joints(std::vector<Joint>& joints) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (joints[i].name.empty()) joints[i].name = fmt::format("joint{}", i);
}

/// Records the place of every key below `node`, and of a repeated key the first place.
void collect_places(const YamlNode& node, const std::string& path, Reading& reading) {
  reading.places.emplace(path, reading.place(node.mark));
  for (std::size_t i = 0; i < node.items.size(); ++i)
    collect_places(node.items[i], fmt::format("{}[{}]", path, i), reading);
  for (const YamlEntry& entry : node.entries) {
    const std::string child = path.empty() ? entry.key : path + "." + entry.key;
    collect_places(entry.value, child, reading);
  }
}

/// Lists the blocks that have a key of this name: `at the top level`, `under bodies[]`.
std::vector<std::string> homes_of(const std::string& key,
                                  const std::vector<KeyDescription>& catalogue) {
  std::vector<std::string> homes;
  for (const KeyDescription& known : catalogue) {
    const std::size_t dot = known.path.rfind('.');
    if (known.path.substr(dot + 1) == key)  // npos + 1 is 0
      homes.push_back(dot == std::string::npos ? "at the top level"
                                               : "under " + known.path.substr(0, dot));
  }
  return homes;
}

/// Suggests a replacement of an unknown key, in this order: a key with one letter changed, the
/// block where the key belongs, the key with its unit, a key with more letters changed.
std::string advice(const UnknownKey& unknown, const std::vector<KeyDescription>& catalogue) {
  const std::vector<std::string> homes = homes_of(unknown.key, catalogue);
  if (const auto near = app::nearest(unknown.key, unknown.known, homes.empty() ? 0 : 1))
    return fmt::format("; did you mean {}?", *near);
  if (!homes.empty()) return fmt::format("; it belongs {}", app::enumerate(homes, "or"));
  for (const std::string& known : unknown.known)
    if (known.starts_with(unknown.key + "_")) return fmt::format("; did you mean {}?", known);
  const std::string hint = app::did_you_mean(unknown.key, unknown.known);
  if (!hint.empty()) return hint;
  return unknown.known.empty() ? ", no key is known here"
                               : "; known here: " + app::enumerate(unknown.known, "and");
}

void add_unknown_keys(Reading& reading) {
  if (reading.unknown_keys.empty()) return;
  const std::vector<KeyDescription> catalogue = key_catalogue().keys;
  for (const UnknownKey& unknown : reading.unknown_keys) {
    const std::string dot = unknown.block_path.empty() ? "" : ".";
    reading.faults.add({unknown.place, unknown.block_path + dot + unknown.key,
                        "unknown key" + advice(unknown, catalogue)});
  }
}

/// Refuses a file of another version, whose keys may have other meanings.
void check_version(const YamlNode& root, Reading& reading) {
  const YamlNode* version = root.find("plimsoll");
  if (version == nullptr || (version->is_word(kVersion) && !version->quoted)) return;
  reading.fault("plimsoll", fmt::format("found {}, expected {}, the only version of the scene "
                                        "format that this program reads",
                                        describe(*version), kVersion));
  reading.faults.throw_if_any();
}

/// Applies overrides. @return those that name what is not there yet
std::vector<Override> apply_early(const std::vector<Override>& overrides, YamlNode& root) {
  std::vector<Override> later;
  for (const Override& override : overrides) {
    Faults faults;
    apply_override(override, root, faults);
    if (!faults.empty()) later.push_back(override);
  }
  return later;
}

/// Reads the text of a scene as a tree in which nothing is short: with the files that it includes
/// and the copies of what it repeats, without variables.
/// @throws InputError with all faults of these
YamlNode read_tree(const std::string& text, Reading& reading,
                   const std::vector<Override>& overrides) {
  const std::filesystem::path& file = reading.file;
  YamlNode root = parse_yaml(text, file);
  if (root.is(YamlNode::Kind::null)) throw InputError(file, "found no keys, expected a scene");
  if (!root.is(YamlNode::Kind::map))
    throw InputError({Fault{{file, root.mark.line, root.mark.column},
                            "",
                            "found " + describe(root) + ", expected a map of keys"}});
  const auto of_include = [](const Override& o) { return o.key_path.starts_with(kInclude); };
  std::vector<Override> first, others;
  std::ranges::partition_copy(overrides, std::back_inserter(first), std::back_inserter(others),
                              of_include);
  for (const Override& override : first) apply_override(override, root, reading.faults);
  reading.faults.throw_if_any();
  const bool includes = root.find(kInclude) != nullptr;
  include_files(root, file);
  if (includes) reading.joined = yaml_text(root);
  const std::vector<Override> later = apply_early(others, root);
  std::erase_if(root.entries, [](const YamlEntry& e) { return e.key.starts_with(kUnread); });
  collect_places(root, "", reading);
  Variables variables;
  try {
    if (const YamlNode* map = root.find("variables")) variables = read_variables(*map);
  } catch (const VariableFault& fault) {
    const std::string path = fault.name.empty() ? "variables" : "variables." + fault.name;
    reading.faults.add({reading.place(fault.mark), path, fault.message});
    reading.faults.throw_if_any();
  }
  std::erase_if(root.entries, [](const YamlEntry& e) { return e.key == "variables"; });
  expand(variables, root, reading);
  // The name of a copy, as crate_7, is known from here on.
  for (const Override& override : later) apply_override(override, root, reading.faults);
  add_unknown_keys(reading);
  reading.faults.throw_if_any();
  reading.places.clear();
  return root;
}

}  // namespace

void check_unique(MapReader& map, const std::string& list, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (std::size_t i = 0; i < names.size(); ++i)
    entries.emplace_back(fmt::format("{}[{}]", list, i), names[i]);
  check_unique(map, entries);
}

void check_unique(MapReader& map, const std::vector<std::pair<std::string, std::string>>& entries) {
  std::map<std::string, std::string> first_uses;
  for (const auto& [path, name] : entries) {
    const auto [first, is_new] = first_uses.emplace(name, path);
    if (is_new || name.empty()) continue;
    map.fault(path + ".name", fmt::format("found {}, which is the name of {}; expected another",
                                          name, first->second));
  }
}

void read(MapReader& map, Integrator& integrator) {
  using Method = Integrator::Method;
  map.optional("method", integrator.method,
               ChoiceRule<Method>{{{"split", Method::split}, {"ode", Method::ode}}});
  map.optional("tolerance", integrator.tolerance, positive("1/s"));
  map.note_condition("method", "ode", {}, {"tolerance"});
  if (integrator.method == Method::ode && integrator.tolerance)
    map.fault("tolerance", "method ode takes whole steps only; expected method split with it");
  map.refuse_former("sleep", "has no effect: bodies at rest move on like all others; remove it");
}

void read(MapReader& map, Scene& scene) {
  map.find("plimsoll", kVersionExpected, "required",
           {{.kind = ValueShape::Kind::whole, .lo = 1, .hi = 1}});
  map.optional("title", scene.title, TextRule{});
  // A tree that is read has neither of these any more; here they are listed.
  map.find("include", "a file, or a list of files", "[]",
           {{.kind = ValueShape::Kind::file}, list_shape({.kind = ValueShape::Kind::file}, 0)});
  std::vector<VariableBlock> none;
  map.block("variables", none);
  map.required("duration", scene.duration, not_negative("s"));
  map.optional("step", scene.step, positive("s"));
  map.optional("gravity", scene.gravity, not_negative("m/s^2"));
  map.block("integrator", scene.integrator);
  map.block("water", scene.water);
  map.block("air", scene.air);
  map.note_condition("air", "", {"water"}, {});
  GroundBlock ground;
  map.block("ground", ground);
  scene.ground = std::move(ground.ground);
  scene.ground_friction = ground.friction;
  scene.ground_restitution = ground.restitution;
  scene.suction = ground.suction;
  Body prototype;
  map.block("hydro", prototype.hydro);
  map.blocks("bodies", scene.bodies, prototype);
  map.blocks("joints", scene.joints);
  map.blocks("contacts", scene.contacts);
  map.blocks("springs", scene.springs);
  map.blocks("ropes", scene.ropes);
  map.blocks_or_block("moorings", scene.moorings, scene.moordyn);
  map.blocks("propellers", scene.propellers);
  map.blocks("rudders", scene.rudders);
  map.blocks("sails", scene.sails);
  map.blocks("controls", scene.controls);
  LogBlock log;
  map.block("log", log);
  scene.log_every = log.every;
  scene.log_forces = log.forces;
  scene.probes = std::move(log.probes);
  map.block("render", scene.render);

  name_nameless_joints(scene.joints);
  check_unique(map, "bodies", names_of(scene.bodies));
  check_unique(map, "joints", names_of(scene.joints));
  check_bodies_of(map, scene, "joints", scene.joints);
  check_bodies_of(map, scene, "contacts", scene.contacts);
  check_contacts(map, scene);
  check_unique(map, "log.probes", names_of(scene.probes));
  check_probes(map, scene);
  check_followed_bodies(map, scene);
  check_starts(map, scene);
  check_waves(map, scene);
  check_air(map, scene);
  check_method(map, scene);
  check_rig(map, scene);
}

bool is_scene_file(const std::filesystem::path& file) {
  return file.extension() == ".yaml" || file.extension() == ".yml";
}

Scene read(const std::filesystem::path& file, const std::vector<Override>& overrides,
           MeshFormats formats) {
  return parse(read_text(file), file, overrides, formats);
}

Scene parse(std::string text, const std::filesystem::path& file,
            const std::vector<Override>& overrides, MeshFormats formats) {
  Reading reading;
  reading.file = file;
  const YamlNode root = read_tree(text, reading, overrides);
  collect_places(root, "", reading);
  check_version(root, reading);

  Scene scene;
  MapReader map(&root, "", reading);
  read(map, scene);
  map.report_other_keys();
  add_unknown_keys(reading);
  reading.faults.throw_if_any();

  scene.file = file;
  scene.mesh_formats = formats;
  // Files that are included may change or be gone when the scene is read again.
  scene.text = reading.joined.empty() ? std::move(text) : std::move(reading.joined);
  scene.places = std::move(reading.places);
  return scene;
}

std::string resolved_text(const std::filesystem::path& file,
                          const std::vector<Override>& overrides) {
  return resolved_text_of(read_text(file), file, overrides);
}

std::string resolved_text_of(const std::string& text, const std::filesystem::path& file,
                             const std::vector<Override>& overrides) {
  Reading reading;
  reading.file = file;
  return yaml_text(read_tree(text, reading, overrides));
}

KeyCatalogue key_catalogue() {
  Reading reading;
  MapReader map(nullptr, "", reading);
  Scene scene;
  read(map, scene);
  return std::move(reading.catalogue);
}

}  // namespace scene
