#include "resultfiles/stages/operation_writer.h"

#include <fmt/format.h>

#include "model/description/operation_names.h"
#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/hdf5/object_links.h"
#include "resultfiles/lines/lift_hdf5.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/stages/stage_table.h"
#include "resultfiles/static/check_tables.h"
#include "resultfiles/static/finite_check.h"
#include "resultfiles/tables/data_table.h"
#include "resultfiles/tables/finite_visitor.h"
#include "resultfiles/tables/xlsx_table.h"
#include "results/fields/lay_operation_fields.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

void require_finite_stages(const OperationResults& results) {
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    FiniteVisitor visit{indexed("operation.stages", i)};
    visit_lay_stage(stage.stage, visit);
    visit_stage_result(stage, visit);
    if (stage.failure) visit_stage_failure(*stage.failure, visit);
    if (!stage.lay) continue;
    if (stage.lay->lift) {
      require_finite(stage.lay->lines);
      require_finite(stage.lay->checks, visit.place + "checks.");
    } else {
      require_finite(*stage.lay);
    }
  }
}

std::string stage_group(std::size_t index) {
  return fmt::format("/operation/stage_{:03}", index + 1);
}

void write_stage(DatasetSink& file, const std::string& group, const StageResult& stage) {
  file.group(group, "A stage of the operation");
  ValueWriter visit{file, group};
  visit_lay_stage(stage.stage, visit);
  visit_stage_result(stage, visit);
  if (stage.failure) {
    visit.group = group + "/failure";
    file.group(visit.group, "Reason why the stage has no equilibrium");
    visit_stage_failure(*stage.failure, visit);
  }
  if (stage.lay && stage.lay->lift) {
    write_lift_group(file, group + "/static", *stage.lay);
    write_lines(file, stage.lay->lines, group + "/lines");
  } else if (stage.lay) {
    write_lay_group(file, group + "/static", *stage.lay);
  }
}

void write_stage_checks(const OperationResults& results, const std::filesystem::path& folder) {
  std::vector<StageChecks> stages;
  for (const StageResult& stage : results.stages) {
    if (stage.lay && !stage.lay->checks.rows.empty()) stages.push_back({stage.stage.name, stage.lay->checks});
  }
  if (stages.empty()) return;
  write_text(folder / "checks.csv", checks_table(stages));
  write_text(folder / "calculation_sheet.csv", calculation_sheet_table(stages));
}

void write_stage_lines(const OperationResults& results, const std::filesystem::path& folder) {
  std::vector<StageLines> stages;
  for (const StageResult& stage : results.stages) {
    if (stage.lay && !stage.lay->lines.empty()) stages.push_back({stage.stage.name, stage.lay->lines});
  }
  if (!stages.empty()) write_text(folder / "lines.csv", lines_table(stages));
}

}  // namespace

void write_operation_groups(DatasetSink& file, const OperationResults& results) {
  file.group("/operation", "Stages of an operation on the line");
  ValueWriter visit{file, "/operation"};
  visit_operation_heading(results, visit);
  visit(ResultField{"type", "1", "Type of the operation"}, std::string(operation_name(results.type)));
  visit(ResultField{"wall_time", "s", "Wall time of the solver, all stages"}, results.wall_time);
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    write_stage(file, stage_group(i), results.stages[i]);
  }
}

void write_operation_hdf5(const OperationResults& results, const Description& description,
                          const std::filesystem::path& path) {
  Hdf5Writer file(path);
  write_results_heading(file, results.title, description);
  write_operation_groups(file, results);
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    if (stage.lay && !stage.lay->lift) {
      link_objects(file, *stage.lay, stage_group(i), "/stages/" + dataset_path(stage.stage.name));
    }
  }
  file.close();
}

void write_operation_files(const OperationResults& results, const Description& description,
                           const std::filesystem::path& folder) {
  require_finite_stages(results);
  write_operation_hdf5(results, description, folder / "results.h5");
  const Table table = stages_table(results);
  write_text(folder / "stages.csv", csv_text(table));
  write_xlsx({table}, folder / "stages.xlsx");
  write_stage_checks(results, folder);
  write_stage_lines(results, folder);
  write_text(folder / "summary.json", operation_summary(results));
}

}  // namespace overbend
