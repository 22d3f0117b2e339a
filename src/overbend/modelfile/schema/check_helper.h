/// Diagnostics about values of a model file, for the checks.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

class Checker {
 public:
  Checker(const FieldValue& root, std::string file, Diagnostics& diagnostics)
      : root_(root), file_(std::move(file)), diagnostics_(diagnostics) {}

  const FieldValue& root() const { return root_; }

  void error(const FieldValue& value, std::string found, std::string expected, std::string hint = {}) {
    add(Severity::error, value.line, value.path, std::move(found), std::move(expected), std::move(hint));
  }
  /// Reports a missing key at the line of its group.
  void missing(const FieldValue& group, const std::string& key, std::string expected, std::string hint = {}) {
    add(Severity::error, group.line, group.path.empty() ? key : group.path + "." + key, "nothing (the key is missing)",
        std::move(expected), std::move(hint));
  }
  void warn(const FieldValue& value, std::string remark, FindingCode code = FindingCode::unusual_input) {
    diagnostics_.add({Severity::warning, file_, value.line, 0, value.path, std::move(remark), {}, {}, code});
  }

  /// Returns the items of a list below a group; empty if it is absent.
  static const std::vector<FieldValue>& items(const FieldValue& group, const std::string& key) {
    static const std::vector<FieldValue> kNone;
    const FieldValue* list = group.find(key);
    return list != nullptr && list->kind == FieldValue::Kind::list ? list->children : kNone;
  }

 private:
  void add(Severity severity, int line, const std::string& key, std::string found, std::string expected,
           std::string hint) {
    diagnostics_.add({severity, file_, line, 0, key, std::move(found), std::move(expected), std::move(hint)});
  }

  const FieldValue& root_;
  std::string file_;
  Diagnostics& diagnostics_;
};

}  // namespace overbend
