#include "app/logs/make_log.h"

#include <optional>

#include "app/logs/force_csv.h"
#include "app/logs/hdf5_log_writer.h"
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
  }

  void add(double time, const std::vector<hydro::BodyState>& states,
           const std::vector<engine::BodyForces>& forces) override {
    ++rows_;
    states_.add(time, states);
    if (forces_) forces_->add(time, forces);
  }

  LogPosition save() override {
    return {.rows = rows_,
            .trajectory_bytes = states_.save(),
            .forces_bytes = forces_ ? forces_->save() : 0};
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
};

}  // namespace

std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder,
                              const std::optional<LogPosition>& resumed) {
  const bool csv = format == LogFormat::csv;
  if (csv) std::filesystem::remove(folder / kHdf5Log);
  if (!csv) std::filesystem::remove(folder / kTrajectoryLog);
  if (!csv || !subject.forces) std::filesystem::remove(folder / kForceLog);
  if (csv) return std::make_unique<CsvLog>(subject, folder, resumed);
  return std::make_unique<Hdf5Log>(
      subject, folder / kHdf5Log,
      resumed ? std::optional<std::size_t>(resumed->rows) : std::nullopt);
}

}  // namespace app
