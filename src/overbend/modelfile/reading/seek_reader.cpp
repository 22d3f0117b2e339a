#include "modelfile/reading/seek_reader.h"

#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"

namespace overbend {

std::optional<SeekDescription> read_seek(const Description& description) {
  Diagnostics none;  // not reported: the text was read before without errors
  const std::optional<YamlNode> root = parse_yaml(description.source_text, description.source_file, none);
  if (!root) return std::nullopt;
  for (const YamlEntry& entry : root->entries) {
    if (entry.key != "seek") continue;
    const FieldNode& node = field_node("seek");
    SeekDescription seek;
    bind_members(node, read_fields(entry.value, node, description.source_file, none), &seek, description.source_file);
    return seek;
  }
  return std::nullopt;
}

}  // namespace overbend
