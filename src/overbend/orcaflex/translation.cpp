#include "orcaflex/translation.h"

#include <cmath>

#include "base/constants.h"

namespace overbend::orcaflex {

Vec3 Vessel::from_global(const Vec3& point) const {
  const Vec3 offset = point - position;
  const double c = std::cos(heading), s = std::sin(heading);
  return {c * offset.x() + s * offset.y(), -s * offset.x() + c * offset.y(), offset.z()};
}

Vec3 Vessel::to_global(const Vec3& point) const {
  const double c = std::cos(heading), s = std::sin(heading);
  return position + Vec3(c * point.x() - s * point.y(), s * point.x() + c * point.y(), point.z());
}

double Line::length() const {
  double sum = 0.0;
  for (const Piece& piece : pieces) sum += piece.length;
  return sum;
}

const Line* Translation::laid_pipe() const {
  for (const Line& line : lines) {
    if (line.is_laid) return &line;
  }
  return nullptr;
}

std::optional<Object> Translation::group(const std::string& name) const {
  for (const Group& group : document.groups) {
    if (group.name == name) return Object(group.content, {group.file, name, &diagnostics});
  }
  return std::nullopt;
}

std::vector<Object> Translation::objects(const std::string& name) const {
  std::vector<Object> result;
  for (const Group& group : document.groups) {
    if (group.name != name) continue;
    for (const YamlNode& item : group.content.items) {
      if (item.kind != YamlNode::Kind::map) continue;
      const Object unnamed(item, {group.file, name, &diagnostics});
      result.emplace_back(item, Origin{group.file, name + "[" + unnamed.name() + "]", &diagnostics});
    }
  }
  return result;
}

std::string number_text(double value) {
  if (std::abs(value) < 1e-12) return "0";
  return fmt::format("{:.12g}", value);
}

std::string quantity_text(double value, const char* unit) {
  return number_text(value) + " " + unit;
}

std::string name_text(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) text += c;
  }
  return text + "\"";
}

}  // namespace overbend::orcaflex
