#include "app/sweep/ranks.h"

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace app {
namespace {

std::optional<std::size_t> number_in(const char* variable) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return std::nullopt;
  std::size_t number = 0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, number);
  if (error != std::errc() || stop != end) return std::nullopt;
  return number;
}

}  // namespace

std::optional<Rank> launched_rank() {
  constexpr const char* kVariables[][2] = {{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                           {"PMI_RANK", "PMI_SIZE"},
                                           {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}};
  for (const auto& [rank, size] : kVariables) {
    const auto number = number_in(rank);
    const std::size_t count = number_in(size).value_or(1);
    if (count > 1 && number && *number < count) return Rank{*number, count};
  }
  return std::nullopt;
}

}  // namespace app
