/// Content of a report page as data, drawn by the page's components (web/src/components/Block.tsx).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/json.h"
#include "results/tables/table.h"

namespace overbend {

/// Parts of a page in their order: JSON objects, each with its "kind".
class Blocks {
 public:
  Blocks() = default;
  explicit Blocks(Json block) : list_(Json::array({std::move(block)})) {}
  /// A table; nothing without rows.
  Blocks(const Table& table);

  Blocks& operator+=(const Blocks& more);
  bool empty() const { return list_.empty(); }
  const Json& json() const { return list_; }

 private:
  Json list_ = Json::array();
};

Blocks operator+(Blocks first, const Blocks& second);

/// A key figure in large print with a note below it; `over` marks a value over a limit.
struct Tile {
  std::string name, value, unit, note;
  bool over = false;
};

/// A figure: `id` selects the drawing, `parts` are its panels with a common caption. The page numbers figures in their
/// order. `small`: its panels are small multiples, side by side.
struct Figure {
  std::string id, caption;
  std::vector<std::string> parts;
  bool small = false;
};

namespace block {
/// Returns a section of the page; `id` is its anchor. Nothing if the body is empty.
Blocks section(const std::string& id, const std::string& heading, const Blocks& body);

/// Returns a paragraph of text.
Blocks paragraph(const std::string& text);
/// Returns a paragraph that ends with a link to a section of the page.
Blocks paragraph(const std::string& text, const std::string& link_text, const std::string& section_id);
/// Returns a remark below a table or a figure.
Blocks remark(const std::string& text);
Blocks subheading(const std::string& text);
/// Returns sentences as a list; nothing without any. `numbered` adds numbers.
Blocks list(const std::vector<std::string>& sentences, bool numbered = false);

/// Returns content collapsed under a summary on screen, printed only if `printed` is true. Nothing if the body is
/// empty.
Blocks folded(const std::string& summary, const Blocks& body, bool printed = true);
/// Returns content in columns if the width permits.
Blocks columns(const Blocks& body);
/// Returns content with its own style; `look` is a class of the page's style sheet.
Blocks group(const std::string& look, const Blocks& body);

/// Returns key figures in large print; nothing without any.
Blocks tiles(const std::vector<Tile>& all);

/// Returns names with values in a frame; an empty value can be filled in by hand.
Blocks entry_frame(const std::vector<std::pair<std::string, std::string>>& entries);

/// Returns a text verbatim, for instance a model file.
Blocks verbatim(const std::string& text);

/// Returns a figure, nothing without parts. `data`: its data if they are not in the data of the page.
Blocks figure(const Figure& figure, const Json& data = nullptr);

}  // namespace block
}  // namespace overbend
