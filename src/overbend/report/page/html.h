/// A report for readers without scripts: the only HTML that the program writes itself.
#pragma once

#include <string>
#include <string_view>

#include "report/page/page.h"

namespace overbend::html {

/// Text made harmless in element content and in quoted attributes.
std::string escape(std::string_view text);

/// JSON made harmless inside a script element: no "<" is left, so no "</script>" either.
std::string escape_json(std::string_view json);

/// First page, key results and checks of a document as headings, paragraphs, lists and tables.
std::string plain(const Document& document);

}  // namespace overbend::html
