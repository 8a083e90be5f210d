#include "app/assembly/radiation_store.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>

#include "app/assembly/solve_time.h"
#include "app/base/checked_file.h"
#include "app/base/progress.h"
#include "app/base/wall_clock.h"

namespace assembly {
namespace {

using hydro::RadiationData;
using hydro::RadiationSolution;

/// The last letter is the version of the file's layout.
constexpr std::uint64_t kRadiationMagic = 0x504c494d52414431;  // PLIMRAD1

constexpr const char* kRadiationKind = "radiation";

std::string identity_of(const RadiationProblem& problem) {
  std::string bytes;
  app::append(bytes, kRadiationMagic);
  app::append(bytes, std::int64_t{kRadiationVersion});
  const Eigen::Vector4d orientation = problem.pose.orientation.coeffs();
  app::append(bytes, orientation.data(), 4);
  for (const double number : {problem.pose.height, problem.water.gravity, problem.water.depth})
    app::append(bytes, number);
  app::append(bytes, std::int64_t{problem.options.headings});
  app::append(bytes, std::int64_t{problem.options.patches});
  const std::vector<double>& frequencies = problem.options.frequencies;
  app::append(bytes, static_cast<std::int64_t>(frequencies.size()));
  app::append(bytes, frequencies.data(), frequencies.size());
  append_mesh(bytes, problem.mesh_B);
  return bytes;
}

/// Writes and reads the numbers of a solution in one order.
template <class Numbers>
void visit(Numbers&& numbers, RadiationSolution& solution) {
  RadiationData& data = solution.data;
  numbers(data.volume);
  numbers(solution.mismatch);
  numbers(data.frequencies);
  numbers(data.headings);
  numbers(data.infinite_added_mass);
  for (auto* matrices : {&data.added_mass, &data.damping}) {
    matrices->resize(data.frequencies.size());
    for (hydro::Matrix6d& matrix : *matrices) numbers(matrix);
  }
  for (auto* loads : {&data.froude_krylov, &data.diffraction}) {
    loads->resize(data.frequencies.size());
    for (hydro::Loads6cd& load : *loads) {
      load.resize(6, static_cast<Eigen::Index>(data.headings.size()));
      numbers(load);
    }
  }
}

/// The same for the oscillators, of which there are `count`.
template <class Numbers>
void visit(Numbers&& numbers, double count, hydro::RadiationMemory& memory) {
  numbers(count);
  const auto m = static_cast<Eigen::Index>(count);
  memory.frequencies.resize(m);
  memory.damping.resize(m);
  memory.port.resize(m, 6);
  numbers(memory.frequencies);
  numbers(memory.damping);
  numbers(memory.port);
  numbers(memory.rms_error);
  numbers(memory.largest_error);
}

struct Writer {
  std::string bytes;

  void operator()(double number) { app::append(bytes, number); }
  void operator()(const std::vector<double>& list) {
    app::append(bytes, static_cast<double>(list.size()));
    app::append(bytes, list.data(), list.size());
  }
  template <class Matrix>
  void operator()(const Eigen::PlainObjectBase<Matrix>& matrix) {
    app::append(bytes, matrix.data(), static_cast<std::size_t>(matrix.size()));
  }
};

/// Reads what a Writer has written.
struct Reader {
  const char* at;

