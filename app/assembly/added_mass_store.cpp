#include "app/assembly/added_mass_store.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

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

constexpr const char* kSolutionKind = "addedmass";
constexpr const char* kNodesKind = "surface";

/// Doubles of a solution: the matrix and six numbers, and per face six potentials at three corners.
constexpr std::size_t kNumbers = 36 + 6;
constexpr std::size_t kNumbersAFace = 18;

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

/// Returns the content of a solution's file.
std::string encode(const AddedMassSolution& solution) {
  std::string content;
  app::append(content, solution.matrix.data(), 36);
  for (const double number :
       {solution.symmetry_error, solution.error_estimate, static_cast<double>(solution.panels),
        static_cast<double>(solution.unknowns), solution.seconds, solution.bytes})
    app::append(content, number);
  for (const hydro::CornerPotentials& psi : solution.potentials)
    app::append(content, psi.data(), kNumbersAFace);
  return content;
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

}  // namespace

AddedMassStore::AddedMassStore(std::optional<fs::path> folder)
    : files_(std::move(folder), "the added mass") {}

fs::path AddedMassStore::file_of(const TriMesh& mesh, const AddedMassOptions& options) const {
  return files_.file_of(identity_of(mesh, options), kSolutionKind);
}

std::optional<StoredAddedMass> AddedMassStore::find(const TriMesh& mesh,
                                                    const AddedMassOptions& options,
                                                    app::Reporter& reporter) {
  const std::string identity = identity_of(mesh, options);
  const auto known = known_.find(identity);
  if (known != known_.end()) return known->second;
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  const auto content = files_.read(identity, kSolutionKind,
                                   (kNumbers + kNumbersAFace * faces) * sizeof(double), reporter);
  if (!content) return std::nullopt;
  const StoredAddedMass stored = {
      std::make_shared<const AddedMassSolution>(decode(content->data(), faces)), true};
  return known_.emplace(identity, stored).first->second;
}

StoredAddedMass AddedMassStore::keep(const TriMesh& mesh, const AddedMassOptions& options,
                                     AddedMassSolution solution, app::Reporter& reporter) {
  const std::string identity = identity_of(mesh, options);
  files_.write(identity, kSolutionKind, encode(solution), reporter);
  const StoredAddedMass stored = {std::make_shared<const AddedMassSolution>(std::move(solution)),
                                  false};
  return known_.insert_or_assign(identity, stored).first->second;
}

fs::path AddedMassStore::nodes_file_of(const TriMesh& mesh_B) const {
  return files_.file_of(identity_of_nodes(mesh_B), kNodesKind);
}

std::vector<SurfaceNode> AddedMassStore::find_nodes(const TriMesh& mesh_B,
                                                    app::Reporter& reporter) const {
  std::vector<SurfaceNode> nodes;
  const auto content = files_.read(identity_of_nodes(mesh_B), kNodesKind, std::nullopt, reporter);
  for (std::size_t at = 0; content && at + kNodeBytes <= content->size(); at += kNodeBytes)
    nodes.push_back(decode_node(content->data() + at));
  return nodes;
}

void AddedMassStore::keep_nodes(const TriMesh& mesh_B, const std::vector<SurfaceNode>& nodes,
                                app::Reporter& reporter) const {
  if (!folder()) return;
  std::map<std::pair<int, int>, SurfaceNode> all;
  for (const SurfaceNode& node : find_nodes(mesh_B, reporter))
    all[{node.attitude, node.draught}] = node;
  for (const SurfaceNode& node : nodes) all[{node.attitude, node.draught}] = node;
  std::string content;
  for (const auto& [place, node] : all) append_node(content, node);
  files_.write(identity_of_nodes(mesh_B), kNodesKind, content, reporter);
}

}  // namespace assembly
