/// The parts of the page, one file each.
#pragma once

#include "comparison.h"

namespace overbend::validation {

Group static_cases();
Group field_lays();
Group cantilevers();
Group beams();
Group roller_deck();
Group jlays();
Group bgl1_example();
Group code_checks();
Group dynamic();
Group convergence();
Group lines();
Group lay_operations();
Group lifts();
Group pulls();
Group uneven_beds();
Group stingers();
Group fatigue();

}  // namespace overbend::validation
