/// Stages of the open model's operation, solved on request of the page.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "results/operation_results.h"
#include "serve/http/events.h"
#include "serve/model/open_model.h"

namespace overbend {

/// Keeps the stages of the last solution. Solves one operation at a time; may be called from any thread.
class LiveOperation {
 public:
  explicit LiveOperation(EventHub& events) : events_(events) {}

  /// Returns the answer to POST /api/operation. Sends an event `stage` for every solved stage. A newer request ends
  /// this one, which answers with the status "overtaken". HttpError 422 if the model has no operation.
  Json solve(const ModelText& model);

  /// Returns the answer to GET /api/operation/stages/N, like POST /api/static. HttpError 404 if there is no such stage
  /// or it has no equilibrium.
  Json stage(std::size_t number) const;

  /// Returns the report of the stages with the procedure sheet. HttpError 404 before they are solved.
  std::string report() const;

 private:
  EventHub& events_;
  std::atomic<std::uint64_t> asked_{0};  ///< Number of the newest request.
  std::mutex solving_;
  mutable std::mutex mutex_;  ///< Guards the members below.
  std::optional<OperationResults> solved_;
  std::string solved_text_;  ///< Text of the model.
};

/// Adds the routes; `model` and `operation` must outlive them.
void add_operation_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveOperation& operation);

}  // namespace overbend
