/// Access to the keys of an object in an OrcaFlex file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/vec.h"
#include "base/yaml_document.h"

namespace overbend::orcaflex {

/// Source of values, and destination of errors.
struct Origin {
  std::string file;
  std::string path;  ///< Path of the object: "Lines[Pipe]".
  Diagnostics* diagnostics = nullptr;
};

/// Table whose key lists its columns: `A, B, C: [[a, b, c], ...]`. Cells missing at the end of a row, and `~`, have the
/// default of the program.
class Table {
 public:
  Table(const YamlEntry& entry, Origin origin);

  std::size_t size() const { return rows_.size(); }
  /// Number in a cell; nothing if it has the default. A name in its place is an error: variable data.
  std::optional<double> number(std::size_t row, const std::string& column) const;
  /// Text of a cell; empty if it has the default.
  std::string text(std::size_t row, const std::string& column) const;
  int line(std::size_t row) const { return rows_[row]->line; }

 private:
  const YamlNode* cell(std::size_t row, const std::string& column) const;

  std::vector<std::string> columns_;
  std::vector<const YamlNode*> rows_;
  Origin origin_;
};

/// Object of the file, or a group that is one object. A key that is absent or `~` has the default of the program. The
/// node is kept by reference.
class Object {
 public:
  Object(const YamlNode& node, Origin origin) : node_(&node), origin_(std::move(origin)) {}

  std::string name() const { return text("Name"); }
  int line() const { return node_->line; }
  /// Line of a key; that of the object if the key is absent.
  int find_line(const std::string& key) const;
  const Origin& origin() const { return origin_; }

  std::optional<double> number(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise = {}) const;
  /// Numbers of a list, such as a position; nothing where an element has the default.
  std::vector<std::optional<double>> numbers(const std::string& key) const;
  /// Point or triple of angles; elements with the default are 0.
  Vec3 triple(const std::string& key) const;
  /// Objects of a list, in their order.
  std::vector<Object> objects(const std::string& key) const;
  /// Object that is the value of a key.
  std::optional<Object> object(const std::string& key) const;
  /// Table one of whose columns is `column`.
  std::optional<Table> table(const std::string& column) const;

  /// Adds an error at a key.
  void reject(const std::string& key, const std::string& found, const std::string& expected,
              const std::string& hint = {}) const;

 private:
  const YamlNode* member(const std::string& key) const;
  Origin inside(const std::string& key) const;

  const YamlNode* node_;
  Origin origin_;
};

}  // namespace overbend::orcaflex
