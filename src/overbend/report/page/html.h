/// A report for readers without scripts: the only HTML that the program writes itself.
#pragma once

#include <string>
#include <string_view>

#include "report/page/page.h"

namespace overbend::html {

/// Escapes text for element content and quoted attributes.
std::string escape(std::string_view text);

/// Escapes JSON for a script element: no "<" remains, and thus no "</script>".
std::string escape_json(std::string_view json);

/// Returns first page, key results and checks of a document as headings, paragraphs, lists and tables.
std::string plain(const Document& document);

}  // namespace overbend::html