  void copy(void* target, std::size_t size) {
    std::memcpy(target, at, size);
    at += size;
  }
  void operator()(double& number) { copy(&number, sizeof(number)); }
  void operator()(std::vector<double>& list) {
    double size = 0;
    (*this)(size);
    list.resize(static_cast<std::size_t>(size));
    copy(list.data(), list.size() * sizeof(double));
  }
  template <class Matrix>
  void operator()(Eigen::PlainObjectBase<Matrix>& matrix) {
    copy(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(typename Matrix::Scalar));
  }
};

std::size_t frequency_count(const RadiationProblem& p) {
  return p.options.frequencies.empty()
             ? hydro::radiation_frequencies(p.mesh_B, p.pose, p.water).size()
             : p.options.frequencies.size();
}

bool has_memory(const RadiationProblem& problem) { return problem.options.frequencies.empty(); }

std::string encode(RadiationSolution& solution, hydro::RadiationMemory* memory, double seconds) {
  Writer writer;
  writer(seconds);
  writer(static_cast<double>(solution.unknowns));
  visit(writer, solution);
  if (memory) visit(writer, static_cast<double>(memory->size()), *memory);
  return std::move(writer.bytes);
}

StoredRadiation decode(const std::string& content, const RadiationProblem& problem) {
  auto solution = std::make_shared<RadiationSolution>();
  solution->data.pose = problem.pose;
  solution->data.water = problem.water;
  Reader reader{content.data()};
  StoredRadiation stored{.from_store = true};
  double unknowns = 0;
  reader(stored.seconds);
  reader(unknowns);
  solution->unknowns = static_cast<int>(unknowns);
  visit(reader, *solution);
  stored.solution = std::move(solution);
  if (!has_memory(problem)) return stored;
  auto memory = std::make_shared<hydro::RadiationMemory>();
  visit(reader, 0, *memory);
  stored.memory = std::move(memory);
  return stored;
}

}  // namespace

RadiationStore::RadiationStore(std::optional<std::filesystem::path> folder)
    : files_(std::move(folder), "the radiation") {}

std::filesystem::path RadiationStore::file_of(const RadiationProblem& problem) const {
  return files_.file_of(identity_of(problem), kRadiationKind);
}

std::optional<StoredRadiation> RadiationStore::find(const RadiationProblem& problem,
                                                    app::Reporter& reporter) {
  const std::string identity = identity_of(problem);
  const auto known = known_.find(identity);
  if (known != known_.end()) return known->second;
  const auto content = files_.read(identity, kRadiationKind, std::nullopt, reporter);
  if (!content) return std::nullopt;
  return known_.emplace(identity, decode(*content, problem)).first->second;
}

StoredRadiation RadiationStore::keep(const RadiationProblem& problem, RadiationSolution solution,
                                     double seconds, app::Reporter& reporter) {
  const std::string identity = identity_of(problem);
  std::shared_ptr<hydro::RadiationMemory> memory;
  if (has_memory(problem))
    memory = std::make_shared<hydro::RadiationMemory>(hydro::fit_memory(solution.data));
  files_.write(identity, kRadiationKind, encode(solution, memory.get(), seconds), reporter);
  const StoredRadiation stored = {std::make_shared<const RadiationSolution>(std::move(solution)),
                                  std::move(memory), seconds, false};
  return known_.insert_or_assign(identity, stored).first->second;
}

hydro::MeanPose rounded(const hydro::MeanPose& pose, double radius, double step) {
  const auto to_step = [&](double number) {
    return std::round(number / step) * step + 0.0;
  };  // −0 is 0
  Eigen::Vector4d q = pose.orientation.coeffs();
  // A rotation has two quaternions; that with a positive largest entry is taken.
  Eigen::Index largest = 0;
  q.cwiseAbs().maxCoeff(&largest);
  if (q[largest] < 0) q = -q;
  q = q.unaryExpr(to_step);
  return {.orientation = Eigen::Quaterniond(q).normalized(),
          .height = to_step(pose.height / radius) * radius};
}

StoredRadiation solved_radiation(const std::string& name, const RadiationProblem& problem,
                                 RadiationStore& store, app::Reporter& reporter) {
  const std::string what = "radiation of " + name;
  return found_or_solved(
      store.file_of(problem), what, reporter, [&] { return store.find(problem, reporter); },
      [&] {
        reporter.working_on(fmt::format(
            "{}: solving for {} frequencies, once for this mesh and mean pose: some {}", what,
            frequency_count(problem),
            app::rough_time(radiation_seconds(static_cast<double>(problem.mesh_B.face_count()),
                                              tbb::this_task_arena::max_concurrency()))));
        const app::WallClock clock;
        RadiationSolution solution =
            hydro::solve_radiation(problem.mesh_B, problem.pose, problem.water, problem.options);
        const double seconds = clock.seconds();
        reporter.done(fmt::format("{}: {} frequencies, {} unknowns, {:.1f} s", what,
                                  solution.data.frequencies.size(), solution.unknowns, seconds));
        return store.keep(problem, std::move(solution), seconds, reporter);
      });
}

}  // namespace assembly
