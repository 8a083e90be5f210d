#include "app/assembly/ply_head.h"

#include <fmt/format.h>

#include <utility>

namespace assembly {
namespace {

constexpr std::pair<std::string_view, PlyNumber> kNumbers[] = {
    {"char", PlyNumber::int8},      {"int8", PlyNumber::int8},       {"uchar", PlyNumber::uint8},
    {"uint8", PlyNumber::uint8},    {"short", PlyNumber::int16},     {"int16", PlyNumber::int16},
    {"ushort", PlyNumber::uint16},  {"uint16", PlyNumber::uint16},   {"int", PlyNumber::int32},
    {"int32", PlyNumber::int32},    {"uint", PlyNumber::uint32},     {"uint32", PlyNumber::uint32},
    {"float", PlyNumber::float32},  {"float32", PlyNumber::float32}, {"double", PlyNumber::float64},
    {"float64", PlyNumber::float64}};

constexpr std::pair<std::string_view, PlyEncoding> kEncodings[] = {
    {"ascii", PlyEncoding::ascii},
    {"binary_little_endian", PlyEncoding::binary_little_endian},
    {"binary_big_endian", PlyEncoding::binary_big_endian}};

/// Takes the next word and returns what it stands for.
template <class T, std::size_t kSize>
T choice(MeshText& text, const std::pair<std::string_view, T> (&known)[kSize],
         const char* expected) {
  const std::string_view word = text.word();
  for (const auto& [name, value] : known)
    if (name == word) return value;
  text.fault(fmt::format("found {}, expected {}", in_quotes(word), expected));
}

std::string name_in(MeshText& text) {
  const std::string_view name = text.word();
  if (name.empty()) text.fault("the line ends where a name is expected");
  return std::string(name);
}

PlyElement element_in(MeshText& text) {
  PlyElement element{.name = name_in(text), .count = text.integer(), .properties = {}};
  if (element.count < 0)
    text.fault(fmt::format("the head announces {} elements, expected 0 or more", element.count));
  return element;
}

/// Takes `TYPE NAME` or `list COUNT_TYPE TYPE NAME`.
PlyProperty property_in(MeshText& text) {
  constexpr const char* kExpected = "a type of numbers, such as float, double, int or uchar";
  PlyProperty property;
  MeshText ahead = text;
  if (ahead.word() == "list") {
    text.word();
    property.count = choice(text, kNumbers, kExpected);
    if (*property.count == PlyNumber::float32 || *property.count == PlyNumber::float64)
      text.fault("the count of a list is a float, expected a type of whole numbers");
  }
  property.type = choice(text, kNumbers, kExpected);
  property.name = name_in(text);
  return property;
}

}  // namespace

int size_of(PlyNumber type) {
  switch (type) {
    case PlyNumber::int8:
    case PlyNumber::uint8:
      return 1;
    case PlyNumber::int16:
    case PlyNumber::uint16:
      return 2;
    case PlyNumber::float64:
      return 8;
    default:
      return 4;
  }
}

PlyHead read_ply_head(MeshText& text) {
  PlyHead head;
  bool has_format = false;
  if (!text.next_line() || text.word() != "ply")
    text.fault("the file does not begin with a line 'ply'");
  while (text.next_line()) {
    const std::string_view word = text.word();
    if (word == "format") {
      head.encoding = choice(text, kEncodings, "ascii, binary_little_endian or binary_big_endian");
      has_format = true;
    } else if (word == "element") {
      head.elements.push_back(element_in(text));
    } else if (word == "property") {
      if (head.elements.empty()) text.fault("a property comes before the first element");
      head.elements.back().properties.push_back(property_in(text));
    } else if (word == "end_header") {
      if (!has_format) text.fault("the head has no line 'format'");
      return head;
    } else if (word != "comment" && word != "obj_info") {
      text.fault(fmt::format("found {}, expected element, property, comment or end_header",
                             in_quotes(word)));
    }
  }
  text.fault("the file is cut short: its head has no end");
}

}  // namespace assembly
