#include "results/mooring_results.h"

namespace overbend {

MooringResults::MooringResults() = default;
MooringResults::MooringResults(const MooringResults&) = default;
MooringResults::MooringResults(MooringResults&&) noexcept = default;
MooringResults& MooringResults::operator=(const MooringResults&) = default;
MooringResults& MooringResults::operator=(MooringResults&&) noexcept = default;
MooringResults::~MooringResults() = default;

}  // namespace overbend
