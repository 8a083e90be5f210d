#include "app/added_mass_store.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <span>
#include <vector>

#include "app/atomic_file.h"
#include "app/console.h"

namespace app {
namespace {

namespace fs = std::filesystem;
using hydro::AddedMassOptions;
using hydro::AddedMassSolution;
using hydro::TriMesh;

/// The last letter is the version of the file's layout. A machine of another byte order finds
/// another word.
constexpr std::uint64_t kMagic = 0x504c494d534f4c31;  // PLIMSOL1

/// A double of the solution: the matrix, six numbers, and six potentials at three corners a face.
constexpr std::size_t kNumbers = 36 + 6;
constexpr std::size_t kNumbersAFace = 18;

/// FNV-1a of 64 bits (Fowler, Noll, Vo): any one byte that is changed changes it.
std::uint64_t hash_of(std::span<const char> bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes)
    hash = (hash ^ static_cast<unsigned char>(byte)) * std::uint64_t{0x100000001b3};
  return hash;
}

template <class T>
void append(std::string& bytes, const T* values, std::size_t count) {
  bytes.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

template <class T>
void append(std::string& bytes, T value) {
  append(bytes, &value, 1);
}

/// All that a solution depends on.
std::string identity_of(const TriMesh& mesh, const AddedMassOptions& options) {
  std::string bytes;
  append(bytes, kMagic);
  append(bytes, std::int64_t{kAddedMassVersion});
  append(bytes, static_cast<std::int64_t>(options.method));
  append(bytes, options.tolerance);
  append(bytes, static_cast<std::int64_t>(options.most_panels));
  append(bytes, static_cast<std::int64_t>(mesh.vertex_count()));
  append(bytes, static_cast<std::int64_t>(mesh.face_count()));
  const Eigen::Matrix3Xd vertices = mesh.vertices.array() + 0.0;  // −0 is 0
  append(bytes, vertices.data(), static_cast<std::size_t>(vertices.size()));
  append(bytes, mesh.faces.data(), static_cast<std::size_t>(mesh.faces.size()));
  return bytes;
}

/// Everything in a file.
std::string encode(const std::string& identity, const AddedMassSolution& solution) {
  std::string bytes = identity;
  append(bytes, solution.matrix.data(), 36);
  for (const double number :
       {solution.symmetry_error, solution.error_estimate, static_cast<double>(solution.panels),
        static_cast<double>(solution.unknowns), solution.seconds, solution.bytes})
    append(bytes, number);
  for (const hydro::CornerPotentials& psi : solution.potentials)
    append(bytes, psi.data(), kNumbersAFace);
  append(bytes, hash_of(bytes));
  return bytes;
}

/// The solution in the bytes between a file's identity and its checksum.
AddedMassSolution decode(const char* bytes, std::size_t faces) {
  std::vector<double> numbers(kNumbers + kNumbersAFace * faces);
  std::memcpy(numbers.data(), bytes, numbers.size() * sizeof(double));
  AddedMassSolution solution;
  solution.matrix = Eigen::Map<const hydro::Matrix6d>(numbers.data());
  const double* more = numbers.data() + 36;
  solution.symmetry_error = more[0];
  solution.error_estimate = more[1];
  solution.panels = static_cast<int>(more[2]);
  solution.unknowns = static_cast<int>(more[3]);
  solution.seconds = more[4];
  solution.bytes = more[5];
  for (std::size_t f = 0; f < faces; ++f)
    solution.potentials.emplace_back(
        Eigen::Map<const hydro::CornerPotentials>(numbers.data() + kNumbers + kNumbersAFace * f));
  return solution;
}

/// What is wrong with the bytes of a file; empty if nothing is.
std::string fault_of(const std::string& bytes, const std::string& identity, std::size_t size) {
  if (bytes.size() < sizeof(kMagic) || std::memcmp(bytes.data(), &kMagic, sizeof(kMagic)) != 0)
    return "is no file of added mass";
  if (bytes.size() != size)
    return fmt::format("is damaged: {} bytes, expected {}", bytes.size(), size);
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, bytes.data() + size - sizeof(checksum), sizeof(checksum));
  if (checksum != hash_of({bytes.data(), size - sizeof(checksum)}))
    return "is damaged: its checksum is wrong";
  return bytes.starts_with(identity) ? "" : "is of another mesh or method";
}

/// The bytes of a file, of one that is too long the first of them; none if there is no file.
/// @throws std::runtime_error if there is something that cannot be read
std::optional<std::string> read_bytes(const fs::path& file, std::size_t size) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found) return std::nullopt;
  if (error) throw std::runtime_error("cannot be read: " + error.message());
  if (!fs::is_regular_file(status)) throw std::runtime_error("is no ordinary file");
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(size + 1, '\0');
  if (stream.is_open()) stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream.is_open() || stream.bad()) throw std::runtime_error("cannot be read");
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

