#include "app/pages/packing.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace app {

static_assert(std::endian::native == std::endian::little);

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k)
      word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text.push_back(k <= count ? kDigits[word >> (18 - 6 * k) & 63U] : '=');
  }
  return text;
}

nlohmann::ordered_json packed_column(const std::vector<double>& values) {
  const double base = values.front();
  if (std::all_of(values.begin(), values.end(), [&](double v) { return v == base; })) return base;
  std::vector<float> differences;
  differences.reserve(values.size());
  for (const double v : values) differences.push_back(static_cast<float>(v - base));
  return {{"base", base}, {"data", packed<float>(differences)}};
}

}  // namespace app
