#include "app/assembly/added_mass_store.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/checked_file.h"
#include "hydro/added_mass/surface_added_mass.h"

namespace assembly {
namespace {

namespace fs = std::filesystem;
using hydro::AddedMassOptions;
using hydro::AddedMassSolution;
using hydro::SurfaceNode;
using hydro::TriMesh;

/// The last letter is the version of the file's layout. A machine of another byte order reads
/// another word.
constexpr std::uint64_t kMagic = 0x504c494d534f4c32;       // PLIMSOL2
constexpr std::uint64_t kNodesMagic = 0x504c494d53524632;  // PLIMSRF2

/// Doubles of a solution: the matrix and six numbers, and per face six potentials at three corners.
constexpr std::size_t kNumbers = 36 + 6;
constexpr std::size_t kNumbersAFace = 18;

void append_mesh(std::string& bytes, const TriMesh& mesh) {
  app::append(bytes, static_cast<std::int64_t>(mesh.vertex_count()));
  app::append(bytes, static_cast<std::int64_t>(mesh.face_count()));
  const Eigen::Matrix3Xd vertices = mesh.vertices.array() + 0.0;  // −0 is 0
  app::append(bytes, vertices.data(), static_cast<std::size_t>(vertices.size()));
  app::append(bytes, mesh.faces.data(), static_cast<std::size_t>(mesh.faces.size()));
}

/// Returns the identity of a solution, everything that it depends on.
std::string identity_of(const TriMesh& mesh, const AddedMassOptions& options) {
  std::string bytes;
  app::append(bytes, kMagic);
  app::append(bytes, std::int64_t{kAddedMassVersion});
  app::append(bytes, static_cast<std::int64_t>(options.method));
  app::append(bytes, options.tolerance);
  app::append(bytes, static_cast<std::int64_t>(options.most_panels));
  append_mesh(bytes, mesh);
  return bytes;
}

/// Returns the identity of a mesh's nodes, everything that they depend on.
std::string identity_of_nodes(const TriMesh& mesh_B) {
  std::string bytes;
  app::append(bytes, kNodesMagic);
  app::append(bytes, std::int64_t{kSurfaceVersion});
  append_mesh(bytes, mesh_B);
  return bytes;
}

/// Returns all bytes of a solution's file.
std::string encode(const std::string& identity, const AddedMassSolution& solution) {
  std::string content;
  app::append(content, solution.matrix.data(), 36);
  for (const double number :
       {solution.symmetry_error, solution.error_estimate, static_cast<double>(solution.panels),
        static_cast<double>(solution.unknowns), solution.seconds, solution.bytes})
    app::append(content, number);
  for (const hydro::CornerPotentials& psi : solution.potentials)
    app::append(content, psi.data(), kNumbersAFace);
  return app::checked(identity, content);
}

/// Returns the solution in the content of a file.
AddedMassSolution decode(const char* bytes, std::size_t faces) {
  std::array<double, kNumbers> numbers;
  std::memcpy(numbers.data(), bytes, sizeof(numbers));
  AddedMassSolution solution;
  solution.matrix = Eigen::Map<const hydro::Matrix6d>(numbers.data());
  const double* more = numbers.data() + 36;
  solution.symmetry_error = more[0];
  solution.error_estimate = more[1];
  solution.panels = static_cast<int>(more[2]);
  solution.unknowns = static_cast<int>(more[3]);
  solution.seconds = more[4];
  solution.bytes = more[5];
  const char* from = bytes + sizeof(numbers);
  solution.potentials.resize(faces);
  for (hydro::CornerPotentials& psi : solution.potentials) {
    std::memcpy(psi.data(), from, kNumbersAFace * sizeof(double));
    from += kNumbersAFace * sizeof(double);
  }
  return solution;
}

/// A node has two whole numbers and a matrix.
constexpr std::size_t kNodeBytes = 2 * sizeof(std::int64_t) + 36 * sizeof(double);

void append_node(std::string& bytes, const SurfaceNode& node) {
  app::append(bytes, std::int64_t{node.attitude});
  app::append(bytes, std::int64_t{node.draught});
  app::append(bytes, node.matrix.data(), 36);
}

SurfaceNode decode_node(const char* bytes) {
  std::int64_t place[2];
  SurfaceNode node;
  std::memcpy(place, bytes, sizeof(place));
  std::memcpy(node.matrix.data(), bytes + sizeof(place), 36 * sizeof(double));
  node.attitude = static_cast<int>(place[0]);
  node.draught = static_cast<int>(place[1]);
  return node;
}

std::string not_kept(const std::exception& error) {
  return fmt::format("the added mass is not kept for later runs: {}", error.what());
}

/// Returns the solution in a file; none if the file is missing, or, with a warning, unusable.
std::optional<AddedMassSolution> load(const fs::path& file, const std::string& identity,
                                      std::size_t faces, app::Reporter& reporter) {
  try {
    const std::size_t size = (kNumbers + kNumbersAFace * faces) * sizeof(double);
    const std::optional<std::string> content = app::read_checked(file, identity, size);
    if (content) return decode(content->data(), faces);
  } catch (const std::runtime_error& error) {
    reporter.warning(
        fmt::format("{} {}; the added mass is computed anew", file.string(), error.what()));
  }
  return std::nullopt;
}

/// Returns the value of an environment variable; none if it is unset or empty.
std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

}  // namespace

AddedMassStore::AddedMassStore(std::optional<fs::path> folder) : folder_(std::move(folder)) {}

fs::path AddedMassStore::file_named_after(const std::string& identity, const char* kind) const {
  return folder_ ? *folder_ / fmt::format("{:016x}.{}", app::hash_of(identity), kind) : fs::path();
}

fs::path AddedMassStore::file_of(const TriMesh& mesh, const AddedMassOptions& options) const {
  return file_named_after(identity_of(mesh, options), "addedmass");
}

std::optional<StoredAddedMass> AddedMassStore::find(const TriMesh& mesh,
                                                    const AddedMassOptions& options,
                                                    app::Reporter& reporter) {
  const std::string identity = identity_of(mesh, options);
  const auto known = known_.find(identity);
  if (known != known_.end()) return known->second;
  if (!folder_) return std::nullopt;
  auto solution = load(file_named_after(identity, "addedmass"), identity,
                       static_cast<std::size_t>(mesh.face_count()), reporter);
  if (!solution) return std::nullopt;
  const StoredAddedMass stored = {std::make_shared<const AddedMassSolution>(std::move(*solution)),
                                  true};
  return known_.emplace(identity, stored).first->second;
}

StoredAddedMass AddedMassStore::keep(const TriMesh& mesh, const AddedMassOptions& options,
                                     AddedMassSolution solution, app::Reporter& reporter) {
  const std::string identity = identity_of(mesh, options);
  if (folder_) {
    const fs::path file = file_named_after(identity, "addedmass");
    try {
      app::write_whole(file, encode(identity, solution));
    } catch (const std::exception& error) {
      reporter.warning(not_kept(error));
    }
  }
  const StoredAddedMass stored = {std::make_shared<const AddedMassSolution>(std::move(solution)),
                                  false};
  return known_.insert_or_assign(identity, stored).first->second;
}

fs::path AddedMassStore::nodes_file_of(const TriMesh& mesh_B) const {
  return file_named_after(identity_of_nodes(mesh_B), "surface");
}

std::vector<SurfaceNode> AddedMassStore::find_nodes(const TriMesh& mesh_B,
                                                    app::Reporter& reporter) const {
  std::vector<SurfaceNode> nodes;
  if (!folder_) return nodes;
  const fs::path file = nodes_file_of(mesh_B);
  try {
    const auto content = app::read_checked(file, identity_of_nodes(mesh_B), std::nullopt);
    for (std::size_t at = 0; content && at + kNodeBytes <= content->size(); at += kNodeBytes)
      nodes.push_back(decode_node(content->data() + at));
  } catch (const std::runtime_error& error) {
    reporter.warning(
        fmt::format("{} {}; the added mass is computed anew", file.string(), error.what()));
  }
  return nodes;
}

void AddedMassStore::keep_nodes(const TriMesh& mesh_B, const std::vector<SurfaceNode>& nodes,
                                app::Reporter& reporter) const {
  if (!folder_) return;
  std::map<std::pair<int, int>, SurfaceNode> all;
  for (const SurfaceNode& node : find_nodes(mesh_B, reporter))
    all[{node.attitude, node.draught}] = node;
  for (const SurfaceNode& node : nodes) all[{node.attitude, node.draught}] = node;
  std::string content;
  for (const auto& [place, node] : all) append_node(content, node);
  try {
    app::write_whole(nodes_file_of(mesh_B), app::checked(identity_of_nodes(mesh_B), content));
  } catch (const std::exception& error) {
    reporter.warning(not_kept(error));
  }
}

std::optional<fs::path> cache_folder() {
  if (const auto folder = variable("PLIMSOLL_CACHE")) return *folder;
  const auto cache = variable("XDG_CACHE_HOME");
  if (cache && fs::path(*cache).is_absolute()) return fs::path(*cache) / "plimsoll";
  if (const auto home = variable("HOME")) return fs::path(*home) / ".cache" / "plimsoll";
  return std::nullopt;
}

}  // namespace assembly
