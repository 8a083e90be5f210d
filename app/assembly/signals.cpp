#include "app/assembly/signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/assembly/column_file.h"
#include "app/base/words.h"
#include "app/scene/diagnostics.h"
#include "app/scene/formula.h"

namespace assembly {
namespace {

const char* const kCommandUsage = "expected the column time [s] and another with the values";

std::string bytes_of(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

class FormulaSignal : public engine::Signal {
 public:
  explicit FormulaSignal(const std::string& text) : text_(text), formula_(text) {}
  double at(double time) const override { return formula_.at(time); }
  bool jumps() const override { return formula_.jumps(); }
  std::string identity() const override { return text_; }

 private:
  std::string text_;
  scene::Formula formula_;
};

class TableSignal : public engine::Signal {
 public:
  TableSignal(std::vector<double> times, std::vector<double> values, bool steps)
      : times_(std::move(times)), values_(std::move(values)), steps_(steps) {}

  double at(double time) const override {
    const auto after = std::upper_bound(times_.begin(), times_.end(), time);
    if (after == times_.begin()) return values_.front();
    const std::size_t i = static_cast<std::size_t>(after - times_.begin()) - 1;
    if (steps_ || after == times_.end()) return values_[i];
    return std::lerp(values_[i], values_[i + 1], (time - times_[i]) / (times_[i + 1] - times_[i]));
  }
  bool jumps() const override { return steps_; }
  std::string identity() const override {
    return (steps_ ? "step" : "linear") + bytes_of(times_) + bytes_of(values_);
  }

 private:
  std::vector<double> times_, values_;
  bool steps_;
};

void check_times(const std::filesystem::path& file, const ColumnFile& table,
                 const std::vector<double>& times) {
  for (std::size_t i = 1; i < times.size(); ++i)
    if (!(times[i] > times[i - 1]))
      table.refuse(file, i,
                   fmt::format("found the time {:g} s after {:g} s, expected rising ones", times[i],
                               times[i - 1]));
}

/// Returns the column of the command.
const std::vector<double>& values_of(const scene::CommandFile& command, const ColumnFile& table) {
  std::vector<std::string> others = table.names;
  std::erase(others, "time");
  if (others.empty()) throw scene::InputError(command.file, kCommandUsage);
  const std::string name = command.column.empty() ? others.front() : command.column;
  if (const std::vector<double>* values = table.find(name)) return *values;
  const std::string hint = app::did_you_mean(name, others);
  throw scene::InputError(
      command.file,
      fmt::format("has no column {}{}", name,
                  hint.empty() ? ", expected " + app::enumerate(others, "or") : hint));
}

}  // namespace

std::shared_ptr<const engine::Signal> formula_signal(const std::string& text) {
  return std::make_shared<FormulaSignal>(text);
}

std::shared_ptr<const engine::Signal> table_signal(std::vector<double> times,
                                                   std::vector<double> values,
                                                   scene::Interpolation interpolation) {
  return std::make_shared<TableSignal>(std::move(times), std::move(values),
                                       interpolation == scene::Interpolation::step);
}

std::shared_ptr<const engine::Signal> read_signal(const scene::CommandFile& command) {
  const ColumnFile table = read_columns(command.file, {}, kCommandUsage);
  const std::vector<double>* times = table.find("time");
  if (times == nullptr) throw scene::InputError(command.file, kCommandUsage);
  const std::vector<double>& values = values_of(command, table);
  if (table.rows() == 0) throw scene::InputError(command.file, "has no row, expected at least one");
  check_times(command.file, table, *times);
  return table_signal(*times, values, command.interpolation);
}

}  // namespace assembly
