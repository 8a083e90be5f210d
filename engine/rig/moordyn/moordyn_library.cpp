#include <fmt/format.h>
#include <moordyn/MoorDyn2.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

#include "engine/rig/moordyn/moordyn_files.h"
#include "engine/rig/moordyn/moordyn_input.h"
#include "engine/rig/moordyn/moordyn_system.h"
#include "hydro/airy_waves.h"

namespace engine {
namespace {

using Eigen::Vector3d;
namespace fs = std::filesystem;

// MoorDyn's codes of a coupled point and of a line's end B.
constexpr int kCoupledPoint = -1;
constexpr int kEndB = 1;

/// MoorDyn counts its objects in variables of the process.
std::mutex& creation() {
  static std::mutex mutex;
  return mutex;
}

/// Keeps what any thread writes to the standard streams of C++ while it lives.
class Silence {
 public:
  Silence() : out_(std::cout.rdbuf(kept_.rdbuf())), err_(std::cerr.rdbuf(kept_.rdbuf())) {}
  ~Silence() {
    std::cout.rdbuf(out_);
    std::cerr.rdbuf(err_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  std::ostringstream kept_;
  std::streambuf* out_;
  std::streambuf* err_;
};

/// Options that take the place of those of a file.
std::vector<MoorDynOption> own_options(const MoorDynSurroundings& surroundings) {
  std::vector<MoorDynOption> options = {
      {"writeLog", {}, "1"},
      {"disableOutput", {}, "1"},
      {"disableOutTime", {}, "1"},
      {"g", {"gravity"}, fmt::format("{}", surroundings.gravity)}};
  if (!surroundings.sea) return options;
  options.push_back({"WtrDnsty", {"rho"}, fmt::format("{}", surroundings.sea->density)});
  if (std::isfinite(surroundings.sea->depth))
    options.push_back({"WtrDpth", {}, fmt::format("{}", surroundings.sea->depth)});
  return options;
}

/// Place at the part s of the time h from one motion to another.
Vector3d on_cubic(const PointMotion& from, const PointMotion& to, double s, double h) {
  const double a = s * s * (3 - 2 * s);
  return (1 - a) * from.place + a * to.place +
         h * s * (1 - s) * ((1 - s) * from.velocity - s * to.velocity);
}

std::vector<double> numbers_of(const std::vector<Vector3d>& vectors, const Vector3d& origin) {
  std::vector<double> numbers;
  for (const Vector3d& v : vectors)
    for (const double number : Vector3d(v - origin)) numbers.push_back(number);
  return numbers;
}

}  // namespace

std::string why_no_moordyn() { return ""; }

std::string moordyn_version() { return PLIMSOLL_MOORDYN_VERSION; }

struct MoorDynSystem::Library {
  /// Lines at each coupled point.
  using Attached = std::vector<std::vector<MoorDynLine>>;

  struct Line {
    MoorDynLine line;
    unsigned last = 0;   ///< Its node at end B.
    bool from_b = true;  ///< Its first end is end B.
  };

  Library(const fs::path& file, const std::string& text, const MoorDynSurroundings& surroundings);
  ~Library();

  void create(const std::string& text);
  void find_points();
  void find_lines();
  /// The messages in MoorDyn's log since the last call.
  Messages news();
  [[noreturn]] void refuse(const std::string& what);
  void move(const std::vector<Vector3d>& from, const std::vector<Vector3d>& to, double time,
            double dt);
  void give_water(double time);

