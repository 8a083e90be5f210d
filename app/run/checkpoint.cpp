#include "app/run/checkpoint.h"

#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/base/atomic_file.h"
#include "app/base/checked_file.h"
#include "app/base/output_error.h"
#include "app/logs/run_files.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

using Json = nlohmann::ordered_json;

// The first key of the head, whose value changes with the layout.
constexpr int kFormat = 8;

Json to_json(const FilePosition& position) {
  return {{"bytes", position.bytes}, {"hash", position.hash}};
}

FilePosition position_from(const Json& json) {
  return {.bytes = json.at("bytes").get<std::uint64_t>(),
          .hash = json.at("hash").get<std::uint64_t>()};
}

Json tables_of(const LogPosition& log) {
  Json tables = Json::array();
  for (const FilePosition& table : log.tables) tables.push_back(to_json(table));
  return tables;
}

LogPosition log_from(const Json& head) {
  LogPosition log{.rows = head.at("rows").get<std::uint64_t>(),
                  .trajectory = position_from(head.at("trajectory")),
                  .forces = position_from(head.at("forces")),
                  .interior = position_from(head.at("interior")),
                  .hdf5_hashes = head.at("hdf5_hashes").get<std::vector<std::uint64_t>>()};
  for (const Json& table : head.at("tables")) log.tables.push_back(position_from(table));
  return log;
}

Json to_json(const Checkpoint& c) {
  return {{"checkpoint", kFormat},
          {"plimsoll", PLIMSOLL_VERSION},
          {"steps", c.state.steps()},
          {"source", to_json(c.source)},
          {"inputs", c.inputs},
          {"every", c.choices.every},
          {"format", c.choices.format == LogFormat::csv ? "csv" : "hdf5"},
          {"render", c.choices.render},
          {"video", c.choices.video.file.string()},
          {"fps", c.choices.video.fps},
          {"video_camera", c.choices.video.camera},
          {"rows", c.log.rows},
          {"trajectory", to_json(c.log.trajectory)},
          {"forces", to_json(c.log.forces)},
          {"interior", to_json(c.log.interior)},
          {"tables", tables_of(c.log)},
          {"hdf5_hashes", c.log.hdf5_hashes},
          {"shots", c.shots},
          {"warnings", c.warnings},
          {"rig", c.rig.state()},
          {"watch", c.watch},
          {"waves", c.waves.size()}};
}

CheckpointChoices choices_from(const Json& head) {
  return {.every = head.at("every").get<double>(),
          .format = head.at("format") == "csv" ? LogFormat::csv : LogFormat::hdf5,
          .render = head.at("render").get<bool>(),
          .video = {.file = head.at("video").get<std::string>(),
                    .fps = head.at("fps").get<int>(),
                    .camera = head.value("video_camera", "")}};
}

RigTotals rig_from(const Json& state) {
  RigTotals rig;
  rig.restore(state);
  return rig;
}

/// Collects bytes and numbers for a digest.
class Digest {
 public:
  void add(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const char*>(data);
    bytes_.insert(bytes_.end(), bytes, bytes + size);
  }
  template <class Derived>
  void add(const Eigen::PlainObjectBase<Derived>& matrix) {
    add(matrix.data(), sizeof(typename Derived::Scalar) * static_cast<std::size_t>(matrix.size()));
  }
  void add(double number) { add(&number, sizeof number); }
  std::string text() const { return fmt::format("{:016x}", hash_of(bytes_)); }

 private:
  std::vector<char> bytes_;
};

/// The values of a control may come from a file, which may change.
void add(const engine::ControlSpec& control, Digest& digest) {
  const auto* signal = std::get_if<std::shared_ptr<const engine::Signal>>(&control.source);
  if (signal == nullptr) return;
  const std::string identity = (*signal)->identity();
  digest.add(identity.data(), identity.size());
}

void add(const engine::AttachmentPoint& point, Digest& digest) {
  digest.add(point.body);
  digest.add(point.at);
}

