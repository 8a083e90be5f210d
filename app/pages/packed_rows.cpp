#include "app/pages/packed_rows.h"

#include "app/pages/packing.h"
#include "app/pages/thinning.h"

namespace app {

nlohmann::ordered_json packed_rows(const std::vector<double>& times,
                                   const std::vector<std::vector<double>>& columns,
                                   std::size_t most) {
  if (times.empty()) return nullptr;
  const Thinning thinning(times.size(), most);
  nlohmann::ordered_json packed_columns = nlohmann::ordered_json::array();
  for (const std::vector<double>& column : columns)
    packed_columns.push_back(packed_column(thinning.values(column)));
  return {{"rows", times.size()},
          {"times", packed<double>(thinning.times(times))},
          {"columns", packed_columns}};
}

}  // namespace app
