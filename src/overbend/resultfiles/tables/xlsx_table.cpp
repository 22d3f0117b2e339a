#include "resultfiles/tables/xlsx_table.h"

#include <xlsxwriter.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/require.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// 1 January 2000: a workbook tells when it was made, and equal tables shall give equal files.
constexpr std::time_t kMade = 946684800;
constexpr std::size_t kNarrowest = 9, kWidest = 60;  ///< Columns [characters].
constexpr std::size_t kLongestName = 31;             ///< Of a sheet, by the format [characters].

/// How cells look.
struct Formats {
  lxw_workbook* book;
  lxw_format *head, *text, *good, *reserved, *bad;
  std::vector<lxw_format*> numbers;  ///< By decimals.

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

/// Writes a cell of either kind; false where the library refuses.
struct CellWriter {
  lxw_worksheet* sheet;
  lxw_row_t row;
  lxw_col_t column;
  Formats& formats;
  const TableColumn& head;

  lxw_error operator()(std::monostate) const { return LXW_NO_ERROR; }
  lxw_error operator()(double value) const {
    if (!std::isfinite(value)) return LXW_NO_ERROR;  // absent, as in a table of text
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

/// Wide enough for its texts; a heading may break before its unit.
double column_width(const Table& table, std::size_t column) {
  std::size_t width = std::max(kNarrowest, table.columns[column].title.size());
  for (const TableRow& row : table.rows) width = std::max(width, text_width(row.cells[column]));
  return 1.0 + static_cast<double>(std::min(width, kWidest));
}

/// A name that a sheet may have.
std::string sheet_name(std::string name) {
  for (char& c : name) {
    if (std::string("[]:*?/\\'").find(c) != std::string::npos) c = ' ';
  }
  return name.substr(0, kLongestName);
}

void write_sheet(const Table& table, Formats& formats, const fs::path& file) {
  lxw_worksheet* sheet = workbook_add_worksheet(formats.book, sheet_name(table.title).c_str());
  if (sheet == nullptr) refuse_file(file, "written");
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
      const lxw_error fault = std::visit(cell, static_cast<const CellValue&>(table.rows[r].cells[i]));
      if (fault != LXW_NO_ERROR) throw FileFault("the file '" + file.string() + "': " + lxw_strerror(fault));
    }
  }
}

}  // namespace

void write_xlsx(const std::vector<Table>& tables, const fs::path& file) {
  const fs::path beside = file.string() + ".part";
  lxw_workbook* book = workbook_new(beside.c_str());
  if (book == nullptr) refuse_file(file, "written");
  lxw_doc_properties properties = {};
  properties.created = kMade;
  workbook_set_properties(book, &properties);
  Formats formats(book);
  std::string fault;
  try {
    for (const Table& table : tables) write_sheet(table, formats, file);
  } catch (const FileFault& refused) {
    fault = refused.what();
  }
  const lxw_error closed = workbook_close(book);  // frees it, whatever happened
  if (fault.empty() && closed != LXW_NO_ERROR) {
    fault = "the file '" + file.string() + "' cannot be written: " + lxw_strerror(closed);
  }
  std::error_code ignored, refused;
  if (fault.empty()) fs::rename(beside, file, refused);
  if (refused) fault = "the file '" + file.string() + "' cannot be written: " + refused.message();
  if (fault.empty()) return;
  fs::remove(beside, ignored);
  throw FileFault(fault);
}

}  // namespace overbend
