#include "app/databases/netcdf_classic.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

namespace databases {
namespace {

// Tags and types of the format.
constexpr std::uint32_t kDimensions = 10, kVariables = 11, kAttributes = 12;
enum Type : std::uint32_t { kByte = 1, kChar, kShort, kInt, kFloat, kDouble };

std::size_t size_of(std::uint32_t type) {
  constexpr std::size_t kSizes[] = {0, 1, 1, 2, 4, 4, 8};
  return type >= kByte && type <= kDouble ? kSizes[type] : 0;
}

std::size_t padded(std::size_t bytes) { return (bytes + 3) / 4 * 4; }

/// Reads big-endian words from bytes, in which it may not run over the end.
class Bytes {
 public:
  Bytes(const std::string& bytes, const ArrayFile& file) : bytes_(bytes), file_(file) {}

  std::uint64_t word(std::size_t size) {
    need(size);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8 | static_cast<unsigned char>(bytes_[at_ + i]);
    at_ += size;
    return value;
  }
  std::uint32_t four() { return static_cast<std::uint32_t>(word(4)); }
  std::string text() {
    const std::size_t length = four();
    need(length);
    std::string text = bytes_.substr(at_, length);
    skip(padded(length));
    return text;
  }
  void skip(std::size_t size) {
    need(size);
    at_ += size;
  }
  void go_to(std::uint64_t at) {
    if (at > bytes_.size()) fail();
    at_ = static_cast<std::size_t>(at);
  }
  double number(std::uint32_t type) {
    switch (type) {
      case kDouble:
        return std::bit_cast<double>(word(8));
      case kFloat:
        return std::bit_cast<float>(four());
      case kInt:
        return static_cast<std::int32_t>(four());
      case kShort:
        return static_cast<std::int16_t>(word(2));
      default:
        return static_cast<std::int8_t>(word(1));
    }
  }
  /// Returns the number of entries of a list, which may be absent.
  std::size_t list(std::uint32_t tag) {
    const std::uint32_t found = four();
    const std::size_t count = four();
    if ((found != tag && !(found == 0 && count == 0)) || count > bytes_.size()) fail();
    return count;
  }
  void skip_attributes() {
    for (std::size_t n = list(kAttributes); n > 0; --n) {
      text();
      const std::uint32_t type = four();
      const std::size_t count = four();
      if (size_of(type) == 0) fail();
      skip(padded(count * size_of(type)));
    }
  }
  [[noreturn]] void fail() const {
    file_.refuse("cannot be read: its NetCDF structure is damaged");
  }

 private:
  void need(std::size_t size) const {
    if (size > bytes_.size() - at_) fail();
  }

  const std::string& bytes_;
  const ArrayFile& file_;
  std::size_t at_ = 0;
};

class ClassicFile final : public ArrayFile {
 public:
  explicit ClassicFile(const std::filesystem::path& file) : ArrayFile(file) {
    std::ifstream in(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(in), {});
    read_head();
  }

  std::optional<Array> find(const std::string& name) const override {
    const auto found = variables_.find(name);
    if (found == variables_.end()) return std::nullopt;
    const Variable& variable = found->second;
    Array array;
    std::size_t count = 1;
    for (const std::size_t id : variable.dimensions) {
      const auto& [dimension, length] = dimensions_[id];
      if (length == 0) refuse(fmt::format("{}: its dimension {} has no entries", name, dimension));
      count *= length;
      array.dimensions.push_back(dimension);
      array.shape.push_back(length);
    }
    Bytes bytes(bytes_, *this);
    bytes.go_to(variable.begin);
    if (variable.type == kChar) {
      read_texts(bytes, count, array);
    } else {
      array.numbers.reserve(count);
      for (std::size_t i = 0; i < count; ++i) array.numbers.push_back(bytes.number(variable.type));
    }
    return array;
  }

 private:
  struct Variable {
    std::vector<std::size_t> dimensions;
    std::uint32_t type = 0;
    std::uint64_t begin = 0;
  };

  void read_head() {
    Bytes bytes(bytes_, *this);
    const std::uint32_t version = bytes.four() & 0xff;
    if (version != 1 && version != 2)
      refuse(fmt::format("is NetCDF of the format CDF-{}, expected CDF-1, CDF-2 or NetCDF-4",
                         version));
    bytes.four();  // Number of records.
    for (std::size_t n = bytes.list(kDimensions); n > 0; --n) {
      std::string name = bytes.text();
      dimensions_.emplace_back(std::move(name), bytes.four());
    }
    bytes.skip_attributes();
    for (std::size_t n = bytes.list(kVariables); n > 0; --n) {
      const std::string name = bytes.text();
      Variable variable;
      for (std::size_t rank = bytes.four(); rank > 0; --rank) {
        variable.dimensions.push_back(bytes.four());
        if (variable.dimensions.back() >= dimensions_.size()) bytes.fail();
      }
      bytes.skip_attributes();
      variable.type = bytes.four();
      if (size_of(variable.type) == 0) bytes.fail();
      bytes.four();  // Size, which follows from the dimensions.
      variable.begin = bytes.word(version == 1 ? 4 : 8);
      std::size_t size = size_of(variable.type);
      for (const std::size_t id : variable.dimensions) {
        size *= dimensions_[id].second;  // 0 along the unlimited dimension.
        if (size > bytes_.size()) bytes.fail();
      }
      if (variable.begin > bytes_.size() - size) bytes.fail();
      variables_.emplace(name, std::move(variable));
    }
  }

