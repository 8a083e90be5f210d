#include <fmt/format.h>

#include "app/atomic_file.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/report/page_data.h"
#include "app/report/page_file.h"

namespace app {
namespace {

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace

int report(const ReportOptions& options) {
  const RunFolder run = read_run(options.folder, options.scene);
  const std::string page = filled_page(empty_page(kRunPage), page_data(run));
  const std::filesystem::path file = options.folder / kReportFile;
  write_whole(file, page);
  say(fmt::format(
      "{}: {:.1f} MB, {} each of {}", file.string(), static_cast<double>(page.size()) / 1e6,
      counted(run.rows, "row"),
      run.scene.bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", run.scene.bodies.size())));
  return kDone;
}

}  // namespace app
