#include "tests/app/fmu/xml_elements.h"

#include <cctype>
#include <stdexcept>

namespace support {
namespace {

class XmlReader {
 public:
  explicit XmlReader(const std::string& text) : rest_(text) {}

  std::vector<XmlElement> read() {
    expect("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    do {
      skip_spaces();
      expect("<");
      if (take("/"))
        close();
      else
        open();
    } while (!open_.empty());
    skip_spaces();
    if (at_ != rest_.size()) fail("there is more after the root");
    return all_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(what + " at byte " + std::to_string(at_));
  }
  void skip_spaces() {
    while (at_ < rest_.size() && std::isspace(static_cast<unsigned char>(rest_[at_]))) ++at_;
  }
  bool take(const std::string& word) {
    if (rest_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }
  void expect(const std::string& word) {
    if (!take(word)) fail("expected " + word);
  }
  std::string take_name() {
    const std::size_t begin = at_;
    while (at_ < rest_.size() && std::isalnum(static_cast<unsigned char>(rest_[at_]))) ++at_;
    if (at_ == begin) fail("expected a name");
    return rest_.substr(begin, at_ - begin);
  }

  void open() {
    XmlElement element{.name = take_name(), .attributes = {}, .depth = open_.size()};
    for (skip_spaces(); !take(">"); skip_spaces()) {
      if (take("/>")) return all_.push_back(element);
      const std::string key = take_name();
      expect("=\"");
      if (!element.attributes.emplace(key, take_value()).second) fail(key + " is there twice");
    }
    open_.push_back(element.name);
    all_.push_back(element);
  }
  void close() {
    if (open_.empty()) fail("nothing is open");
    expect(open_.back() + ">");
    open_.pop_back();
  }

  std::string take_value() {
    std::string value;
    while (!take("\"")) {
      if (at_ >= rest_.size() || rest_[at_] == '<' || rest_[at_] < ' ') fail("a bad letter");
      if (rest_[at_] != '&')
        value += rest_[at_++];
      else
        value += take_entity();
    }
    return value;
  }
  char take_entity() {
    const std::pair<const char*, char> entities[] = {
        {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}};
    for (const auto& [text, letter] : entities)
      if (take(text)) return letter;
    fail("an unknown entity");
  }

  const std::string& rest_;
  std::size_t at_ = 0;
  std::vector<std::string> open_;
  std::vector<XmlElement> all_;
};

}  // namespace

std::vector<XmlElement> xml_elements(const std::string& text) { return XmlReader(text).read(); }

}  // namespace support
