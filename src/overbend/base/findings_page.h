/// docs/guide/findings.md: every code of a finding with its severity, meaning and remedy.
#pragma once

#include <string>

namespace overbend {

/// Returns the page as Markdown.
std::string findings_page();

}  // namespace overbend