/// What a file keeps; none, with a warning unless it is missing, if it is of no use.
std::optional<AddedMassSolution> load(const fs::path& file, const std::string& identity,
                                      std::size_t faces) {
  const std::size_t body = (kNumbers + kNumbersAFace * faces) * sizeof(double);
  const std::size_t size = identity.size() + body + sizeof(std::uint64_t);
  std::string fault;
  try {
    const std::optional<std::string> bytes = read_bytes(file, size);
    if (!bytes) return std::nullopt;
    fault = fault_of(*bytes, identity, size);
    if (fault.empty()) return decode(bytes->data() + identity.size(), faces);
  } catch (const std::runtime_error& error) {
    fault = error.what();
  }
  say(fmt::format("warning: {} {}; the added mass is computed anew", file.string(), fault));
  return std::nullopt;
}

/// The value of an environment variable that is set to something.
std::optional<std::string> variable(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr || *value == '\0') return std::nullopt;
  return value;
}

}  // namespace

AddedMassStore::AddedMassStore(std::optional<fs::path> folder) : folder_(std::move(folder)) {}

fs::path AddedMassStore::file_named_after(const std::string& identity) const {
  return folder_ ? *folder_ / fmt::format("{:016x}.addedmass", hash_of(identity)) : fs::path();
}

fs::path AddedMassStore::file_of(const TriMesh& mesh, const AddedMassOptions& options) const {
  return file_named_after(identity_of(mesh, options));
}

std::optional<StoredAddedMass> AddedMassStore::find(const TriMesh& mesh,
                                                    const AddedMassOptions& options) {
  const std::string identity = identity_of(mesh, options);
  const auto known = known_.find(identity);
  if (known != known_.end()) return known->second;
  if (!folder_) return std::nullopt;
  auto solution =
      load(file_named_after(identity), identity, static_cast<std::size_t>(mesh.face_count()));
  if (!solution) return std::nullopt;
  const StoredAddedMass stored = {std::make_shared<const AddedMassSolution>(std::move(*solution)),
                                  true};
  return known_.emplace(identity, stored).first->second;
}

StoredAddedMass AddedMassStore::keep(const TriMesh& mesh, const AddedMassOptions& options,
                                     AddedMassSolution solution) {
  const std::string identity = identity_of(mesh, options);
  if (folder_) {
    const fs::path file = file_named_after(identity);
    try {
      write_whole(file, encode(identity, solution));
    } catch (const std::exception& error) {
      say(fmt::format("warning: the added mass is not kept for later runs: {}", error.what()));
    }
  }
  const StoredAddedMass stored = {std::make_shared<const AddedMassSolution>(std::move(solution)),
                                  false};
  return known_.insert_or_assign(identity, stored).first->second;
}

std::optional<fs::path> cache_folder() {
  if (const auto folder = variable("PLIMSOLL_CACHE")) return *folder;
  const auto cache = variable("XDG_CACHE_HOME");
  if (cache && fs::path(*cache).is_absolute()) return fs::path(*cache) / "plimsoll";
  if (const auto home = variable("HOME")) return fs::path(*home) / ".cache" / "plimsoll";
  return std::nullopt;
}

}  // namespace app
