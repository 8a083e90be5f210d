#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "app/atomic_file.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/faults.h"
#include "app/program_files.h"
#include "app/report/page_data.h"

namespace app {
namespace {

/// Stands in the page where the data of a run belong.
constexpr std::string_view kDataMark = "@PLIMSOLL_DATA@";

/// The page without data, as the build has bundled it.
std::string empty_page() {
  const std::filesystem::path file = built_files("report") / "page.html";
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError(
        file,
        "is missing: the program was built without the report's page, for which npm is "
        "needed; run tools/report, or install npm and build the target report_page");
  std::string page(std::istreambuf_iterator<char>(stream), {});
  if (page.find(kDataMark) == std::string::npos)
    throw InputError(file, "has no place for the data; build the target report_page again");
  return page;
}

/// JSON that may stand in a script element: nothing in it ends the element.
std::string script_text(const nlohmann::ordered_json& data) {
  const std::string json =
      data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  }
  return text;
}

std::string counted(std::size_t count, const std::string& one) {
  return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

}  // namespace

int report(const ReportOptions& options) {
  const RunFolder run = read_run(options.folder, options.scene);
  std::string page = empty_page();
  page.replace(page.find(kDataMark), kDataMark.size(), script_text(page_data(run)));
  const std::filesystem::path file = options.folder / kReportFile;
  write_whole(file, page);
  say(fmt::format(
      "{}: {:.1f} MB, {} each of {}", file.string(), static_cast<double>(page.size()) / 1e6,
      counted(run.rows, "row"),
      run.scene.bodies.size() == 1 ? "1 body" : fmt::format("{} bodies", run.scene.bodies.size())));
  return kDone;
}

}  // namespace app
