#include "app/print_findings.h"

#include <fmt/format.h>

namespace overbend {

std::string finding_lines(const Findings& findings) {
  std::string text;
  for (const Finding& finding : sorted_by_severity(findings)) {
    text += fmt::format("  {}: {} [{}]\n", name(finding.severity()), finding.message, kind(finding.code).name);
  }
  return text;
}

std::string shared_finding_lines(const std::vector<Findings>& runs, const std::string& runs_name) {
  std::string text;
  for (const SharedFinding& shared : shared_findings(runs)) {
    text += fmt::format("  {} ({} of {} {}): {} [{}]\n", name(shared.worst.severity()), shared.runs.size(), runs.size(),
                        runs_name, shared.text(), kind(shared.worst.code).name);
  }
  return text;
}

}  // namespace overbend
