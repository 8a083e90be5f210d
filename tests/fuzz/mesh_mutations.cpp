/// @file
/// Mutates mesh files and reads each with the program's reader, which runs assimp in a process of
/// its own: `mesh_mutations [RUNS [FIRST_SEED [SECONDS]]]`.
///
/// A file may be refused; what may not happen is that a signal ends this program or that a file
/// takes longer than kLongest. Then the file is kept and the exit code is 1.

#include <assimp/scene.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <assimp/Exporter.hpp>
#include <assimp/Importer.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "app/assembly/mesh_io.h"
#include "app/scene/diagnostics.h"

namespace {

namespace fs = std::filesystem;

/// Longest time that a file may take [s]: of the processors, and a tenth of that of the clock,
/// which runs on where other programs have the processors.
constexpr double kLongest = 5;
constexpr double kLoad = 10;

/// A file to be mutated.
struct Seed {
  std::string name;
  std::string bytes;
};

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Returns the files of a folder.
std::vector<Seed> seeds_in(const fs::path& folder) {
  std::vector<Seed> seeds;
  for (const auto& entry : fs::directory_iterator(folder))
    seeds.push_back({entry.path().filename().string(), bytes_of(entry.path())});
  std::ranges::sort(seeds, {}, &Seed::name);
  return seeds;
}

/// Adds what assimp writes of a mesh in each of its formats.
void add_exported(const fs::path& mesh, const fs::path& folder, std::vector<Seed>& seeds) {
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(mesh.string(), 0);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  Assimp::Exporter exporter;
  for (std::size_t i = 0; i < exporter.GetExportFormatCount(); ++i) {
    const aiExportFormatDesc& format = *exporter.GetExportFormatDescription(i);
    const std::string name = fmt::format("{}.{}", format.id, format.fileExtension);
    if (exporter.Export(scene, format.id, (folder / name).string()) != aiReturn_SUCCESS) continue;
    seeds.push_back({name, bytes_of(folder / name)});
  }
}

/// Values at the edges of what counts and offsets are stored in.
constexpr std::int64_t kEdges[] = {0,           1,          -1,         0x7f,       0xff,
                                   0x7fff,      0xffff,     0x7fffffff, 0xffffffff, 1'000'000'000,
                                   100'000'000, -2147483648};

/// Changes a file in one to six places.
class Mutation {
 public:
  explicit Mutation(std::uint64_t seed) : engine_(seed) {}

  const Seed& chosen(const std::vector<Seed>& seeds) { return seeds[below(seeds.size())]; }

