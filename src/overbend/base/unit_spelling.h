/// Industry spellings of units, converted to those of UDUNITS-2.
#pragma once

#include <string>
#include <string_view>

namespace overbend {

/// Returns the unit with industry names replaced ("mt" by "tonne", "tonf" by "(9806.65 N)", "kNm2" by "kN.m2"). Names
/// that UDUNITS-2 reads as units never meant here (millitonne, nanomile, megatesla) are replaced too.
std::string udunits_spelling(std::string_view unit);

/// Returns a remark on a unit with two meanings in use, with the one assumed; empty for all others.
std::string ambiguity_remark(std::string_view unit);

/// Returns a hint on a unit whose meaning is ambiguous (nm), or that has another symbol here (" for inches); empty for
/// all others.
std::string spelling_hint(std::string_view unit);

}  // namespace overbend
