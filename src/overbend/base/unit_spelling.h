/// Units as engineers of this trade write them, in the spelling of UDUNITS-2.
#pragma once

#include <string>
#include <string_view>

namespace overbend {

/// The unit with the trade's own names replaced ("mt" by "tonne", "tonf" by "(9806.65 N)", "kNm2" by "kN.m2"). Names
/// that UDUNITS-2 reads as something nobody means here (millitonne, nanomile, megatesla) are replaced too.
std::string udunits_spelling(std::string_view unit);

/// Remark on a unit with two meanings in use, with the one that is taken; empty for all others.
std::string ambiguity_remark(std::string_view unit);

/// Hint on a unit whose meaning cannot be guessed (nm), or that has another sign here (" for inches); empty for all
/// others.
std::string spelling_hint(std::string_view unit);

}  // namespace overbend
