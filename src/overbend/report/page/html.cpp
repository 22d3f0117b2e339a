#include "report/page/html.h"

#include <fmt/format.h>

#include "base/shown_unit.h"

namespace overbend::html {

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

std::string fixed(double value, int digits) {
  return shown_number(value, ShownUnit{}, digits);
}

std::string section(const std::string& id, const std::string& heading, const std::string& body) {
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, escape(heading), body);
}

std::string list(const std::vector<std::string>& items) {
  std::string out = "<ul>\n";
  for (const std::string& item : items) {
    out += "<li>" + escape(item) + "</li>\n";
  }
  return out + "</ul>\n";
}

std::string tile(const std::string& name, const std::string& value, const std::string& unit, const std::string& note,
                 bool over) {
  constexpr std::size_t kLong = 9;  // letters in large print that find room in a tile
  return fmt::format(
      "<div class=\"{}\"><div class=\"name\">{}</div><div class=\"{}\">{} <span>{}</span></div>"
      "<div class=\"note\">{}</div></div>\n",
      over ? "tile over" : "tile", escape(name), value.size() > kLong ? "value long" : "value", escape(value),
      escape(unit), escape(note));
}

std::string entries(const std::vector<std::pair<std::string, std::string>>& all) {
  std::string out = "<dl>";
  for (const auto& [name, value] : all) {
    out += "<div><dt>" + escape(name) + "</dt><dd>" + escape(value) + "</dd></div>";
  }
  return out + "</dl>\n";
}

std::string folded(const std::string& summary, const std::string& body, bool printed) {
  return fmt::format("<details class=\"{}\"><summary>{}</summary>\n{}</details>\n",
                     printed ? "print-open" : "print-not", escape(summary), body);
}

Table::Table(std::string caption, std::vector<Head> head, std::string css_class)
    : caption_(std::move(caption)), css_class_(std::move(css_class)), head_(std::move(head)) {}

Table& Table::groups(std::vector<std::pair<std::string, int>> groups) {
  groups_ = std::move(groups);
  return *this;
}

Table& Table::row(const std::vector<std::string>& cells, const std::string& css_class) {
  body_ += css_class.empty() ? "<tr>" : "<tr class=\"" + css_class + "\">";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const bool words = i < head_.size() && head_[i].text;
    body_ += (words ? "<td class=\"t\">" : "<td>") + escape(cells[i]) + "</td>";
  }
  body_ += "</tr>\n";
  return *this;
}

std::string Table::str() const {
  std::string out = fmt::format("<div class=\"table\"><table class=\"{}\">\n", css_class_);
  if (!caption_.empty()) {
    out += "<caption>" + escape(caption_) + "</caption>\n";
  }
  out += "<thead>\n";
  if (!groups_.empty()) {
    out += "<tr class=\"groups\">";
    for (const auto& [title, span] : groups_) {
      out += fmt::format("<th colspan=\"{}\">{}</th>", span, escape(title));
    }
    out += "</tr>\n";
  }
  out += "<tr>";
  for (const Head& head : head_) {
    const std::string unit = head.unit.empty() ? "" : "<br><span class=\"unit\">" + escape(head.unit) + "</span>";
    out += (head.text ? "<th class=\"t\">" : "<th>") + escape(head.name) + unit + "</th>";
  }
  return out + "</tr>\n</thead>\n<tbody>\n" + body_ + "</tbody>\n</table></div>\n";
}

}  // namespace overbend::html
