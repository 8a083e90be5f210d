#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

namespace app {

/// Returns times and columns for a page, thinned to `most` rows: `{rows, times, columns}` with the
/// number of all rows; null without rows.
nlohmann::ordered_json packed_rows(const std::vector<double>& times,
                                   const std::vector<std::vector<double>>& columns,
                                   std::size_t most);

}  // namespace app
