#include "resultfiles/stages/operation_reader.h"

#include <fmt/format.h>

#include "model/description/operation_names.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/lines/lift_hdf5.h"
#include "resultfiles/lines/lines_files.h"
#include "results/fields/lay_operation_fields.h"

namespace overbend {
namespace {

StageResult read_stage(const Hdf5Reader& file, const std::string& group) {
  StageResult stage;
  ValueReader visit{file, group};
  visit_lay_stage(stage.stage, visit);
  visit_stage_result(stage, visit);
  visit.group = group + "/failure";
  if (file.has(visit.group)) visit_stage_failure(stage.failure.emplace(), visit);
  const std::string lay = group + "/static";
  if (file.has(lay)) stage.lay = file.has(lay + "/davits") ? read_lift_group(file, lay) : read_lay_group(file, lay);
  if (stage.lay && stage.lay->lift) stage.lay->lines = read_lines(file, group + "/lines");
  return stage;
}

}  // namespace

bool has_lay_operation(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  return file.has("/operation") && !file.has("/static");
}

StoredOperation read_operation_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  StoredOperation stored;
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  visit(ResultField{"file"}, stored.model_file);
  OperationResults& results = stored.results;
  visit.group = "/operation";
  visit_operation_heading(results, visit);
  std::string type;
  visit(ResultField{"type"}, type);
  const std::optional<OperationType> known = find_operation_type(type);
  if (!known) throw std::runtime_error("dataset /operation/type: unknown value " + type);
  results.type = *known;
  visit(ResultField{"wall_time"}, results.wall_time);
  for (std::size_t i = 1;; ++i) {
    const std::string group = fmt::format("/operation/stage_{:03}", i);
    if (!file.has(group)) break;
    results.stages.push_back(read_stage(file, group));
  }
  return stored;
}

}  // namespace overbend
