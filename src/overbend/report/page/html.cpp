#include "report/page/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/ranges.h"
#include "base/shown_unit.h"

namespace overbend::html {
namespace {

std::string element(const char* name, const std::string& content) {
  return fmt::format("<{0}>{1}</{0}>\n", name, content);
}

std::string escaped(const Json& block, const char* key) {
  return escape(block.value(key, std::string()));
}

std::string cell(const Json& column, const Json& value) {
  if (value.is_number()) return fixed(value.get<double>(), column.value("digits", 3));
  if (value.is_object()) return escaped(value, "text");
  return value.is_string() ? escape(value.get<std::string>()) : "";
}

std::string head_row(const Json& columns) {
  std::string cells;
  for (const Json& column : columns) {
    const std::string unit = column.contains("unit") ? " [" + escaped(column, "unit") + "]" : "";
    cells += "<th>" + escaped(column, "title") + unit + "</th>";
  }
  return element("tr", cells);
}

std::string table(const Json& block) {
  const Json& columns = block.at("columns");
  std::string rows = head_row(columns);
  for (const Json& row : block.at("rows")) {
    std::string cells;
    for (std::size_t i = 0; i < row.size(); ++i) cells += "<td>" + cell(columns[i], row[i]) + "</td>";
    rows += element("tr", cells);
  }
  return fmt::format("<table border=\"1\"><caption>{}</caption>\n{}</table>\n", escaped(block, "title"), rows);
}

std::string pairs(const Json& entries) {
  std::string items;
  for (const Json& entry : entries) {
    items += element("li", escape(entry[0].get<std::string>()) + ": " + escape(entry[1].get<std::string>()));
  }
  return element("ul", items);
}

std::string tile_list(const Json& tiles) {
  std::string items;
  for (const Json& tile : tiles) {
    items += element("li", fmt::format("{}: {} {} ({})", escaped(tile, "name"), escaped(tile, "value"),
                                       escaped(tile, "unit"), escaped(tile, "note")));
  }
  return element("ul", items);
}

std::string blocks(const Json& body);

std::string one_block(const Json& block) {
  const std::string kind = block.value("kind", "");
  if (kind == "table") return table(block);
  if (kind == "tiles") return tile_list(block.at("tiles"));
  if (kind == "entries") return pairs(block.at("entries"));
  if (kind == "paragraph" || kind == "remark") return element("p", escaped(block, "text"));
  if (kind == "subheading") return element("h3", escaped(block, "text"));
  if (kind == "group") return blocks(block.at("body"));
  if (kind != "list") return "";
  std::string items;
  for (const Json& item : block.at("items")) items += element("li", escape(item.get<std::string>()));
  return element("ul", items);
}

std::string blocks(const Json& body) {
  std::string text;
  for (const Json& block : body) text += one_block(block);
  return text;
}

std::string findings(const Json& all) {
  std::string items;
  for (const Json& finding : all) {
    items += element("li", fmt::format("{}: {} ({})", escaped(finding, "severity"), escaped(finding, "text"),
                                       escaped(finding, "code")));
  }
  return items.empty() ? "" : element("h2", "Findings") + element("ul", items);
}

std::string front(const Json& page) {
  std::string text = element("p", escaped(page, "kind")) + element("h1", escaped(page, "title"));
  if (page.contains("control")) text += pairs(page.at("control"));
  text += pairs(page.at("entries"));
  if (page.contains("verdict")) {
    const Json& verdict = page.at("verdict");
    text += element("h2", escaped(verdict, "words")) + element("p", escaped(verdict, "because"));
  }
  return text + findings(page.at("findings"));
}

/// Sections included for readers without scripts.
bool is_key_section(const Json& section) {
  constexpr std::array kKey = {"results", "checks", "stages",     "procedure", "stage-checks", "seek",
                               "summary", "rows",   "quantities", "folders",   "operability",  "cases"};
  return ranges::find(kKey, section.value("id", "")) != kKey.end();
}

}  // namespace

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string escape_json(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      out += "\\u003c";
    } else {
      out += c;
    }
  }
  return out;
}

std::string plain(const Document& document) {
  std::string text = element("p", "Figures and the other sections of this report need scripts, which are disabled.") +
                     front(document.front);
  for (const Json& section : document.body.json()) {
    if (is_key_section(section)) text += element("h2", escaped(section, "heading")) + blocks(section.at("body"));
  }
  return text;
}

}  // namespace overbend::html
