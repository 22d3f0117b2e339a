#include "serve/http/peer_uid.h"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <string>

namespace overbend {
namespace {

/// Returns an endpoint as written in the list: the address as a number in host byte order, then the port. An
/// IPv4-mapped IPv6 address has a longer prefix.
std::string place(int port) {
  return fmt::format("{:08X}:{:04X}", htonl(INADDR_LOOPBACK), port);
}

std::optional<unsigned> owner_listed(const char* list, const std::string& from, const std::string& to) {
  std::ifstream lines(list);
  std::string line;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string number, local, remote, state, queues, timer, retries;
    unsigned owner = 0;
    if (!(fields >> number >> local >> remote >> state >> queues >> timer >> retries >> owner)) continue;
    if (local.ends_with(from) && remote.ends_with(to)) return owner;
  }
  return std::nullopt;
}

}  // namespace

std::optional<unsigned> owner_of_connection(int from, int to) {
  for (const char* list : {"/proc/net/tcp", "/proc/net/tcp6"}) {
    if (const std::optional<unsigned> owner = owner_listed(list, place(from), place(to))) return owner;
  }
  return std::nullopt;
}

}  // namespace overbend
