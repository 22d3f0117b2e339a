/// The frame of every page: head, style, scripts, data; and how it comes to disk.
#pragma once

#include <filesystem>
#include <string>

#include "base/json.h"

namespace overbend {

/// A page that needs nothing beside it, with the scripts of the objects in its data. `title` is plain text, `body`
/// HTML, `data` what its scripts draw.
std::string whole_page(const std::string& title, const std::string& body, const Json& data);

/// Of an operation on the line, whose figures are those of its stages.
std::string operation_page(const std::string& title, const std::string& body, const Json& data);

/// The same of a lay table.
std::string lay_table_frame(const std::string& title, const std::string& body, const std::string& data);

/// Of results of several folders.
std::string overlay_frame(const std::string& title, const std::string& body, const std::string& data);

/// The same of a study.
std::string study_frame(const std::string& title, const std::string& body, const std::string& data);

/// Writes beside the file first and then renames. Throws std::runtime_error where that fails.
void write_page(const std::string& page, const std::filesystem::path& file);

/// What stands at the top and bottom of every printed page, plain text; a style element.
struct PageMargins {
  std::string document;  ///< "BGL-OB-001, rev. B"; may be empty.
  std::string title, kind, written;
};
std::string page_margins(const PageMargins& margins);

/// "2026-11-21 14:30 UTC"
std::string written_now();

}  // namespace overbend
