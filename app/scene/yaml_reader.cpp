#include "app/scene/yaml_reader.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "app/base/utf8.h"
#include "app/scene/diagnostics.h"

namespace scene {

namespace {

/// A scene of ten thousand bodies is a few MiB.
constexpr std::uintmax_t kLargestFile = 8u << 20;

/// A scene nests ten levels. The library recurses, so the limit also guards the stack.
constexpr std::size_t kDeepestNesting = 60;

/// Bounds the values that nested aliases can expand to.
constexpr std::size_t kMostNodes = 500'000;

/// No key of a scene is longer than a word [bytes].
constexpr std::size_t kLongestKey = 100;

/// Exception that stops the construction of a tree.
struct Refusal {
  Mark mark;
  std::string message;
};

Mark to_mark(const YAML::Mark& mark) { return {.line = mark.line + 1, .column = mark.column + 1}; }

std::size_t count_nodes(const YamlNode& node) {
  std::size_t count = 1;
  for (const YamlNode& item : node.items) count += count_nodes(item);
  for (const YamlEntry& entry : node.entries) count += count_nodes(entry.value);
  return count;
}

/// Returns the length of all scalars and keys [bytes].
std::size_t text_size(const YamlNode& node) {
  std::size_t size = node.text.size();
  for (const YamlNode& item : node.items) size += text_size(item);
  for (const YamlEntry& entry : node.entries) size += entry.key.size() + text_size(entry.value);
  return size;
}

std::size_t depth_of(const YamlNode& node) {
  std::size_t deepest = 0;
  for (const YamlNode& item : node.items) deepest = std::max(deepest, depth_of(item));
  for (const YamlEntry& entry : node.entries) deepest = std::max(deepest, depth_of(entry.value));
  return deepest + 1;
}

/// Adds the entries of `source` whose keys are not in `keys` yet.
void merge_entries(const YamlNode& source, std::vector<YamlEntry>& entries,
                   std::set<std::string>& keys) {
  if (!source.is(YamlNode::Kind::map))
    throw Refusal{source.mark, "the merge key << needs an alias of a map, or a list of such"};
  for (const YamlEntry& entry : source.entries)
    if (keys.insert(entry.key).second) entries.push_back(entry);
}

/// Replaces merge keys by the entries they insert; a map's own entries have precedence.
void resolve_merge_keys(YamlNode& map) {
  const auto is_merge = [](const YamlEntry& entry) { return entry.key == "<<"; };
  if (std::none_of(map.entries.begin(), map.entries.end(), is_merge)) return;
  std::vector<YamlEntry> entries;
  std::set<std::string> keys;
  std::remove_copy_if(map.entries.begin(), map.entries.end(), std::back_inserter(entries),
                      is_merge);
  for (const YamlEntry& entry : entries) keys.insert(entry.key);
  for (const YamlEntry& entry : map.entries) {
    if (!is_merge(entry)) continue;
    if (entry.value.is(YamlNode::Kind::list))
      for (const YamlNode& item : entry.value.items) merge_entries(item, entries, keys);
    else
      merge_entries(entry.value, entries, keys);
  }
  map.entries = std::move(entries);
}

/// Builds the tree from the library's events. The library's own tree would hide repeated keys.
class TreeBuilder : public YAML::EventHandler {
 public:
  YamlNode take_root() { return std::move(root_); }
  /// Returns the place of the last quoted scalar; line 0 if there is none.
  Mark last_quoted() const { return last_quoted_; }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1)
      throw Refusal{to_mark(mark), "a second document starts here, expected one a file"};
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    finish(make_node(YamlNode::Kind::null, mark), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      throw Refusal{to_mark(mark), "this alias stands inside the block that it repeats"};
    count(count_nodes(found->second), mark);
    repeated_text_ += text_size(found->second);
    if (repeated_text_ > kMostText)
      throw Refusal{to_mark(mark), fmt::format("more than {} MiB of text here", kMostText >> 20)};
    check_depth(open_.size() + depth_of(found->second), mark);
    finish(found->second, 0);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = make_node(YamlNode::Kind::scalar, mark);
    node.text = value;
    node.quoted = is_text(tag, mark);
    if (node.quoted) last_quoted_ = node.mark;
    finish(std::move(node), anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(YamlNode::Kind::list, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(YamlNode::Kind::map, mark, tag, anchor);
  }
  void OnMapEnd() override {
    resolve_merge_keys(open_.back().node);
    close();
  }

 private:
  /// A list or map whose end has not been reached.
  struct Open {
    YamlNode node;
    YAML::anchor_t anchor = 0;
    std::optional<YamlEntry> entry;  ///< Entry of a map whose key is read and whose value is not.
  };

  YamlNode make_node(YamlNode::Kind kind, const YAML::Mark& mark) {
    count(1, mark);
    YamlNode node;
    node.kind = kind;
    node.mark = to_mark(mark);
    return node;
  }

  void count(std::size_t nodes, const YAML::Mark& mark) {
    nodes_ += nodes;
    if (nodes_ > kMostNodes)
      throw Refusal{to_mark(mark), fmt::format("more than {} values here", kMostNodes)};
  }

  static void check_depth(std::size_t depth, const YAML::Mark& mark) {
    if (depth > kDeepestNesting)
      throw Refusal{to_mark(mark), fmt::format("nested deeper than {} levels", kDeepestNesting)};
  }

  /// The library marks a plain scalar by the tag `?` and a quoted one by `!`.
  static bool is_text(const std::string& tag, const YAML::Mark& mark) {
    if (tag == "!" || tag == "tag:yaml.org,2002:str") return true;
    check_tag(tag, mark);
    return false;
  }

  static void check_tag(const std::string& tag, const YAML::Mark& mark) {
    const std::string standard = "tag:yaml.org,2002:";
    if (!tag.empty() && tag != "?" && tag != "!" && tag.compare(0, standard.size(), standard) != 0)
      throw Refusal{to_mark(mark), fmt::format("the tag {} has no meaning in a scene", tag)};
  }

  void open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    check_tag(tag, mark);
    check_depth(open_.size() + 1, mark);
    open_.push_back({make_node(kind, mark), anchor, std::nullopt});
  }

  void close() {
    Open finished = std::move(open_.back());
    open_.pop_back();
    finish(std::move(finished.node), finished.anchor);
  }

  void finish(YamlNode node, YAML::anchor_t anchor) {
    if (anchor != 0) anchors_[anchor] = node;
    if (open_.empty()) {
      root_ = std::move(node);
    } else if (open_.back().node.is(YamlNode::Kind::list)) {
      open_.back().node.items.push_back(std::move(node));
    } else {
      add_to_map(open_.back(), std::move(node));
    }
  }

  static void add_to_map(Open& map, YamlNode node) {
    if (map.entry) {
      // The library gives a missing value the place of whatever follows it.
      if (node.is(YamlNode::Kind::null)) node.mark = map.entry->mark;
      map.entry->value = std::move(node);
      map.node.entries.push_back(std::move(*map.entry));
      map.entry.reset();
      return;
    }
    if (!node.is(YamlNode::Kind::scalar) || node.text.size() > kLongestKey)
      throw Refusal{node.mark, "expected a key, a plain word"};
    map.entry = YamlEntry{std::move(node.text), node.mark, {}};
  }

  YamlNode root_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, YamlNode> anchors_;
  Mark last_quoted_;
  std::size_t nodes_ = 0;
  std::size_t repeated_text_ = 0;  ///< Length of the text that aliases repeat [bytes].
  int documents_ = 0;
};

/// True for a control character that no text has.
bool is_no_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && (byte < '\t' || byte > '\r');
}

/// Returns the place of the first byte that is not UTF-8 text.
std::optional<Mark> first_bad_byte(const std::string& text) {
  Mark mark{.line = 1, .column = 1};
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = app::utf8_length(std::string_view(text).substr(i));
    if (length == 0 || is_no_letter(text[i])) return mark;
    if (text[i] == '\n')
      mark = {.line = mark.line + 1, .column = 1};
    else
      ++mark.column;
    i += length;
  }
  return std::nullopt;
}

