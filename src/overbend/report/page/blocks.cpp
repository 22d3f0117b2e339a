#include "report/page/blocks.h"

namespace overbend {

Blocks::Blocks(const Table& table) {
  if (table.rows.empty()) return;
  Json block = {{"kind", "table"}};
  block.update(table_json(table));
  list_.push_back(std::move(block));
}

Blocks& Blocks::operator+=(const Blocks& more) {
  list_.insert(list_.end(), more.list_.begin(), more.list_.end());
  return *this;
}

Blocks operator+(Blocks first, const Blocks& second) {
  first += second;
  return first;
}

namespace block {

Blocks section(const std::string& id, const std::string& heading, const Blocks& body) {
  if (body.empty()) return {};
  return Blocks({{"kind", "section"}, {"id", id}, {"heading", heading}, {"body", body.json()}});
}

Blocks paragraph(const std::string& text) {
  return Blocks({{"kind", "paragraph"}, {"text", text}});
}

Blocks paragraph(const std::string& text, const std::string& link_text, const std::string& section_id) {
  return Blocks({{"kind", "paragraph"}, {"text", text}, {"link", {{"text", link_text}, {"to", section_id}}}});
}

Blocks remark(const std::string& text) {
  return Blocks({{"kind", "remark"}, {"text", text}});
}

Blocks subheading(const std::string& text) {
  return Blocks({{"kind", "subheading"}, {"text", text}});
}

Blocks list(const std::vector<std::string>& sentences, bool numbered) {
  if (sentences.empty()) return {};
  Json block = {{"kind", "list"}, {"items", sentences}};
  if (numbered) block["numbered"] = true;
  return Blocks(block);
}

Blocks folded(const std::string& summary, const Blocks& body, bool printed) {
  if (body.empty()) return {};
  return Blocks({{"kind", "folded"}, {"summary", summary}, {"printed", printed}, {"body", body.json()}});
}

Blocks columns(const Blocks& body) {
  return group("columns", body);
}

Blocks group(const std::string& look, const Blocks& body) {
  if (body.empty()) return {};
  return Blocks({{"kind", "group"}, {"look", look}, {"body", body.json()}});
}

Blocks tiles(const std::vector<Tile>& all) {
  if (all.empty()) return {};
  Json list = Json::array();
  for (const Tile& tile : all) {
    Json row = {{"name", tile.name}, {"value", tile.value}, {"unit", tile.unit}, {"note", tile.note}};
    if (tile.over) row["over"] = true;
    list.push_back(row);
  }
  return Blocks({{"kind", "tiles"}, {"tiles", list}});
}

Blocks entry_frame(const std::vector<std::pair<std::string, std::string>>& entries) {
  Json list = Json::array();
  for (const auto& [name, value] : entries) list.push_back({name, value});
  return Blocks({{"kind", "entries"}, {"entries", list}});
}

Blocks verbatim(const std::string& text) {
  return Blocks({{"kind", "verbatim"}, {"text", text}});
}

Blocks figure(const Figure& figure, const Json& data) {
  if (figure.parts.empty()) return {};
  Json block = {{"kind", "figure"}, {"id", figure.id}, {"caption", figure.caption}, {"parts", figure.parts}};
  if (figure.small) block["small"] = true;
  if (!data.is_null()) block["data"] = data;
  return Blocks(block);
}

}  // namespace block
}  // namespace overbend
