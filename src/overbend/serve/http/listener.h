/// Server of the HTTP library with limits on time, size and number of connections. Every request must begin where the
/// previous one ended.
#pragma once

#include <functional>
#include <memory>

#include "serve/http/connection.h"
#include "serve/http/connection_limiter.h"

namespace overbend {

class LimitedServer : public httplib::Server {
 public:
  enum class Standing {
    rejected,         ///< Answered without reading its body.
    unauthenticated,  ///< Served, but without a token.
    known,            ///< Served, with a valid token.
  };
  /// Classifies a request by its head.
  using Judge = std::function<Standing(const httplib::Request&)>;

  explicit LimitedServer(Judge judge, const RequestBounds& bounds = {});

  /// To be called when the port is bound: sets the backlog to the system maximum. With the library's backlog of five,
  /// further clients would retry only after a second.
  void set_backlog();
  /// Ends all connections. To be called after stop().
  void close() { limiter_.close(); }

 private:
  bool process_and_close_socket(socket_t socket) override;
  void serve(ConnectionLimiter::Registration& registration, Connection& connection);
  bool serve_request(ConnectionLimiter::Registration& registration, Connection& connection);

  Judge judge_;
  RequestBounds bounds_;
  ConnectionLimiter limiter_;
};

}  // namespace overbend
