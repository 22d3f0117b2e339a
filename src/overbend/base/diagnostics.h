/// Errors in the user's input: collected, then reported all at once.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"

namespace overbend {

enum class Severity { error, warning };

/// One thing noticed in a file. Line and column count from 1; 0 = not tied to a place.
struct Diagnostic {
  Severity severity = Severity::error;
  std::string file;
  int line = 0, column = 0;
  std::string key;                                ///< Full path of the key, "pipe.steel.wall_thickness"; may be empty.
  std::string found;                              ///< What was found.
  std::string expected;                           ///< What should; empty for a plain remark.
  std::string hint;                               ///< How to correct it; may be empty.
  FindingCode code = FindingCode::unusual_input;  ///< Of a warning.
};

/// `model.yaml:12: pipe.steel.wall_thickness: found '250 mm', expected less than 203.2 mm; hint`
std::string render(const Diagnostic& diagnostic);

class Diagnostics {
 public:
  /// Keeps the first thousand errors and the first thousand warnings; of what follows errors are only counted. What
  /// they quote of files becomes valid UTF-8.
  void add(Diagnostic diagnostic);
  bool has_errors() const { return errors_ > 0; }
  int error_count() const { return errors_; }
  /// In the order of the file.
  std::vector<Diagnostic> sorted() const;
  /// All that were kept of one severity, one a line.
  std::vector<std::string> lines(Severity severity) const;
  /// The warnings: "model.yaml:12: KEY: remark", of files without their folders; their object is the key.
  Findings findings() const;

 private:
  std::vector<Diagnostic> list_;
  int errors_ = 0, warnings_ = 0;  ///< Those not kept as well.
};

}  // namespace overbend