/// Returns the text from a mark on; empty if the mark is outside the text.
std::string_view text_from(const std::string& text, Mark mark) {
  std::size_t start = 0;
  for (int line = 1; line < mark.line && start != std::string::npos; ++line) {
    start = text.find('\n', start);
    if (start != std::string::npos) ++start;
  }
  if (start == std::string::npos || mark.line < 1) return {};
  start += static_cast<std::size_t>(mark.column - 1);
  return start < text.size() ? std::string_view(text).substr(start) : std::string_view{};
}

/// True if a quoted scalar at the start of `text` is never closed: the library takes the end of the
/// file as its end.
bool runs_to_the_end(std::string_view text) {
  if (text.empty() || (text[0] != '"' && text[0] != '\'')) return false;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[0] == '"' && text[i] == '\\') {
      ++i;
    } else if (text[i] == text[0]) {
      const bool doubled = text[0] == '\'' && i + 1 < text.size() && text[i + 1] == '\'';
      if (!doubled) return false;
      ++i;
    }
  }
  return true;
}

/// Returns a hint at a tab, for which the library only reports an illegal map value.
std::string tab_hint(const std::string& text, Mark mark) {
  const std::string_view line = text_from(text, {.line = mark.line, .column = 1});
  const std::size_t first = line.find_first_not_of(' ');
  return first != std::string_view::npos && line[first] == '\t' ? " (tabs cannot indent)" : "";
}

