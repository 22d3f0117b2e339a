#include "results/dynamic_results.h"

namespace overbend {

DynamicResults::DynamicResults() = default;
DynamicResults::DynamicResults(const DynamicResults&) = default;
DynamicResults::DynamicResults(DynamicResults&&) noexcept = default;
DynamicResults& DynamicResults::operator=(const DynamicResults&) = default;
DynamicResults& DynamicResults::operator=(DynamicResults&&) noexcept = default;
DynamicResults::~DynamicResults() = default;

}  // namespace overbend
