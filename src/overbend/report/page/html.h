/// Small helpers that turn values into HTML text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace overbend::html {

/// Text made harmless in element content and in quoted attributes.
std::string escape(std::string_view text);

/// JSON made harmless inside a script element: no "<" is left, so no "</script>" either.
std::string escape_json(std::string_view json);

/// A number with `digits` decimals, never "-0.00"; "-" for what is not finite.
std::string fixed(double value, int digits);

/// A section of the page with a heading; `id` is its anchor. `body` is HTML.
std::string section(const std::string& id, const std::string& heading, const std::string& body);

/// A list of sentences, escaped.
std::string list(const std::vector<std::string>& items);

/// A key figure in large print with a note below it; `over` marks what is beyond a limit. All plain text.
std::string tile(const std::string& name, const std::string& value, const std::string& unit, const std::string& note,
                 bool over = false);

/// Names with values, as the page's head shows them. Plain text.
std::string entries(const std::vector<std::pair<std::string, std::string>>& all);

/// Content folded behind a summary line (plain text) on screen. Printed only where `printed` is true. `body` is
/// HTML.
std::string folded(const std::string& summary, const std::string& body, bool printed = true);

struct Head {
  std::string name;   ///< Plain text.
  std::string unit;   ///< Plain text; empty: none. Shown below the name.
  bool text = false;  ///< A column of words: set flush left.
};

/// A table with a caption, units in the head, numbers flush right.
class Table {
 public:
  Table(std::string caption, std::vector<Head> head, std::string css_class = "");
  /// A further head line on top: pairs of title and number of columns it spans.
  Table& groups(std::vector<std::pair<std::string, int>> groups);
  /// Cells are plain text, escaped here; `css_class` marks the row.
  Table& row(const std::vector<std::string>& cells, const std::string& css_class = "");
  std::string str() const;

 private:
  std::string caption_, css_class_;
  std::vector<Head> head_;
  std::vector<std::pair<std::string, int>> groups_;
  std::string body_;
};

}  // namespace overbend::html