/// A line with inertia may come from a file, which may change.
void add(const engine::LineSpec& line, Digest& digest) {
  if (!line.inertia) return;
  digest.add(line.name.data(), line.name.size());
  add(line.first, digest);
  add(line.second, digest);
  for (const double number :
       {line.length, line.stiffness, line.damping, line.weight, line.friction, line.drag_diameter,
        line.drag_coefficient, line.inertia->mass, line.inertia->drag_along,
        line.inertia->added_mass, line.inertia->bottom})
    digest.add(number);
  digest.add(line.inertia->segments);
}

/// The waves of a body may come from a file, which may change.
void add(const hydro::RadiationData& data, Digest& digest) {
  digest.add(data.infinite_added_mass);
  for (std::size_t f = 0; f < data.frequencies.size(); ++f) {
    digest.add(data.frequencies[f]);
    digest.add(data.added_mass[f]);
    digest.add(data.damping[f]);
  }
  for (const hydro::Loads6cd& load : data.diffraction) digest.add(load);
}

}  // namespace

std::string digest_of(const engine::SimulationSpec& spec) {
  Digest digest;
  digest.add(spec.step);
  for (const engine::BodySpec& body : spec.bodies) {
    digest.add(body.mesh_B.vertices);
    digest.add(body.mesh_B.faces);
    digest.add(body.mass);
    digest.add(body.inertia_B);
    digest.add(body.initial.position);
    digest.add(body.initial.orientation.coeffs());
    if (body.radiation) add(body.radiation->data(), digest);
    if (body.resistance)
      for (const double force : body.resistance->curve.forces()) digest.add(force);
    for (const engine::Opening& opening : body.openings) {
      digest.add(opening.at_B);
      digest.add(opening.area * opening.discharge);
    }
    if (body.air) digest.add(1.0);
    for (const engine::WaterAtStart& water : body.interior_water) digest.add(water.volume);
    for (const engine::PumpSpec& pump : body.pumps) {
      digest.add(pump.from_B);
      digest.add(pump.to_B.value_or(Eigen::Vector3d::Zero()));
      digest.add(pump.head);
    }
  }
  if (const auto* mesh = std::get_if<engine::MeshGround>(&spec.ground))
    digest.add(mesh->mesh_W.vertices);
  for (const engine::ControlSpec& control : spec.controls) add(control, digest);
  for (const engine::LineSpec& line : spec.lines) add(line, digest);
  if (!spec.sea) return digest.text();
  if (const auto* field = std::get_if<hydro::HeightField>(&spec.sea->surface))
    digest.add(field->heights);
  if (const auto* waves = std::get_if<hydro::WaveSurface>(&spec.sea->surface))
    for (const hydro::WaveComponent& wave : waves->components)
      for (const double number : {wave.amplitude, wave.kx, wave.ky, wave.omega, wave.phase})
        digest.add(number);
  return digest.text();
}

void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint) {
  try {
    write_whole(folder / kCheckpointFile,
                to_json(checkpoint).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" +
                    checkpoint.waves + checkpoint.state.to_bytes());
  } catch (const std::runtime_error& error) {
    throw OutputError(error.what());
  }
}

Checkpoint read_checkpoint(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kCheckpointFile;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw scene::InputError(file,
                            "is missing: the run has ended, or was started without --checkpoint");
  std::string line;
  std::getline(stream, line);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const Json head = Json::parse(line, nullptr, false);
  if (!head.is_object() || head.value("checkpoint", 0) != kFormat)
    throw scene::InputError(file, "is no checkpoint that this version of plimsoll can resume");
  try {
    const auto waves = head.at("waves").get<std::size_t>();
    return {.source = source_from(head.at("source")),
            .inputs = head.at("inputs").get<std::string>(),
            .choices = choices_from(head),
            .log = log_from(head),
            .shots = head.at("shots").get<long>(),
            .warnings = head.at("warnings").get<std::vector<std::string>>(),
            .rig = rig_from(head.at("rig")),
            .watch = head.at("watch"),
            .waves = bytes.substr(0, waves),
            .state = engine::SimulationState::from_bytes(
                std::string_view(bytes).substr(std::min(waves, bytes.size())))};
  } catch (const std::exception& error) {
    throw scene::InputError(file, fmt::format("cannot be resumed: {}", error.what()));
  }
}

void remove_checkpoint(const std::filesystem::path& folder) {
  std::filesystem::remove(folder / kCheckpointFile);
  std::filesystem::remove(folder / kShotFile);
}

}  // namespace app
