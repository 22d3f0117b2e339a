/// Looking into a report: its blocks as text, a line for each row, item, tile or paragraph.
#pragma once

#include <string>
#include <vector>

#include "base/shown_unit.h"
#include "report/page/page.h"

namespace overbend::testing {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t index = text.find(part); index != std::string::npos; index = text.find(part, index + part.size())) {
    ++found;
  }
  return found;
}

inline std::string cell_as_text(const Json& column, const Json& cell) {
  if (cell.is_number()) return fixed(cell.get<double>(), column.value("digits", 3));
  if (cell.is_object()) return cell.value("text", "");
  return cell.is_string() ? cell.get<std::string>() : "";
}

/// Title, groups of columns, heads "top tension [kN]", then a line for every row: "over: S1 | 12.3 | yes", its mark
/// before it.
inline std::string table_as_text(const Json& table) {
  std::string text = table.value("title", "") + "\n";
  for (const Json& group : table.contains("groups") ? table["groups"] : Json::array()) {
    if (group[0] != "") text += group[0].get<std::string>() + "\n";
  }
  const Json& columns = table.at("columns");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string unit = columns[i].value("unit", "");
    text += (i == 0 ? "" : " | ") + columns[i].value("title", "") + (unit.empty() ? "" : " [" + unit + "]");
  }
  text += "\n";
  for (std::size_t k = 0; k < table.at("rows").size(); ++k) {
    const std::string mark = table.contains("marks") ? table["marks"][k].get<std::string>() : "";
    if (!mark.empty()) text += mark + ": ";
    const Json& row = table["rows"][k];
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : " | ") + cell_as_text(columns[i], row[i]);
    text += "\n";
  }
  return text;
}

/// Text of the blocks of a body, including nested ones. Sections and folded parts begin with a line "# heading".
inline std::string shown_text(const Json& body) {
  std::string text;
  for (const Json& block : body) {
    const std::string kind = block.value("kind", "");
    if (kind == "table") text += table_as_text(block);
    for (const char* key : {"heading", "summary"}) {
      if (block.contains(key)) text += "# " + block.value(key, "") + "\n";
    }
    for (const char* key : {"text", "caption"}) {
      if (block.contains(key)) text += block.value(key, "") + "\n";
    }
    if (block.contains("items")) {
      for (const Json& item : block["items"]) text += item.get<std::string>() + "\n";
    }
    if (block.contains("tiles")) {
      for (const Json& tile : block["tiles"]) {
        text += (tile.value("over", false) ? "over: " : "") + tile.value("name", "") + " | " + tile.value("value", "") +
                " | " + tile.value("unit", "") + " | " + tile.value("note", "") + "\n";
      }
    }
    if (block.contains("entries")) {
      for (const Json& entry : block["entries"]) {
        text += entry[0].get<std::string>() + " | " + entry[1].get<std::string>() + "\n";
      }
    }
    for (const Json& line : block.contains("lines") ? block["lines"] : Json::array()) {
      for (const char* key : {"symbol", "meaning", "formula", "numbers", "value", "origin", "confirmed"}) {
        text += line.value(key, "") + " | ";
      }
      text += "\n";
    }
    if (block.contains("body")) text += shown_text(block["body"]);
  }
  return text;
}

inline std::string shown_text(const Blocks& blocks) {
  return shown_text(blocks.json());
}

/// Text of the first page: kind, title, entries, verdict, bars, findings "serious: text (code)".
inline std::string front_text(const Json& front) {
  std::string text = front.value("kind", "") + "\n" + front.value("title", "") + "\n";
  for (const char* key : {"control", "entries"}) {
    for (const Json& entry : front.contains(key) ? front[key] : Json::array()) {
      text += entry[0].get<std::string>() + " | " + entry[1].get<std::string>() + "\n";
    }
  }
  if (front.contains("verdict")) {
    text += front["verdict"].value("words", "") + "\n" + front["verdict"].value("because", "") + "\n";
  }
  if (front.contains("utilisation")) {
    for (const Json& bar : front["utilisation"]["bars"]) {
      text += "bar: " + bar.value("title", "") + " | " + fixed(bar.value("utilisation", 0.0), 3) + " | " +
              bar.value("what", "") + "\n";
    }
    text += front["utilisation"].value("note", "") + "\n";
  }
  for (const Json& finding : front["findings"]) {
    text += finding.value("severity", "") + ": " + finding.value("text", "") + " (" + finding.value("code", "") + ")\n";
  }
  return text;
}

/// First page and sections.
inline std::string shown_text(const Document& document) {
  return front_text(document.front) + shown_text(document.body);
}

/// The rows of the tables of a body, those within other blocks too.
inline std::size_t row_count(const Json& body) {
  std::size_t rows = 0;
  for (const Json& block : body) {
    if (block.contains("rows")) rows += block["rows"].size();
    if (block.contains("body")) rows += row_count(block["body"]);
  }
  return rows;
}

inline Json section_body(const Document& document, const std::string& id) {
  for (const Json& section : document.body.json()) {
    if (section.value("id", "") == id) return section["body"];
  }
  return Json::array();
}

/// Text of a section by its id; empty where there is none.
inline std::string section_text(const Document& document, const std::string& id) {
  return shown_text(section_body(document, id));
}

/// Text of all sections, in their order.
inline std::vector<std::string> section_ids(const Document& document) {
  std::vector<std::string> ids;
  for (const Json& section : document.body.json()) ids.push_back(section.value("id", ""));
  return ids;
}

/// The document that the text of a report holds.
inline Json document_in(const std::string& page) {
  const std::string slot = "<script type=\"application/json\" id=\"document\">";
  const std::size_t from = page.find(slot) + slot.size();
  return read_json(page.substr(from, page.find("</script>", from) - from));
}

/// "configuration/whole" for every panel of the figures of a body, those within others too.
inline std::vector<std::string> panels(const Json& body) {
  std::vector<std::string> all;
  for (const Json& block : body) {
    if (block.value("kind", "") == "figure") {
      for (const Json& part : block["parts"]) all.push_back(block.value("id", "") + "/" + part.get<std::string>());
    }
    if (block.contains("body")) {
      for (std::string& panel : panels(block["body"])) all.push_back(std::move(panel));
    }
  }
  return all;
}

}  // namespace overbend::testing
