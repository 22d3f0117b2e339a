/// User at the other end of a local connection.
#pragma once

#include <optional>

namespace overbend {

/// Returns the user id of the owner of the connection between the loopback ports `from` and `to`, as listed in
/// /proc/net; nothing if it is not listed.
std::optional<unsigned> owner_of_connection(int from, int to);

}  // namespace overbend
