#include "app/analysis/analyse.h"

#include <fmt/format.h>

#include "app/analysis/analysis_report.h"
#include "app/base/console.h"
#include "app/base/exit_code.h"
#include "app/scene/diagnostics.h"

namespace app {

int analyse(const AnalyseOptions& options) {
  if (options.from && options.to && *options.from >= *options.to)
    throw scene::InputError("--to", fmt::format("found {:g} s, expected more than --from, {:g} s",
                                                *options.to, *options.from));
  const RunAnalysis analysis = analysis_of(read_signals(options), options);
  if (options.json)
    print(fmt::format(
        "{}\n",
        json_of(analysis).dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)));
  else
    print(text_of(analysis));
  return kDone;
}

}  // namespace app
