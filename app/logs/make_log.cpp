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
  CsvLog(const LogSubject& subject, const std::filesystem::path& folder)
      : states_(folder / kTrajectoryLog, subject.bodies) {
    if (subject.forces) forces_.emplace(folder / kForceLog, subject.bodies);
  }

  void add(double time, const std::vector<hydro::BodyState>& states,
           const std::vector<engine::BodyForces>& forces) override {
    states_.add(time, states);
    if (forces_) forces_->add(time, forces);
  }

  void finish() override {}

 private:
  TrajectoryWriter states_;
  std::optional<ForceWriter> forces_;
};

}  // namespace

std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder) {
  const bool csv = format == LogFormat::csv;
  if (csv) std::filesystem::remove(folder / kHdf5Log);
  if (!csv) std::filesystem::remove(folder / kTrajectoryLog);
  if (!csv || !subject.forces) std::filesystem::remove(folder / kForceLog);
  if (csv) return std::make_unique<CsvLog>(subject, folder);
  return std::make_unique<Hdf5Log>(subject, folder / kHdf5Log);
}

}  // namespace app