  /// Letters run along the last dimension.
  static void read_texts(Bytes& bytes, std::size_t count, Array& array) {
    const std::size_t length = array.shape.empty() ? 1 : array.shape.back();
    if (!array.shape.empty()) {
      array.shape.pop_back();
      array.dimensions.pop_back();
    }
    for (std::size_t i = 0; i < count / length; ++i) {
      std::string text;
      for (std::size_t j = 0; j < length; ++j) text += static_cast<char>(bytes.word(1));
      text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
      array.texts.push_back(text.substr(0, text.find_last_not_of(' ') + 1));
    }
  }

  std::string bytes_;
  std::vector<std::pair<std::string, std::size_t>> dimensions_;
  std::map<std::string, Variable> variables_;
};

/// Appends big-endian words.
class Writer {
 public:
  void word(std::uint64_t value, std::size_t size) {
    while (size-- > 0) bytes_ += static_cast<char>(value >> 8 * size & 0xff);
  }
  void four(std::size_t value) { word(value, 4); }
  void text(const std::string& text) {
    four(text.size());
    bytes_ += text;
    pad();
  }
  void pad() { bytes_.resize(padded(bytes_.size()), '\0'); }
  void attributes(const std::vector<std::pair<std::string, std::string>>& attributes) {
    four(attributes.empty() ? 0 : kAttributes);
    four(attributes.size());
    for (const auto& [name, value] : attributes) {
      text(name);
      four(kChar);
      text(value);
    }
  }
  std::string& bytes() { return bytes_; }

 private:
  std::string bytes_;
};

/// An array of letters for texts.
Array letters_of(const Array& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts.texts) longest = std::max(longest, text.size());
  Array letters{.shape = texts.shape, .dimensions = texts.dimensions, .numbers = {}, .texts = {}};
  letters.shape.push_back(longest);
  letters.dimensions.push_back(fmt::format("string{}", longest));
  for (std::string text : texts.texts) {
    text.resize(longest, '\0');
    letters.texts.push_back(std::move(text));
  }
  return letters;
}

}  // namespace

std::unique_ptr<ArrayFile> open_netcdf_classic(const std::filesystem::path& file) {
  return std::make_unique<ClassicFile>(file);
}

std::string netcdf_bytes(const std::vector<std::pair<std::string, std::string>>& attributes,
                         const std::vector<NamedArray>& arrays) {
  std::vector<Array> stored;
  std::vector<std::pair<std::string, std::size_t>> dimensions;
  const auto id_of = [&](const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(dimensions.begin(), dimensions.end(),
                     [&](const auto& known) { return known.first == name; }) -
        dimensions.begin());
  };
  for (const NamedArray& each : arrays) {
    stored.push_back(each.array.texts.empty() ? each.array : letters_of(each.array));
    for (std::size_t i = 0; i < stored.back().shape.size(); ++i)
      if (id_of(stored.back().dimensions[i]) == dimensions.size())
        dimensions.emplace_back(stored.back().dimensions[i], stored.back().shape[i]);
  }
  Writer data;
  std::vector<std::size_t> begins;
  for (const Array& array : stored) {
    begins.push_back(data.bytes().size());
    for (const double number : array.numbers) data.word(std::bit_cast<std::uint64_t>(number), 8);
    for (const std::string& text : array.texts) data.bytes() += text;
    data.pad();
  }
  begins.push_back(data.bytes().size());
  const auto head_of = [&](std::size_t offset) {
    Writer head;
    head.bytes() = std::string("CDF\x02\0\0\0\0", 8);
    head.four(dimensions.empty() ? 0 : kDimensions);
    head.four(dimensions.size());
    for (const auto& [name, length] : dimensions) {
      head.text(name);
      head.four(length);
    }
    head.attributes(attributes);
    head.four(arrays.empty() ? 0 : kVariables);
    head.four(arrays.size());
    for (std::size_t i = 0; i < arrays.size(); ++i) {
      head.text(arrays[i].name);
      head.four(stored[i].dimensions.size());
      for (const std::string& name : stored[i].dimensions) head.four(id_of(name));
      head.attributes(arrays[i].attributes);
      head.four(stored[i].texts.empty() ? kDouble : kChar);
      head.four(begins[i + 1] - begins[i]);
      head.word(offset + begins[i], 8);
    }
    return std::move(head.bytes());
  };
  const std::size_t offset = head_of(0).size();
  return head_of(offset) + data.bytes();
}

}  // namespace databases
