#include "orcaflex/document.h"

#include <algorithm>
#include <fstream>
#include <sstream>

#include "base/text.h"

namespace overbend::orcaflex {
namespace {

constexpr std::uintmax_t kMaxFileSize = 64ULL << 20U;
constexpr std::size_t kDeepestInclude = 16;
constexpr const char* kSaveWhole = "save the whole model as a text data file";

/// Groups of OrcaFlex. A name that is not among them is that of an object, in a file of changes.
const std::vector<std::string>& known_groups() {
  static const std::vector<std::string> kGroups = {"General",
                                                   "Environment",
                                                   "VesselTypes",
                                                   "Vessels",
                                                   "LineTypes",
                                                   "Lines",
                                                   "SupportTypes",
                                                   "Winches",
                                                   "6DBuoys",
                                                   "3DBuoys",
                                                   "Links",
                                                   "Shapes",
                                                   "Constraints",
                                                   "ClumpTypes",
                                                   "DragChainTypes",
                                                   "FlexJointTypes",
                                                   "FlexJoints",
                                                   "StiffenerTypes",
                                                   "AttachmentTypes",
                                                   "LineContact",
                                                   "SolidFrictionCoefficients",
                                                   "Groups",
                                                   "VariableData",
                                                   "MultibodyGroups",
                                                   "MorisonElementTypes",
                                                   "TurbineTypes",
                                                   "Turbines",
                                                   "PyModels",
                                                   "RayleighDampingCoefficients",
                                                   "BrowserGroups",
                                                   "ExpansionTables",
                                                   "LineTypeWizard",
                                                   "CodeChecks",
                                                   "TrackedLines",
                                                   "ModelState",
                                                   "FrictionCoefficients",
                                                   "RestartParent",
                                                   "WingTypes",
                                                   "SolidFriction",
                                                   "TagSource"};
  return kGroups;
}

class DocumentReader {
 public:
  DocumentReader(const FileText& file_text, Diagnostics& diagnostics)
      : file_text_(file_text), diagnostics_(diagnostics) {}

  void read(const std::filesystem::path& file, const std::string& named_in, int line) {
    const std::filesystem::path normal = file.lexically_normal();
    const bool is_open = std::find(open_.begin(), open_.end(), normal) != open_.end();
    if (is_open || open_.size() >= kDeepestInclude) {
      complain(named_in, line, "includefile", "'" + for_display(file.string()) + "', which includes this file again",
               "files that do not include each other");
      return;
    }
    const std::optional<std::string> text = file_text_(file);
    if (!text) {
      complain(named_in.empty() ? file.string() : named_in, line, named_in.empty() ? "" : "includefile",
               "'" + for_display(file.string()) + "', which cannot be read", "a text data file (.yml)",
               "give all files of the model, in their places");
      return;
    }
    document.files.push_back(file);
    const std::string name = file.string();
    const std::optional<YamlNode> root = parse_yaml(*text, name, diagnostics_);
    if (!root || diagnostics_.has_errors()) return;
    open_.push_back(normal);
    read_node(*root, file);
    open_.pop_back();
  }

  Document document;

 private:
  void complain(const std::string& file, int line, const std::string& key, const std::string& found,
                const std::string& expected, const std::string& hint = {}) {
    diagnostics_.add({Severity::error, file, line, 0, key, found, expected, hint});
  }

  void read_node(const YamlNode& node, const std::filesystem::path& file) {
    if (node.kind == YamlNode::Kind::list) {
      for (const YamlNode& item : node.items) read_node(item, file);
      return;
    }
    if (node.kind != YamlNode::Kind::map) {
      complain(file.string(), node.line, "", "no groups", "groups such as General, Environment, Lines");
      return;
    }
    for (const YamlEntry& entry : node.entries) read_entry(entry, file);
  }

  void read_entry(const YamlEntry& entry, const std::filesystem::path& file) {
    const std::string key = for_display(entry.key);
    if (entry.key == "includefile") {
      read(file.parent_path() / std::filesystem::path(entry.value.text), file.string(), entry.line);
    } else if (entry.key == "BaseFile") {
      complain(file.string(), entry.line, key, "a file of changes to '" + for_display(entry.value.text) + "'",
               "a whole model", kSaveWhole);
    } else if (entry.key.find('[') != std::string::npos) {
      complain(file.string(), entry.line, key, "an index in brackets", "the list itself", kSaveWhole);
    } else if (std::find(known_groups().begin(), known_groups().end(), entry.key) == known_groups().end()) {
      complain(file.string(), entry.line, key, "a group that is not known", "General, Environment, Vessels, Lines, ...",
               "if it is the name of an object, the file has only changes of a model: " + std::string(kSaveWhole));
    } else {
      document.groups.push_back({entry.key, file.string(), entry.value});
    }
  }

  const FileText& file_text_;
  Diagnostics& diagnostics_;
  std::vector<std::filesystem::path> open_;  ///< Files that are being read.
};

}  // namespace

std::optional<std::string> read_file_text(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  if (std::filesystem::file_size(file, error) > kMaxFileSize || error) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return std::nullopt;
  return text.str();
}

Document read_document(const std::filesystem::path& file, const FileText& file_text, Diagnostics& diagnostics) {
  DocumentReader reader(file_text, diagnostics);
  reader.read(file, "", 0);
  return std::move(reader.document);
}

}  // namespace overbend::orcaflex
