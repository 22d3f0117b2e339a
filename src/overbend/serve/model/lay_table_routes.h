/// Requests for lay tables of the open model.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "results/lay_table_results.h"
#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// Makes one table at a time and keeps the last one for downloads; may be called from any thread.
class LayTables {
 public:
  /// Returns the answer to POST /api/lay-table. A newer request ends this one with HttpError 409.
  Json make(const ModelText& model, const Json& request);
  /// Returns the last table as a download; HttpError 404 if there is none.
  HttpAnswer csv() const;
  HttpAnswer xlsx() const;

 private:
  std::shared_ptr<const LayTable> last() const;

  std::atomic<std::uint64_t> asked_{0};  ///< Number of the newest request; earlier ones are ended.
  std::mutex work_;
  mutable std::mutex mutex_;
  std::shared_ptr<const LayTable> last_;
};

/// Adds the routes; `model` and `tables` must outlive them.
void add_lay_table_routes(std::vector<HttpRoute>& routes, OpenModel& model, LayTables& tables);

}  // namespace overbend