/// Returns a hint at a variable in a flow list or map, where its brace opens a map.
std::string variable_hint(const std::string& text, const std::string& message) {
  const bool in_flow = message.find("flow") != std::string::npos;
  return in_flow && text.find("${") != std::string::npos
             ? " (between { } and [ ] a ${…} needs quotes)"
             : "";
}

InputError input_error(const std::filesystem::path& file, Mark mark, const std::string& message) {
  return InputError({Fault{{file, mark.line, mark.column}, "", message}});
}

/// Makes the parser's message the same for all versions: from 0.8 on yaml-cpp appends the name of
/// an undefined anchor, which stands at the place of the fault anyway.
std::string parser_message(const std::string& message) {
  const std::string undefined = "the referenced anchor is not defined";
  return message.starts_with(undefined) ? undefined : message;
}

}  // namespace

const YamlNode* YamlNode::find(const std::string& key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const YamlEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(file, "there is no such file");
  if (std::filesystem::is_directory(status))
    throw InputError(file, "found a folder, expected a file");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(file, "expected an ordinary file");
  if (std::filesystem::file_size(file, error) > kLargestFile)
    throw InputError(file, "larger than 8 MiB, expected a scene in YAML");
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) throw InputError(file, "cannot be read");
  if (const auto mark = first_bad_byte(text))
    throw input_error(file, *mark, "found a byte that is not UTF-8 text, expected YAML");
  return text;
}

YamlNode parse_yaml(const std::string& text, const std::filesystem::path& file) {
  TreeBuilder builder;
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
    if (runs_to_the_end(text_from(text, builder.last_quoted())))
      throw Refusal{builder.last_quoted(), "the quote that opens here is never closed"};
  } catch (const Refusal& refusal) {
    throw input_error(file, refusal.mark, refusal.message);
  } catch (const YAML::Exception& error) {
    const Mark mark = to_mark(error.mark);
    throw input_error(file, mark,
                      "not valid YAML: " + parser_message(error.msg) + tab_hint(text, mark) +
                          variable_hint(text, error.msg));
  }
  return builder.take_root();
}

}  // namespace scene
