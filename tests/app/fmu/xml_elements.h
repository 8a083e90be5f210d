#pragma once

#include <map>
#include <string>
#include <vector>

namespace support {

/// An element of an XML file.
struct XmlElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::size_t depth = 0;  ///< Number of elements around it.
};

/// Returns the elements of a text in the order of their heads.
/// @throws std::runtime_error for a text that is not well-formed, or has what modelDescription.xml
///     has no use for: text between elements, entities beyond the five, comments
std::vector<XmlElement> xml_elements(const std::string& text);

}  // namespace support
