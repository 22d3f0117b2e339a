/// A report as one file that opens offline in any browser and prints on A4 and Letter: the document and the data of its
/// figures as JSON, and the embedded page components that draw them (web/src/report).
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"
#include "report/page/blocks.h"

namespace overbend {

/// A report as data.
struct Document {
  std::string title;  ///< Title of the window.
  Json front;         ///< The first page, see front_page.h.
  Blocks body;        ///< Its sections, in their order.
  Json data;          ///< Data of the figures.
};

/// Returns the text of the file. Readers without scripts see first page, key results and checks as plain tables.
std::string page_text(const Document& document);

/// Writes a temporary file and renames it. Throws std::runtime_error on failure.
void write_page(const Document& document, const std::filesystem::path& file);

/// Returns the time as "2026-11-21 14:30 UTC".
std::string written_now();

}  // namespace overbend
