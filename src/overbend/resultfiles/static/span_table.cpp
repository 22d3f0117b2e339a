#include "resultfiles/static/span_table.h"

#include "resultfiles/tables/csv_fields.h"
#include "results/fields/ground_fields.h"

namespace overbend {

std::string span_table(const BedResults& bed) {
  CsvHead head;
  const FreeSpanResult example;
  visit_free_span(example, head);
  CsvTable table(head.names);
  for (const FreeSpanResult& span : bed.spans) {
    CsvCells cells{table};
    visit_free_span(span, cells);
    table.end_row();
  }
  return table.text();
}

}  // namespace overbend
