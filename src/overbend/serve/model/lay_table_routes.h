/// Lay tables of the open model.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>

#include "results/lay_table_results.h"
#include "serve/http/http.h"
#include "serve/model/open_model.h"

namespace overbend {

/// Makes one table at a time and keeps the last for its downloads; may be called from any thread.
class LayTables {
 public:
  /// The answer of POST /api/lay-table.
  Json make(const ModelText& model, const Json& request);
  /// The last table; 404 where there is none.
  HttpAnswer csv() const;
  HttpAnswer xlsx() const;

 private:
  std::shared_ptr<const LayTable> last() const;

  std::atomic<std::uint64_t> asked_{0};  ///< Number of the newest request; those before it end.
  std::mutex work_;
  mutable std::mutex mutex_;
  std::shared_ptr<const LayTable> last_;
};

/// Adds the routes; what they are given must outlive them.
void add_lay_table_routes(std::vector<HttpRoute>& routes, OpenModel& model, LayTables& tables);

}  // namespace overbend
