/// The stages of the open model's operation on the line, solved when the page asks for them.
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

/// Keeps the stages of the last solution. One solution at a time; may be called from any thread.
class LiveOperation {
 public:
  explicit LiveOperation(EventHub& events) : events_(events) {}

  /// The answer of POST /api/operation. Every stage that is done is told as an event `stage`; a newer request ends the
  /// one that is going on, which answers with the status "overtaken". HttpFault 422 where the model has no operation.
  Json solve(const ModelText& model);

  /// The answer of GET /api/operation/stages/N, as POST /api/static. HttpFault 404 where there is no such stage, or it
  /// has no equilibrium.
  Json stage(std::size_t number) const;

  /// The report of the stages, with the procedure sheet. HttpFault 404 before they are solved.
  std::string report() const;

 private:
  EventHub& events_;
  std::atomic<std::uint64_t> asked_{0};  ///< Number of the newest request.
  std::mutex solving_;
  mutable std::mutex mutex_;  ///< Of what follows.
  std::optional<OperationResults> solved_;
  std::string solved_text_;  ///< Of the model.
};

/// Adds both routes; what they are given must outlive them.
void add_operation_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveOperation& operation);

}  // namespace overbend
