/// The HTTP library's server behind a door of our own: bounded time, size and number of connections, and no request
/// that begins anywhere but where the one before it ended.
#pragma once

#include <functional>
#include <memory>

#include "serve/http/connection.h"
#include "serve/http/doorkeeper.h"

namespace overbend {

class DoorServer : public httplib::Server {
 public:
  enum class Standing {
    refused,   ///< It is answered without reading its body.
    stranger,  ///< It is served, but bears no token.
    known,
  };
  /// Judges a request by its head.
  using Judge = std::function<Standing(const httplib::Request&)>;

  explicit DoorServer(Judge judge, const RequestBounds& bounds = {});

  /// To be called when the port is bound: as many may wait for the door as the system allows. The library lets five,
  /// and who comes then tries again only after a second.
  void widen();
  /// Ends all connections. To be called after stop().
  void close() { keeper_.close(); }

 private:
  bool process_and_close_socket(int socket) override;
  void serve(Doorkeeper::Visit& visit, Connection& connection);
  bool serve_request(Doorkeeper::Visit& visit, Connection& connection);

  Judge judge_;
  RequestBounds bounds_;
  Doorkeeper keeper_;
};

}  // namespace overbend
