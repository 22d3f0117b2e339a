/// Who may talk to the server: the page that this start has opened, and nobody else.
#pragma once

#include <string>

namespace overbend {

/// 128 random bits as 32 hexadecimal digits.
std::string random_token();

/// Compares in a time that does not tell how much of the token was right.
bool same_token(const std::string& given, const std::string& token);

/// Whether a request's Host names this server: another name that leads to this machine is some page's trick.
bool own_host(const std::string& host, int port);

/// Whether an Origin is the server's own page. None at all (empty) is no other page's.
bool own_origin(const std::string& origin, int port);

}  // namespace overbend
