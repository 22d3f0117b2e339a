/// What stands on a page of a report, as data: the page's components draw it (web/src/components/Block.tsx).
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

/// A key figure in large print with a note below it; `over` marks what is beyond a limit.
struct Tile {
  std::string name, value, unit, note;
  bool over = false;
};

/// A figure: `id` chooses what is drawn, `parts` are its panels below one caption. The page numbers figures in their
/// order. `small`: its panels are small multiples, side by side.
struct Figure {
  std::string id, caption;
  std::vector<std::string> parts;
  bool small = false;
};

namespace block {
/// A section of the page; `id` is its anchor. Nothing where the body is empty.
Blocks section(const std::string& id, const std::string& heading, const Blocks& body);

Blocks paragraph(const std::string& text);
/// A paragraph that ends with a link to a section of the page.
Blocks paragraph(const std::string& text, const std::string& link_text, const std::string& section_id);
/// A remark below a table or a figure.
Blocks remark(const std::string& text);
Blocks subheading(const std::string& text);
/// Sentences as a list; nothing without any. `numbered` counts them.
Blocks list(const std::vector<std::string>& sentences, bool numbered = false);

/// Content folded behind a summary on screen, printed only where `printed` is true. Nothing where the body is empty.
Blocks folded(const std::string& summary, const Blocks& body, bool printed = true);
/// Content side by side where there is room.
Blocks columns(const Blocks& body);
/// Content that is set in a way of its own; `look` is a class of the page's style.
Blocks group(const std::string& look, const Blocks& body);

/// Key figures in large print; nothing without any.
Blocks tiles(const std::vector<Tile>& all);

/// Names with values in a frame; a value that is empty can be written in by hand.
Blocks entry_frame(const std::vector<std::pair<std::string, std::string>>& entries);

/// A text as it was written: of a model file.
Blocks verbatim(const std::string& text);

/// A figure, nothing without parts. `data`: what it draws, where that does not stand in the data of the page.
Blocks figure(const Figure& figure, const Json& data = nullptr);

}  // namespace block
}  // namespace overbend
