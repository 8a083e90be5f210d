#include "app/assembly/mesh_heads.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "app/scene/diagnostics.h"

namespace assembly {
namespace {

/// A kind of element: its count and the least bytes of each.
struct Element {
  std::string name;
  double count = 0;
  double bytes = 0;
};

struct Head {
  bool text = false;
  bool complete = false;  ///< `end_header` was found.
  std::vector<Element> elements;
};

double bytes_of(const std::string& type) {
  for (const char* name : {"char", "uchar", "int8", "uint8"})
    if (type == name) return 1;
  for (const char* name : {"short", "ushort", "int16", "uint16"})
    if (type == name) return 2;
  return type == "double" || type == "float64" ? 8 : 4;
}

/// Returns the least bytes of a property, given the words after `property` in `property TYPE NAME`
/// or `property list COUNT_TYPE ITEM_TYPE NAME`.
double property_bytes(std::istream& words, const Element& element) {
  std::string type, item;
  words >> type;
  if (type != "list") return bytes_of(type);
  words >> type >> item;
  std::string name;
  words >> name;
  const bool corners =
      element.name == "face" && (name == "vertex_indices" || name == "vertex_index");
  return bytes_of(type) + (corners ? 3 * bytes_of(item) : 0);
}

Head read_head(std::istream& in) {
  Head head;
  std::string line, word;
  for (int i = 0; i < 1000 && std::getline(in, line); ++i) {
    std::istringstream words(line);
    word.clear();
    words >> word;
    if (word == "format") head.text = words >> word && word == "ascii";
    if (word == "element") {
      Element element;
      words >> element.name >> element.count;
      head.elements.push_back(element);
    } else if (word == "property" && !head.elements.empty()) {
      head.elements.back().bytes += property_bytes(words, head.elements.back());
    } else if (word == "end_header") {
      head.complete = true;
      break;
    }
  }
  return head;
}

/// Counts the lines from here to the end of the file that are not empty.
double count_lines(std::istream& in) {
  double lines = 0;
  std::string line;
  while (std::getline(in, line))
    if (line.find_first_not_of(" \t\r") != std::string::npos) ++lines;
  return lines;
}

}  // namespace

void require_whole_ply(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const Head head = read_head(in);
  if (!head.complete) throw scene::InputError(file, "the file is cut short: its head has no end");
  double needed = 0;
  for (const Element& element : head.elements)
    needed += element.count * (head.text ? 1 : element.bytes);
  const double body = head.text ? count_lines(in)
                                : static_cast<double>(std::filesystem::file_size(file)) -
                                      static_cast<double>(in.tellg());
  if (body >= needed) return;
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::digits10);
  text << "the file is cut short: its head announces " << needed
       << (head.text ? " lines" : " bytes at least") << " of data, but " << body << " follow";
  throw scene::InputError(file, text.str());
}

void require_whole_off(const std::filesystem::path& file) {
  std::ifstream in(file);
  const double size = static_cast<double>(std::filesystem::file_size(file));
  std::string line, word;
  for (int found = 0; found < 2 && std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    double count = 0;
    while (found < 2 && words >> word)
      if (std::istringstream(word) >> count) {
        ++found;
        if (!(count >= 0 && count <= size))
          throw scene::InputError(file, "the file is cut short: its head announces " + word +
                                            " elements, but it has only " +
                                            std::to_string(std::filesystem::file_size(file)) +
                                            " bytes");
      }
  }
}

}  // namespace assembly
