#include "results/static_results.h"

namespace overbend {

StaticResults::StaticResults() = default;
StaticResults::StaticResults(const StaticResults&) = default;
StaticResults::StaticResults(StaticResults&&) noexcept = default;
StaticResults& StaticResults::operator=(const StaticResults&) = default;
StaticResults& StaticResults::operator=(StaticResults&&) noexcept = default;
StaticResults::~StaticResults() = default;

}  // namespace overbend
