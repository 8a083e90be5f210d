#include "app/logs/force_csv.h"
#include "app/logs/interior_csv.h"
#include "app/logs/table_log.h"
#include "app/logs/trajectory_csv.h"
#include "tests/fuzz/fuzz_input.h"

/// @file
/// The logs of a run as CSV. Each input is given to every reader.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::InputFile file("log");
  static const app::TableLayout layout = {
      .file = "lines.csv",
      .kind = "a log of lines",
      .key = "line",
      .series = {{.name = "tension", .units = "N", .columns = {"tension"}},
                 {.name = "force", .units = "N", .columns = {"fx", "fy", "fz"}}}};
  const std::filesystem::path& path = file.holding(fuzz::text_of(data, size));
  const auto expect = [&](const auto& read) {
    fuzz::expect_content_or_faults(path.string(), read);
  };
  expect([&] { app::read_trajectory_csv(path); });
  expect([&] { app::read_force_csv(path); });
  expect([&] { app::read_interior_csv(path); });
  expect([&] { app::read_table_csv(path, layout); });
  return 0;
}
