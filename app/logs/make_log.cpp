#include "app/logs/make_log.h"

#include <optional>

#include "app/logs/force_csv.h"
#include "app/logs/hdf5_log_writer.h"
#include "app/logs/probe_csv.h"
#include "app/logs/run_files.h"
#include "app/logs/trajectory_csv.h"

namespace app {
namespace {

class CsvLog : public Log {
 public:
  CsvLog(const LogSubject& subject, const std::filesystem::path& folder,
         const std::optional<LogPosition>& resumed)
      : rows_(resumed ? resumed->rows : 0),
        states_(folder / kTrajectoryLog, subject.bodies,
                kept(resumed, &LogPosition::trajectory_bytes)) {
    if (subject.forces)
      forces_.emplace(folder / kForceLog, subject.bodies,
                      kept(resumed, &LogPosition::forces_bytes));
    if (!subject.probes.empty())
      probes_.emplace(folder / kProbeLog, subject.probes,
                      kept(resumed, &LogPosition::probes_bytes));
  }

  void add(double time, const std::vector<hydro::BodyState>& states,
           const std::vector<engine::BodyForces>& forces,
           const std::vector<ProbeReading>& probes) override {
    ++rows_;
    states_.add(time, states);
    if (forces_) forces_->add(time, forces);
    if (probes_) probes_->add(time, probes);
  }

  LogPosition save() override {
    return {.rows = rows_,
            .trajectory_bytes = states_.save(),
            .forces_bytes = forces_ ? forces_->save() : 0,
            .probes_bytes = probes_ ? probes_->save() : 0};
  }

  void finish() override {}

 private:
  static std::optional<std::uint64_t> kept(const std::optional<LogPosition>& resumed,
                                           std::uint64_t LogPosition::*bytes) {
    return resumed ? std::optional((*resumed).*bytes) : std::nullopt;
  }

  std::uint64_t rows_;
  TrajectoryWriter states_;
  std::optional<ForceWriter> forces_;
  std::optional<ProbeWriter> probes_;
};

}  // namespace

std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder,
                              const std::optional<LogPosition>& resumed) {
  const bool csv = format == LogFormat::csv;
  if (csv) std::filesystem::remove(folder / kHdf5Log);
  if (!csv) std::filesystem::remove(folder / kTrajectoryLog);
  if (!csv || !subject.forces) std::filesystem::remove(folder / kForceLog);
  if (!csv || subject.probes.empty()) std::filesystem::remove(folder / kProbeLog);
  if (csv) return std::make_unique<CsvLog>(subject, folder, resumed);
  return std::make_unique<Hdf5Log>(
      subject, folder / kHdf5Log,
      resumed ? std::optional<std::size_t>(resumed->rows) : std::nullopt);
}

}  // namespace app
