#include "base/yaml_document.h"

#include <yaml-cpp/yaml.h>

#include <sstream>
#include <unordered_map>

#include <yaml-cpp/eventhandler.h>

#include "base/interruption.h"
#include "base/text.h"

namespace overbend {
namespace {

constexpr std::size_t kNodesBetweenChecks = 4096;

/// Builds the tree from the parser's events, which keep the positions of keys and reveal repeated ones.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  std::optional<YamlNode> take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    reject_anchor(mark, anchor);
    place(node_at(mark, YamlNode::Kind::null));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    complain(mark, "an alias (*)", "the value itself", "aliases are not used in model files");
    place(node_at(mark, YamlNode::Kind::null));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    reject_anchor(mark, anchor);
    reject_tag(mark, tag);
    YamlNode node = node_at(mark, YamlNode::Kind::scalar);
    node.text = value;
    node.quoted = tag == "!";
    if (!node.quoted && (value == "~" || value == "null" || value == "Null" || value == "NULL")) {
      node.kind = YamlNode::Kind::null;
    }
    place(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::list);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::map);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Frame {
    YamlNode node;
    std::optional<YamlEntry> pending;           ///< Key read, value pending.
    std::unordered_map<std::string, int> seen;  ///< Keys of the group and their lines.
  };

  static YamlNode node_at(const YAML::Mark& mark, YamlNode::Kind kind) {
    YamlNode node;
    node.kind = kind;
    node.line = mark.line + 1;
    node.column = mark.column + 1;
    return node;
  }

  void complain(const YAML::Mark& mark, const std::string& found, const std::string& expected,
                const std::string& hint) {
    diagnostics_.add({Severity::error, file_, mark.line + 1, mark.column + 1, path(), found, expected, hint});
  }

  void reject_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor != 0) complain(mark, "an anchor (&)", "the value alone", "anchors are not used in model files");
  }

  void reject_tag(const YAML::Mark& mark, const std::string& tag) {
    if (!tag.empty() && tag != "?" && tag != "!") {
      complain(mark, "the tag '" + for_display(tag) + "'", "the value alone", "tags are not used in model files");
    }
  }

  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, YamlNode::Kind kind) {
    reject_anchor(mark, anchor);
    reject_tag(mark, tag);
    stack_.push_back({node_at(mark, kind), std::nullopt, {}});
  }

  void close() {
    YamlNode node = std::move(stack_.back().node);
    stack_.pop_back();
    place(std::move(node));
  }

  void place(YamlNode node) {
    if (++nodes_ % kNodesBetweenChecks == 0) check_interruption();
    if (stack_.empty()) {
      root_ = std::move(node);
      return;
    }
    Frame& top = stack_.back();
    if (top.node.kind == YamlNode::Kind::list) {
      top.node.items.push_back(std::move(node));
    } else if (!top.pending) {
      begin_entry(top, node);
    } else {
      top.pending->value = std::move(node);
      top.node.entries.push_back(std::move(*top.pending));
      top.pending.reset();
    }
  }

  void begin_entry(Frame& top, const YamlNode& key) {
    const YAML::Mark mark = [&] {
      YAML::Mark m;
      m.line = key.line - 1;
      m.column = key.column - 1;
      return m;
    }();
    if (key.kind != YamlNode::Kind::scalar) {
      complain(mark, "a key that is not plain text", "a key and a colon", "");
    } else if (const auto [first, fresh] = top.seen.try_emplace(key.text, key.line); !fresh) {
      diagnostics_.add({Severity::error, file_, key.line, key.column, joined(key.text), "the key a second time",
                        "it once", "it is already in line " + std::to_string(first->second)});
    }
    top.pending = YamlEntry{key.text, key.line, key.column, {}};
  }

  std::string joined(const std::string& key) const {
    const std::string location = path();
    return location.empty() ? for_display(key) : location + "." + for_display(key);
  }

  /// Path of the parser's current position, "supports.ramp.boxes[2]".
  std::string path() const {
    std::string text;
    for (const Frame& frame : stack_) {
      if (frame.node.kind == YamlNode::Kind::list) {
        text += "[" + std::to_string(frame.node.items.size()) + "]";
      } else if (frame.pending) {
        text += (text.empty() ? "" : ".") + for_display(frame.pending->key);
      }
    }
    return text;
  }

  std::string file_;
  Diagnostics& diagnostics_;
  std::vector<Frame> stack_;
  std::optional<YamlNode> root_;
  std::size_t nodes_ = 0;
};

/// Returns a clearer message for the parser's terse one.
std::string clearer_message(const std::string& message) {
  static const std::vector<std::pair<std::string, std::string>> kMessages = {
      {"bad file", "nested too deeply"},
      {"end of sequence flow not found", "a list opened with '[' is not closed with ']', or a comma is missing"},
      {"end of map flow not found", "a group opened with '{' is not closed with '}', or a comma is missing"},
      {"end of map not found", "a line does not fit its group: check its indentation and write 'key: value'"},
      {"end of sequence not found", "a line does not fit its list: check its indentation and write '- item'"},
      {"illegal map value",
       "a second ':' in a line, wrong indentation, or a tab in place of spaces; put text that contains ': ' in quotes"},
  };
  for (const auto& [theirs, ours] : kMessages) {
    if (message.find(theirs) != std::string::npos) return ours;
  }
  return message;
}

}  // namespace

std::optional<YamlNode> parse_yaml(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  TreeBuilder builder(file, diagnostics);
  try {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    if (!parser.HandleNextDocument(builder)) return std::nullopt;
    std::optional<YamlNode> root = builder.take_root();
    TreeBuilder rest(file, diagnostics);
    if (parser.HandleNextDocument(rest)) {
      const std::optional<YamlNode> second = rest.take_root();
      diagnostics.add({Severity::error, file, second ? second->line : 0, 0, "",
                       "a second document (after '---' or '...')", "one model per file", ""});
    }
    return root;
  } catch (const YAML::Exception& error) {
    diagnostics.add(
        {Severity::error, file, error.mark.line + 1, error.mark.column + 1, "",
         "invalid YAML, column " + std::to_string(error.mark.column + 1) + ": " + clearer_message(error.msg), "", ""});
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    diagnostics.add({Severity::error, file, 0, 0, "", std::string("invalid YAML: ") + error.what(), "", ""});
  }
  return std::nullopt;
}

}  // namespace overbend