  std::string of(std::string bytes) {
    for (std::size_t changes = 1 + below(6); changes > 0 && !bytes.empty(); --changes)
      change(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(engine_() % n); }

  void change(std::string& bytes) {
    const std::size_t at = below(bytes.size());
    const std::size_t length = std::min(1 + below(64), bytes.size() - at);
    switch (below(8)) {
      case 0:
        bytes[at] = static_cast<char>(below(256));
        break;
      case 1:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
        break;
      case 2:
        bytes.erase(at, length);
        break;
      case 3:
        bytes.insert(below(bytes.size()), bytes.substr(at, length));
        break;
      case 4:
        bytes.resize(at);
        break;
      case 5:
        put_number(bytes, at);
        break;
      case 6:
        repeat(bytes, at, length);
        break;
      default:
        replace_digits(bytes, at);
    }
  }

  std::int64_t edge() { return kEdges[below(std::size(kEdges))]; }

  /// Writes a binary number over the bytes.
  void put_number(std::string& bytes, std::size_t at) {
    const std::int64_t value = edge();
    const std::size_t size = std::min<std::size_t>(std::size_t{1} << below(4), bytes.size() - at);
    bytes.replace(at, size, std::string(reinterpret_cast<const char*>(&value), size));
  }

  /// Nests or lengthens what stands there.
  void repeat(std::string& bytes, std::size_t at, std::size_t length) {
    std::string text;
    const std::string part = bytes.substr(at, length);
    for (std::size_t n = below(2000); n > 0; --n) text += part;
    bytes.insert(at, text);
  }

  /// Replaces the next decimal number.
  void replace_digits(std::string& bytes, std::size_t at) {
    constexpr const char* kDigits = "0123456789";
    const std::size_t first = bytes.find_first_of(kDigits, at);
    if (first == std::string::npos) return;
    const std::size_t last = bytes.find_first_not_of(kDigits, first);
    bytes.replace(first, last == std::string::npos ? last : last - first,
                  fmt::format("{}", edge()));
  }

  std::mt19937_64 engine_;
};

/// What became of the files, and the slowest.
struct Tally {
  std::map<std::string, long> ends;
  double slowest = 0;
  std::string slowest_file;
  long too_slow = 0;
};

double seconds_of_clock() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// Returns the time of the processors that this process and its children have used [s].
double seconds_of_processors() {
  double seconds = 0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage = {};
    ::getrusage(whose, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

/// Reads the file. @return `read`, or the kind of fault
std::string end_of(const fs::path& file) {
  try {
    assembly::read_mesh(file, scene::MeshFormats::any);
    return "read";
  } catch (const scene::InputError& error) {
    const std::string text = error.what();
    if (text.find("ends the reader") != std::string::npos)
      return "a signal ended the reader's process";
    if (text.find("takes more than") != std::string::npos) return "took too long";
    if (text.find("of memory") != std::string::npos) return "needed too much memory";
    return "refused";
  }
}

void read_mutant(const Seed& seed, const fs::path& folder, std::uint64_t number, Tally& tally) {
  Mutation mutation(number);
  const fs::path file = folder / seed.name;
  std::ofstream(file, std::ios::binary) << mutation.of(seed.bytes);
  const double clock = seconds_of_clock(), processors = seconds_of_processors();
  ++tally.ends[end_of(file)];
  const double seconds =
      std::max(seconds_of_processors() - processors, (seconds_of_clock() - clock) / kLoad);
  if (seconds > tally.slowest) {
    tally.slowest = seconds;
    tally.slowest_file = fmt::format("mutant {} of {}", number, seed.name);
  }
  if (seconds <= kLongest) return;
  ++tally.too_slow;
  const fs::path kept = folder.parent_path() / fmt::format("slow-{}-{}", number, seed.name);
  fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
  fmt::print("{}: {:.1f} s\n", kept.string(), seconds);
}

/// The file that is read when a signal ends this program.
std::string present_file;

extern "C" void say_file(int number) {
  const std::string text = "signal " + std::to_string(number) + " at " + present_file + "\n";
  if (::write(STDOUT_FILENO, text.data(), text.size()) < 0) std::_Exit(2);
  std::_Exit(1);
}

int run(long runs, std::uint64_t first, double longest_run) {
  const fs::path out = fs::path("mesh_mutants");
  const fs::path folder = out / fmt::format("{}", first);
  fs::create_directories(folder);
  const fs::path source = PLIMSOLL_SOURCE_DIR;
  std::vector<Seed> seeds = seeds_in(source / "tests/fuzz/corpus/meshes");
  add_exported(source / "tests/fuzz/corpus/meshes/cube.obj", folder, seeds);
  for (const int number : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) std::signal(number, say_file);
  Tally tally;
  const double start = seconds_of_clock();
  long i = 0;
  for (; i < runs && seconds_of_clock() - start < longest_run; ++i) {
    const std::uint64_t number = first + static_cast<std::uint64_t>(i);
    const Seed& seed = seeds[static_cast<std::size_t>(number % seeds.size())];
    present_file = (folder / seed.name).string();
    read_mutant(seed, folder, number, tally);
  }
  fmt::print("{} mutants of {} files; the slowest took {:.2f} s, {}\n", i, seeds.size(),
             tally.slowest, tally.slowest_file);
  for (const auto& [end, count] : tally.ends) fmt::print("{:>8}  {}\n", count, end);
  fmt::print("{:>8}  took more than {:g} s\n", tally.too_slow, kLongest);
  return tally.too_slow == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const long runs = argc > 1 ? std::atol(argv[1]) : 1000;
  const long first = argc > 2 ? std::atol(argv[2]) : 1;
  const double seconds = argc > 3 ? std::atof(argv[3]) : 1e9;
  try {
    return run(runs, static_cast<std::uint64_t>(first), seconds);
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 2;
  }
}
