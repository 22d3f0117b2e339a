/// Errors in the user's input: collected, then reported all at once.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"

namespace overbend {

enum class Severity { error, warning };

/// Message about the user's input. Line and column count from 1; 0 = no position.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  int line = 0, column = 0;
  std::string key;                                ///< Full path of the key, "pipe.steel.wall_thickness"; may be empty.
  std::string found;                              ///< Value found in the file.
  std::string expected;                           ///< Expected value; empty for a plain warning.
  std::string hint;                               ///< Suggested correction; may be empty.
  FindingCode code = FindingCode::unusual_input;  ///< Code of a warning.
};

/// `model.yaml:12: pipe.steel.wall_thickness: found '250 mm', expected less than 203.2 mm; hint`
std::string render(const Diagnostic& diagnostic);

class Diagnostics {
 public:
  /// Keeps the first thousand errors and the first thousand warnings; further errors are only counted. Quoted text from
  /// files is converted to valid UTF-8.
  void add(Diagnostic diagnostic);
  bool has_errors() const { return errors_ > 0; }
  int error_count() const { return errors_; }
  /// Returns the messages in the order of the file.
  std::vector<Diagnostic> sorted() const;
  /// Returns the kept messages of one severity, one per line.
  std::vector<std::string> lines(Severity severity) const;
  /// Returns the warnings, "model.yaml:12: KEY: text", with file names without folders; their object is the key.
  Findings findings() const;

 private:
  std::vector<Diagnostic> list_;
  int errors_ = 0, warnings_ = 0;  ///< Including those not kept.
};

}  // namespace overbend
