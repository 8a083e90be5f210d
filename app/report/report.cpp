#include "app/report/report.h"

#include <fmt/format.h>

#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/logs/run_files.h"
#include "app/pages/page_file.h"
#include "app/report/page_data.h"

namespace app {

int report(const ReportOptions& options) {
  std::string page = empty_page(kRunPage);
  const LoggedRun run = read_run(options.folder, options.scene, options.formats);
  const std::string written =
      write_page(options.folder / kReportFile, std::move(page), page_data(run));
  say(fmt::format("{}, {} each of {}", written, counted(run.rows, "row", "rows"),
                  counted(run.scene.bodies.size(), "body", "bodies")));
  return kDone;
}

}  // namespace app