  fs::path file;
  MoorDynSurroundings surroundings;
  Vector3d origin = Vector3d::Zero();  ///< Origin of MoorDyn's frame, in W [m].
  TemporaryFolder folder;
  fs::path copy;
  std::ifstream log;
  MoorDyn system = nullptr;
  std::vector<std::string> warnings;
  std::vector<Vector3d> coupled;
  std::vector<Vector3d> forces;
  Attached attached;
  std::vector<Line> lines;
  std::vector<MoorDynSpec::Line> line_specs;
  bool feels_sea = false;  ///< The water that the lines feel is that of the scene.
};

MoorDynSystem::Library::Library(const fs::path& scene_file, const std::string& text,
                                const MoorDynSurroundings& around)
    : file(scene_file), surroundings(around) {
  if (surroundings.sea) origin.z() = surroundings.sea->level;
  if (has_section(text, "FAILURE"))
    throw MoorDynFault("it has a section of failures, which is not supported");
  feels_sea = surroundings.sea && option_of(text, "wavekin") == "1";
  create(text);
  try {
    find_points();
    find_lines();
  } catch (...) {
    const std::lock_guard lock(creation());
    MoorDyn_Close(system);
    throw;
  }
  warnings = news().warnings;
}

MoorDynSystem::Library::~Library() {
  const std::lock_guard lock(creation());
  MoorDyn_Close(system);
}

void MoorDynSystem::Library::create(const std::string& text) {
  copy = write_copy(file, with_options(text, own_options(surroundings)), folder.path());
  const std::lock_guard lock(creation());
  std::string more;
  try {
    // Before it has read its file MoorDyn cannot be told to say nothing.
    const Silence silence;
    system = MoorDyn_Create(copy.string().c_str());
  } catch (const std::exception& error) {
    more = std::string(" further than ") + error.what();
  }
  log.open(log_of(copy));
  if (!system) refuse("the file cannot be read" + more);
  MoorDyn_SetVerbosity(system, MOORDYN_NO_OUTPUT);
}

void MoorDynSystem::Library::find_points() {
  unsigned dofs = 0, count = 0;
  MoorDyn_NCoupledDOF(system, &dofs);
  MoorDyn_GetNumberPoints(system, &count);
  for (unsigned i = 1; i <= count; ++i) {
    const MoorDynPoint point = MoorDyn_GetPoint(system, i);
    int type = 0;
    MoorDyn_GetPointType(point, &type);
    if (type != kCoupledPoint) continue;
    Vector3d place;
    MoorDyn_GetPointPos(point, place.data());
    coupled.push_back(place);
  }
  if (dofs != 3 * coupled.size())
    throw MoorDynFault("it couples rods or bodies, expected coupled points only");
  if (coupled.empty()) throw MoorDynFault("it has no coupled point, expected one or more");
  forces.assign(coupled.size(), Vector3d::Zero());
}

void MoorDynSystem::Library::find_lines() {
  std::map<MoorDynLine, std::set<int>> coupled_ends;
  unsigned points = 0, count = 0;
  MoorDyn_GetNumberPoints(system, &points);
  for (unsigned i = 1; i <= points; ++i) {
    const MoorDynPoint point = MoorDyn_GetPoint(system, i);
    int type = 0;
    unsigned count_attached = 0;
    MoorDyn_GetPointType(point, &type);
    MoorDyn_GetPointNAttached(point, &count_attached);
    if (type != kCoupledPoint) continue;
    attached.emplace_back();
    for (unsigned k = 0; k < count_attached; ++k) {
      MoorDynLine line = nullptr;
      int end = 0;
      MoorDyn_GetPointAttached(point, k, &line, &end);
      coupled_ends[line].insert(end);
      attached.back().push_back(line);
    }
  }
  MoorDyn_GetNumberLines(system, &count);
  for (unsigned i = 1; i <= count; ++i) {
    Line line{.line = MoorDyn_GetLine(system, i)};
    MoorDynSpec::Line spec;
    MoorDyn_GetLineN(line.line, &line.last);
    MoorDyn_GetLineID(line.line, &spec.number);
    spec.segments = static_cast<int>(line.last);
    MoorDyn_GetLineUnstretchedLength(line.line, &spec.length);
    const std::set<int>& ends = coupled_ends[line.line];
    line.from_b = ends.contains(kEndB) || ends.empty();
    lines.push_back(line);
    line_specs.push_back(spec);
  }
}

Messages MoorDynSystem::Library::news() {
  log.clear();
  return messages_in(log, copy, file);
}

void MoorDynSystem::Library::refuse(const std::string& what) {
  const std::vector<std::string> errors = news().errors;
  throw MoorDynFault("MoorDyn: " + what +
                     (errors.empty() ? "" : fmt::format(" ({})", fmt::join(errors, "; "))));
}

/// Moves the coupled points straight for a time dt.
void MoorDynSystem::Library::move(const std::vector<Vector3d>& from,
                                  const std::vector<Vector3d>& to, double time, double dt) {
  const std::vector<double> x = numbers_of(from, origin), end = numbers_of(to, origin);
  std::vector<double> velocity(x.size()), f(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) velocity[i] = (end[i] - x[i]) / dt;
  if (MoorDyn_Step(system, x.data(), velocity.data(), f.data(), &time, &dt) != MOORDYN_SUCCESS ||
      !std::ranges::all_of(f, [](double number) { return std::isfinite(number); }))
    refuse(
        "the lines have lost their state; a smaller dtM or CFL among the options of their file "
        "may keep it");
  for (std::size_t i = 0; i < from.size(); ++i) forces[i] = Vector3d(&f[3 * i]);
}

/// Tells the lines how the water moves at a time.
void MoorDynSystem::Library::give_water(double time) {
  unsigned count = 0;
  MoorDyn_ExternalWaveKinGetN(system, &count);
  if (count == 0) return;
  std::vector<double> places(3 * count), velocities, accelerations;
  MoorDyn_ExternalWaveKinGetCoordinates(system, places.data());
  const hydro::Sea& sea = *surroundings.sea;
  const hydro::AiryWaves waves(sea, time);
  for (unsigned i = 0; i < count; ++i) {
    const Vector3d place = origin + Vector3d(&places[3 * i]);
    const double depth = hydro::surface_height(sea, place.x(), place.y(), time) - place.z();
    const hydro::WaterMotion water = waves.at(place, depth);
    for (const double number : water.velocity) velocities.push_back(number);
    for (const double number : water.acceleration) accelerations.push_back(number);
  }
  MoorDyn_ExternalWaveKinSet(system, velocities.data(), accelerations.data(), time);
}

MoorDynSystem::MoorDynSystem(const fs::path& file, const std::string& text,
                             const MoorDynSurroundings& surroundings)
    : library_(std::make_unique<Library>(file, text, surroundings)) {}
MoorDynSystem::~MoorDynSystem() = default;

const std::vector<std::string>& MoorDynSystem::warnings() const { return library_->warnings; }
const std::vector<Vector3d>& MoorDynSystem::coupled_points() const { return library_->coupled; }
const std::vector<MoorDynSpec::Line>& MoorDynSystem::lines() const { return library_->line_specs; }

void MoorDynSystem::start(const std::vector<Vector3d>& places) {
  Library& lib = *library_;
  const std::vector<double> x = numbers_of(places, lib.origin), still(x.size(), 0);
  if (MoorDyn_Init(lib.system, x.data(), still.data()) != MOORDYN_SUCCESS)
    lib.refuse("the lines find no rest");
  // Its files are open by now; they go with the process.
  lib.folder.remove();
  if (lib.feels_sea) {
    unsigned count = 0;
    MoorDyn_ExternalWaveKinInit(lib.system, &count);
    lib.give_water(0);
  }
  std::vector<double> f(x.size());
  double time = 0, none = 0;
  MoorDyn_Step(lib.system, x.data(), still.data(), f.data(), &time, &none);
  for (std::size_t i = 0; i < places.size(); ++i) lib.forces[i] = Vector3d(&f[3 * i]);
}

void MoorDynSystem::step(const std::vector<PointMotion>& from, const std::vector<PointMotion>& to,
                         double time, double h) {
  Library& lib = *library_;
  if (lib.feels_sea) lib.give_water(time);
  // MoorDyn moves points at constant velocities in each call, so each of its own steps has a call.
  double own = h;
  MoorDyn_GetDt(lib.system, &own);
  const int parts = static_cast<int>(std::ceil(h / std::min(own, h) - 1e-6));
  const double dt = h / parts;
  std::vector<Vector3d> now, next;
  for (const PointMotion& motion : from) now.push_back(motion.place);
  for (int part = 1; part <= parts; ++part) {
    const double s = static_cast<double>(part) / parts;
    next.clear();
    for (std::size_t i = 0; i < from.size(); ++i)
      next.push_back(part == parts ? to[i].place : on_cubic(from[i], to[i], s, h));
    lib.move(now, next, time + (part - 1) * dt, dt);
    now = next;
  }
}

std::vector<Vector3d> MoorDynSystem::forces() const { return library_->forces; }

std::vector<EndHold> MoorDynSystem::holds() const {
  std::vector<EndHold> holds;
  for (const std::vector<MoorDynLine>& lines : library_->attached) {
    EndHold& hold = holds.emplace_back();
    for (const MoorDynLine line : lines) {
      unsigned segments = 1;
      double stiffness = 0, length = 0, mass[3][3] = {};
      // MoorDyn_IsLineConstantEA says the opposite in some versions, so it is not asked: a line of
      // another law has no EA of use, as a rule 0.
      MoorDyn_GetLineConstantEA(line, &stiffness);
      MoorDyn_GetLineN(line, &segments);
      MoorDyn_GetLineUnstretchedLength(line, &length);
      MoorDyn_GetLineNodeM(line, segments / 2, mass);
      const double segment = length / segments;
      const double of_node = (mass[0][0] + mass[1][1] + mass[2][2]) / 3;
      hold.stiffness += stiffness / segment;
      hold.damping += 2 * std::sqrt(std::max(0.0, stiffness * of_node / segment));
    }
  }
  return holds;
}

std::vector<LineReading> MoorDynSystem::readings() const {
  std::vector<LineReading> readings;
  for (std::size_t i = 0; i < library_->lines.size(); ++i) {
    const Library::Line& line = library_->lines[i];
    LineReading reading{.length = library_->line_specs[i].length};
    for (unsigned k = 0; k <= line.last; ++k) {
      Vector3d& node = reading.nodes_W.emplace_back();
      MoorDyn_GetLineNodePos(line.line, line.from_b ? line.last - k : k, node.data());
      node += library_->origin;
    }
    MoorDyn_GetLineNodeForce(line.line, line.from_b ? line.last : 0, reading.force_W.data());
    reading.first_W = reading.nodes_W.front();
    reading.second_W = reading.nodes_W.back();
    reading.distance = (reading.first_W - reading.second_W).norm();
    reading.tension = reading.force_W.norm();
    reading.taut = reading.tension != 0;
    readings.push_back(reading);
  }
  return readings;
}

std::vector<std::uint64_t> MoorDynSystem::save() const {
  std::size_t bytes = 0;
  MoorDyn_Serialize(library_->system, &bytes, nullptr);
  std::vector<std::uint64_t> data(bytes / sizeof(std::uint64_t));
  MoorDyn_Serialize(library_->system, &bytes, data.data());
  return data;
}

void MoorDynSystem::load(const std::vector<std::uint64_t>& data) {
  if (MoorDyn_Deserialize(library_->system, data.data()) != MOORDYN_SUCCESS)
    library_->refuse("the state of the lines cannot be restored");
}

}  // namespace engine
