/// Whose program is at the other end of a connection on this machine.
#pragma once

#include <optional>

namespace overbend {

/// User id of the owner of the connection from `from` to `to`, ports of the loopback address, as the system lists it in
/// /proc/net. Nothing if it is not listed.
std::optional<unsigned> owner_of_connection(int from, int to);

}  // namespace overbend
