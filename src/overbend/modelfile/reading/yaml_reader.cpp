#include "modelfile/reading/yaml_reader.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/utf8.h"
#include "base/yaml_document.h"
#include "modelfile/binding/binding.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/checks/seabed_files.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/reading/hull_files.h"
#include "modelfile/reading/mooring_reach.h"
#include "modelfile/reading/motion_files.h"
#include "modelfile/schema/field_value.h"
#include "seafiles/wave_file_reader.h"

namespace overbend {
namespace {

constexpr std::uintmax_t kMaxFileSize = 16U << 20U;

ModelReading rejected_reading(const std::string& path, const std::string& why, int line = 0) {
  ModelReading reading;
  reading.diagnostics.add({Severity::error, path, line, 0, "", why, "", ""});
  return reading;
}

int find_line(const std::string& text, std::size_t position) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

/// Returns the length of the character at `i`; 0 if it is not allowed in a text.
std::size_t text_length(const std::string& text, std::size_t i) {
  const auto byte = static_cast<unsigned char>(text[i]);
  const bool control = byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t';
  return control ? 0 : utf8_length(text, i);
}

/// Returns the position of the first byte that is not text; npos if there is none.
std::size_t find_invalid_byte(const std::string& text) {
  std::size_t i = 0;
  while (i < text.size()) {
    const std::size_t length = text_length(text, i);
    if (length == 0) return i;
    i += length;
  }
  return std::string::npos;
}

enum class Files { none, all };  ///< Selects the files named by the model that are read.

void read_tree(const YamlNode& root, const std::string& path, Files files, ModelReading& reading) {
  const FieldValue values = read_fields(root, field_tree(), path, reading.diagnostics);
  check_model(values, path, reading.diagnostics);
  if (reading.diagnostics.has_errors()) return;
  reading.description = bind_model(values, path);
  check_reach(values, *reading.description, reading.diagnostics);
  read_bathymetry_file(values, *reading.description, reading.diagnostics);
  check_shore(values, *reading.description, reading.diagnostics);
  if (files == Files::all) {
    for (WavesDescription& waves : reading.description->environment.waves) {
      read_wave_file(waves, reading.diagnostics);
    }
    check_wave_files(values, *reading.description, reading.diagnostics);
    check_sea_over_bed(values, *reading.description, reading.diagnostics);
    read_motion_file(values, *reading.description, reading.diagnostics);
    read_hull_files(values, *reading.description, reading.diagnostics);
  }
  if (reading.diagnostics.has_errors()) {
    reading.description.reset();
    return;
  }
  reading.description->findings = reading.diagnostics.findings();
}

}  // namespace

ModelReading read_model_text(const std::string& text, const std::string& path) {
  const std::size_t garbage = find_invalid_byte(text);
  if (garbage != std::string::npos) {
    return rejected_reading(
        path, "not a text file: it contains a byte that is not a UTF-8 character; a model file is YAML text",
        find_line(text, garbage));
  }
  Diagnostics diagnostics;
  std::optional<YamlNode> root = parse_yaml(text, path, diagnostics);
  return read_model_tree(root ? std::make_shared<const YamlNode>(std::move(*root)) : nullptr, diagnostics, text, path);
}

ModelReading read_model_tree(std::shared_ptr<const YamlNode> tree, const Diagnostics& diagnostics,
                             const std::string& text, const std::string& path) {
  ModelReading reading{std::nullopt, diagnostics, std::move(tree)};
  if (!reading.tree) {
    return diagnostics.has_errors()
               ? reading
               : rejected_reading(path, "the file is empty; `overbend new` writes one to start from");
  }
  if (reading.tree->kind != YamlNode::Kind::map) {
    return diagnostics.has_errors()
               ? reading
               : rejected_reading(path, "not a model file: keys such as 'overbend: 1' are expected",
                                  reading.tree->line);
  }
  read_tree(*reading.tree, path, Files::all, reading);
  if (reading.description) reading.description->source_text = text;
  return reading;
}

ModelReading read_stored_model(const std::string& text, const std::string& path) {
  ModelReading reading;
  if (find_invalid_byte(text) != std::string::npos) return reading;
  const std::optional<YamlNode> root = parse_yaml(text, path, reading.diagnostics);
  if (!root || root->kind != YamlNode::Kind::map) return reading;
  const FieldValue values = read_fields(*root, field_tree(), path, reading.diagnostics);
  if (reading.diagnostics.has_errors()) return reading;
  reading.description = bind_model(values, path);
  reading.description->source_text = text;
  return reading;
}

ModelReading read_statics_inputs(const YamlNode& root, const std::string& path) {
  ModelReading reading;
  read_tree(root, path, Files::none, reading);
  return reading;
}

ModelReading read_model(const std::string& path) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) return rejected_reading(path, "there is no such file");
  if (std::filesystem::is_directory(status)) return rejected_reading(path, "this is a folder, not a model file");
  std::ifstream file(path, std::ios::binary);
  if (!file) return rejected_reading(path, "the file cannot be read");
  std::string text(kMaxFileSize + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return rejected_reading(path, "the file cannot be read");
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kMaxFileSize) return rejected_reading(path, "larger than 16 MB, the limit for model files");
  return read_model_text(text, path);
}

}  // namespace overbend
