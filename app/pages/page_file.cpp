#include "app/pages/page_file.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "app/base/atomic_file.h"
#include "app/base/program_files.h"
#include "app/scene/diagnostics.h"

namespace app {
namespace {

/// Placeholder for the data in a page.
constexpr std::string_view kDataMark = "@PLIMSOLL_DATA@";

/// Returns JSON that is safe in a script element: nothing in it ends the element.
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

}  // namespace

std::string empty_page(const std::string& name) {
  const std::filesystem::path file = built_files("report") / name;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw scene::InputError(
        file,
        "is missing: the program was built without the report's page, for which npm is "
        "needed; run tools/report, or install npm and build the target report_page");
  std::string page(std::istreambuf_iterator<char>(stream), {});
  if (page.find(kDataMark) == std::string::npos)
    throw scene::InputError(file, "has no place for the data; build the target report_page again");
  return page;
}

std::string write_page(const std::filesystem::path& file, std::string page,
                       const nlohmann::ordered_json& data) {
  page.replace(page.find(kDataMark), kDataMark.size(), script_text(data));
  write_whole(file, page);
  return fmt::format("{}: {:.1f} MB", file.string(), static_cast<double>(page.size()) / 1e6);
}

}  // namespace app
