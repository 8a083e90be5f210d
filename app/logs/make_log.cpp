#include "app/logs/make_log.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "app/logs/force_csv.h"
#include "app/logs/hdf5_log_writer.h"
#include "app/logs/interior_csv.h"
#include "app/logs/rig_log.h"
#include "app/logs/run_files.h"
#include "app/logs/table_log.h"
#include "app/logs/trajectory_csv.h"

namespace app {
namespace {

class CsvLog : public Log {
 public:
  CsvLog(const LogSubject& subject, const std::filesystem::path& folder,
         const std::optional<LogPosition>& resumed)
      : rows_(resumed ? resumed->rows : 0),
        states_(folder / kTrajectoryLog, subject.bodies, kept(resumed, &LogPosition::trajectory)) {
    if (subject.forces)
      forces_.emplace(folder / kForceLog, subject.bodies, kept(resumed, &LogPosition::forces));
    for (std::size_t i = 0; i < subject.tables.size(); ++i)
      tables_.emplace_back(folder, subject.tables[i],
                           resumed ? std::optional(resumed->tables.at(i)) : std::nullopt);
  }

  void add(const LogEntry& entry) override {
    ++rows_;
    states_.add(entry.time, entry.states);
    if (forces_) forces_->add(entry.time, entry.forces);
    for (std::size_t i = 0; i < tables_.size(); ++i) tables_[i].add(entry.time, entry.tables[i]);
  }

  LogPosition save() override {
    LogPosition position{.rows = rows_,
                         .trajectory = states_.save(),
                         .forces = forces_ ? forces_->save() : FilePosition()};
    for (TableWriter& table : tables_) position.tables.push_back(table.save());
    return position;
  }

  void finish() override {
    states_.check_place();
    if (forces_) forces_->check_place();
    for (const TableWriter& table : tables_) table.check_place();
  }

 private:
  static std::optional<FilePosition> kept(const std::optional<LogPosition>& resumed,
                                          FilePosition LogPosition::*position) {
    return resumed ? std::optional((*resumed).*position) : std::nullopt;
  }

  std::uint64_t rows_;
  TrajectoryWriter states_;
  std::optional<ForceWriter> forces_;
  std::vector<TableWriter> tables_;
};

/// A log with the water in pockets, which is CSV beside a log of either format.
class LogWithInteriors : public Log {
 public:
  LogWithInteriors(std::unique_ptr<Log> rest, const LogSubject& subject,
                   const std::filesystem::path& folder, const std::optional<LogPosition>& resumed)
      : rest_(std::move(rest)),
        interiors_(folder / kInteriorLog, subject.bodies,
                   resumed ? std::optional(resumed->interior) : std::nullopt) {}

  void add(const LogEntry& entry) override {
    rest_->add(entry);
    interiors_.add(entry.time, entry.interiors);
  }

  LogPosition save() override {
    LogPosition position = rest_->save();
    position.interior = interiors_.save();
    return position;
  }

  void finish() override {
    rest_->finish();
    interiors_.check_place();
  }

 private:
  std::unique_ptr<Log> rest_;
  InteriorWriter interiors_;
};

bool has_table(const LogSubject& subject, const std::string& file) {
  return std::ranges::any_of(subject.tables,
                             [&](const LogTable& table) { return table.layout.file == file; });
}

std::unique_ptr<Log> log_of_motion(LogFormat format, const LogSubject& subject,
                                   const std::filesystem::path& folder,
                                   const std::optional<LogPosition>& resumed) {
  if (format == LogFormat::csv) return std::make_unique<CsvLog>(subject, folder, resumed);
  return std::make_unique<Hdf5Log>(subject, folder / kHdf5Log, resumed);
}

}  // namespace

std::unique_ptr<Log> make_log(LogFormat format, const LogSubject& subject,
                              const std::filesystem::path& folder,
                              const std::optional<LogPosition>& resumed) {
  const bool csv = format == LogFormat::csv;
  if (csv) std::filesystem::remove(folder / kHdf5Log);
  if (!csv) std::filesystem::remove(folder / kTrajectoryLog);
  if (!csv || !subject.forces) std::filesystem::remove(folder / kForceLog);
  for (const TableLayout& table : all_table_layouts())
    if (!csv || !has_table(subject, table.file)) std::filesystem::remove(folder / table.file);
  if (!subject.interiors) std::filesystem::remove(folder / kInteriorLog);
  std::unique_ptr<Log> log = log_of_motion(format, subject, folder, resumed);
  if (!subject.interiors) return log;
  return std::make_unique<LogWithInteriors>(std::move(log), subject, folder, resumed);
}

}  // namespace app
