#include "app/report/report.h"

#include <fmt/format.h>

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/logs/run_files.h"
#include "app/pages/page_file.h"
#include "app/report/page_data.h"
#include "app/report/runs_page.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Page of several runs, in the present folder.
constexpr const char* kRunsFile = "runs.html";

int report_of_one(const ReportOptions& options) {
  std::string page = empty_page(kRunPage);
  const std::filesystem::path& folder = options.runs.front();
  const LoggedRun run = read_run(folder, options.scene, options.formats);
  const std::filesystem::path file = options.out.empty() ? folder / kReportFile : options.out;
  const std::string written = write_page(file, std::move(page), page_data(run));
  say(fmt::format("{}, {} each of {}", written, counted(run.rows, "row", "rows"),
                  counted(run.scene.bodies.size(), "body", "bodies")));
  return kDone;
}

int report_of_several(const ReportOptions& options) {
  if (!options.scene.empty())
    throw scene::InputError("--scene",
                            "is for the report of one run; that of several reads their "
                            "logs alone");
  std::string page = empty_page(kRunsPage);
  std::vector<PageRun> runs;
  std::vector<scene::Fault> faults;
  for (const std::filesystem::path& path : options.runs) try {
      runs.push_back(read_page_run(path));
    } catch (const scene::InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  if (!faults.empty()) throw scene::InputError(faults);
  const nlohmann::ordered_json data = runs_data(runs);
  const std::string written =
      write_page(options.out.empty() ? kRunsFile : options.out, std::move(page), data);
  say(fmt::format("{}, {} of {}", written, counted(runs.size(), "run", "runs"),
                  counted(data["bodies"].size(), "body", "bodies")));
  return kDone;
}

}  // namespace

int report(const ReportOptions& options) {
  return options.runs.size() == 1 ? report_of_one(options) : report_of_several(options);
}

}  // namespace app
