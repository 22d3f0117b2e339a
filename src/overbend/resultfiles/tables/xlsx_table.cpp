#include "resultfiles/tables/xlsx_table.h"

#include <xlsxwriter.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/require.h"
#include "platform/file.h"
#include "platform/temporary.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// 1 January 2000: a workbook stores its creation time, and equal tables must give equal files.
constexpr std::time_t kCreationTime = 946684800;
constexpr std::size_t kMinWidth = 9, kMaxWidth = 60;  ///< Columns [characters].
constexpr std::size_t kMaxSheetName = 31;             ///< Length limit of sheet names in the file format [characters].

/// Cell formats.
struct Formats {
  lxw_workbook* book;
  lxw_format *head, *text, *good, *reserved, *bad;
  std::vector<lxw_format*> numbers;  ///< By number of decimals.

  explicit Formats(lxw_workbook* workbook)
      : book(workbook),
        head(workbook_add_format(workbook)),
        text(workbook_add_format(workbook)),
        good(workbook_add_format(workbook)),
        reserved(workbook_add_format(workbook)),
        bad(workbook_add_format(workbook)) {
    format_set_bold(head);
    format_set_text_wrap(head);
    format_set_align(head, LXW_ALIGN_VERTICAL_TOP);
    format_set_bottom(head, LXW_BORDER_THIN);
    format_set_font_color(good, 0x006100);
    format_set_font_color(reserved, 0x7F6000);
    format_set_font_color(bad, 0x9C0006);
  }

  lxw_format* verdict(VerdictKind kind) const {
    return kind == VerdictKind::passed ? good : kind == VerdictKind::exceeded ? bad : reserved;
  }

  lxw_format* number(int digits) {
    while (static_cast<int>(numbers.size()) <= digits) {
      const std::size_t decimals = numbers.size();
      numbers.push_back(workbook_add_format(book));
      format_set_num_format(numbers.back(), decimals == 0 ? "0" : ("0." + std::string(decimals, '0')).c_str());
    }
    return numbers[static_cast<std::size_t>(std::max(digits, 0))];
  }
};

/// Writes a cell of any type; returns the library's error code.
struct CellWriter {
  lxw_worksheet* sheet;
  lxw_row_t row;
  lxw_col_t column;
  Formats& formats;
  const TableColumn& head;

  lxw_error operator()(std::monostate) const { return LXW_NO_ERROR; }
  lxw_error operator()(double value) const {
    if (!std::isfinite(value)) return LXW_NO_ERROR;  // missing, as in a text table
    return worksheet_write_number(sheet, row, column, value == 0.0 ? 0.0 : value * head.factor,
                                  formats.number(head.digits));
  }
  lxw_error operator()(const std::string& text) const {
    return worksheet_write_string(sheet, row, column, text.c_str(), formats.text);
  }
  lxw_error operator()(const VerdictCell& verdict) const {
    return worksheet_write_string(sheet, row, column, verdict.text.c_str(), formats.verdict(verdict.kind));
  }
};

std::size_t text_width(const TableCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return text->size();
  if (const auto* verdict = std::get_if<VerdictCell>(&cell)) return verdict->text.size();
  return 0;
}

/// Returns a width sufficient for the texts; a heading may break before its unit.
double column_width(const Table& table, std::size_t column) {
  std::size_t width = std::max(kMinWidth, table.columns[column].title.size());
  for (const TableRow& row : table.rows) width = std::max(width, text_width(row.cells[column]));
  return 1.0 + static_cast<double>(std::min(width, kMaxWidth));
}

/// Returns a valid name of a sheet.
std::string sheet_name(std::string name) {
  for (char& c : name) {
    if (std::string("[]:*?/\\'").find(c) != std::string::npos) c = ' ';
  }
  return name.substr(0, kMaxSheetName);
}

void write_sheet(const Table& table, Formats& formats, const fs::path& file) {
  lxw_worksheet* sheet = workbook_add_worksheet(formats.book, sheet_name(table.title).c_str());
  if (sheet == nullptr) throw_file_error(file, "written", library_error());
  worksheet_freeze_panes(sheet, 1, 1);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const auto column = static_cast<lxw_col_t>(i);
    worksheet_set_column(sheet, column, column, column_width(table, i), nullptr);
    worksheet_write_string(sheet, 0, column, title_with_unit(table.columns[i]).c_str(), formats.head);
  }
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    require(table.rows[r].cells.size() == table.columns.size(), "a row of a table has a cell for every column");
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      const CellWriter cell{sheet, static_cast<lxw_row_t>(r + 1), static_cast<lxw_col_t>(i), formats, table.columns[i]};
      const lxw_error error = std::visit(cell, static_cast<const CellValue&>(table.rows[r].cells[i]));
      if (error != LXW_NO_ERROR) throw FileError("the file '" + file.string() + "': " + lxw_strerror(error));
    }
  }
}

}  // namespace

void write_xlsx(const std::vector<Table>& tables, const fs::path& file) {
  const fs::path partial_file = file.string() + ".part";
  std::string temporary = temporary_folder().string();
  lxw_workbook_options options{LXW_FALSE, temporary.data(), LXW_FALSE};
  lxw_workbook* book = workbook_new_opt(partial_file.string().c_str(), &options);
  if (book == nullptr) throw_file_error(file, "written", library_error());
  lxw_doc_properties properties = {};
  properties.created = kCreationTime;
  workbook_set_properties(book, &properties);
  Formats formats(book);
  std::string error;
  try {
    for (const Table& table : tables) write_sheet(table, formats, file);
  } catch (const FileError& failure) {
    error = failure.what();
  }
  const lxw_error closed = workbook_close(book);  // also frees it on failure
  if (error.empty() && closed != LXW_NO_ERROR) {
    error = "the file '" + file.string() + "' cannot be written: " + lxw_strerror(closed);
  }
  std::error_code ignored, rename_error;
  if (error.empty()) rename_error = rename_file(partial_file, file);
  if (rename_error) error = "the file '" + file.string() + "' cannot be written: " + rename_error.message();
  if (error.empty()) return;
  fs::remove(partial_file, ignored);
  throw FileError(error);
}

}  // namespace overbend
