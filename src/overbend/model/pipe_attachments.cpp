#include "model/pipe_attachments.h"

#include <algorithm>

#include "base/ranges.h"
#include "model/lay_stage.h"

namespace overbend {

bool is_on_pipe(const Description& description, const LineEndDescription& end) {
  return description.has_pipe && end.kind == LineEndKind::line && end.line == "pipe";
}

std::vector<PipeAttachment> pipe_attachments(const Description& description) {
  std::vector<PipeAttachment> all;
  if (!description.has_pipe) return all;
  const double gone = pipe_shift(description), begins = pipe_start_distance(description),
               ends = pipe_end_distance(description);
  const auto add = [&](double arc_length, const LinePointDescription* point, const FreeLineDescription* line) {
    const double from_top = arc_length + gone;
    if (from_top > begins && from_top < ends) all.push_back({from_top, point, line});
  };
  for (const LinePointDescription& point : description.pipe.points) add(point.at, &point, nullptr);
  for (const FreeLineDescription& line : description.lines) {
    for (const LineEndDescription* end : {&line.first, &line.second}) {
      if (is_on_pipe(description, *end)) add(end->arc_length, nullptr, &line);
    }
  }
  ranges::stable_sort(all, {}, &PipeAttachment::from_top);
  return all;
}

}  // namespace overbend
