#include "base/diagnostics.h"

#include <algorithm>
#include <filesystem>

#include "base/utf8.h"

namespace overbend {

std::string render(const Diagnostic& diagnostic) {
  std::string text = diagnostic.file;
  if (diagnostic.line > 0) text += ":" + std::to_string(diagnostic.line);
  if (!diagnostic.key.empty()) text += ": " + diagnostic.key;
  text += diagnostic.expected.empty() ? ": " + diagnostic.found
                                      : ": found " + diagnostic.found + ", expected " + diagnostic.expected;
  if (!diagnostic.hint.empty()) text += "; " + diagnostic.hint;
  return text;
}

void Diagnostics::add(Diagnostic diagnostic) {
  constexpr int kMaxKept =
      // limit for files that are not models: further messages are not useful, and a million would fill the memory
      1000;
  int& count = diagnostic.severity == Severity::error ? errors_ : warnings_;
  if (++count > kMaxKept) return;
  for (std::string Diagnostic::*part :
       {&Diagnostic::file, &Diagnostic::key, &Diagnostic::found, &Diagnostic::expected, &Diagnostic::hint}) {
    diagnostic.*part = valid_utf8(diagnostic.*part);
  }
  list_.push_back(std::move(diagnostic));
}

std::vector<Diagnostic> Diagnostics::sorted() const {
  std::vector<Diagnostic> list = list_;
  std::stable_sort(list.begin(), list.end(), [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return list;
}

std::vector<std::string> Diagnostics::lines(Severity severity) const {
  std::vector<std::string> lines;
  for (const Diagnostic& diagnostic : sorted()) {
    if (diagnostic.severity == severity) lines.push_back(render(diagnostic));
  }
  return lines;
}

Findings Diagnostics::findings() const {
  Findings findings;
  for (Diagnostic diagnostic : sorted()) {
    if (diagnostic.severity != Severity::warning) continue;
    diagnostic.file = std::filesystem::path(diagnostic.file).filename().string();  // reports are passed on: no folders
    findings.push_back(Finding{diagnostic.code, render(diagnostic)}.on(diagnostic.key));
  }
  return findings;
}

}  // namespace overbend
