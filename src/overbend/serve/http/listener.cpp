#include "serve/http/listener.h"

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

namespace overbend {
namespace {

/// Arrival number of the connection that this thread serves.
thread_local std::uint64_t arrival_number = 0;

/// One thread per connection, so that none waits for a slow one. The connection limiter bounds their number; some more
/// belong to connections being closed.
class ThreadPerConnection : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> serve) override {
    {
      std::unique_lock<std::mutex> hold(mutex_);
      changed_.wait(hold, [&] { return running_ < kMaxThreads; });
      ++running_;
    }
    const auto run = [this, serve = std::move(serve), arrival = arrivals_++] {
      arrival_number = arrival;
      serve();
      const std::lock_guard<std::mutex> hold(mutex_);
      --running_;
      changed_.notify_all();
    };
    try {
      std::thread(run).detach();
    } catch (const std::system_error&) {
      run();  // no more threads available: serve it in this thread
    }
  }

  void shutdown() override {
    std::unique_lock<std::mutex> hold(mutex_);
    changed_.wait(hold, [&] { return running_ == 0; });
  }

 private:
  static constexpr std::size_t kMaxThreads = ConnectionLimiter::kMaxConnections + 64;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t running_ = 0;
  std::uint64_t arrivals_ = 0;  ///< Counted by the accepting thread only.
};

/// Returns the size of the body according to the header; requests without a valid size were rejected.
std::uint64_t body_size(const httplib::Request& request) {
  return request.has_header("Content-Length") ? request.get_header_value<std::uint64_t>("Content-Length") : 0;
}

}  // namespace

LimitedServer::LimitedServer(Judge judge, const RequestBounds& bounds) : judge_(std::move(judge)), bounds_(bounds) {
  new_task_queue = [] { return new ThreadPerConnection; };
}

/// Serves one request. Returns false if no further request can follow on this connection.
bool LimitedServer::serve_request(ConnectionLimiter::Registration& registration, Connection& connection) {
  bool understood = false, close = false;
  const auto head_read = [&](httplib::Request& request) {
    understood = true;
    const Standing standing = judge_(request);
    if (standing == Standing::known) registration.set_authenticated();
    connection.expect_body(body_size(request));
    if (standing != Standing::rejected) return;
    // The body, if any, is not read, so the connection must end with this answer.
    request.headers.erase("Connection");
    request.set_header("Connection", "close");
    close = true;
  };
  const bool answered = process_request(connection, false, close, head_read);
  return answered && understood && !close && connection.unread() == 0;
}

void LimitedServer::set_backlog() {
  set_max_backlog(static_cast<Socket>(svr_sock_));
}

void LimitedServer::serve(ConnectionLimiter::Registration& registration, Connection& connection) {
  while (svr_sock_ != INVALID_SOCKET && connection.wait_for_request()) {
    if (serve_request(registration, connection)) continue;
    connection.drain();
    return;
  }
}

bool LimitedServer::process_and_close_socket(socket_t accepted) {
  const auto socket = static_cast<Socket>(accepted);
  {
    ConnectionLimiter::Registration registration(limiter_, socket, arrival_number);
    Connection connection(socket, bounds_);
    serve(registration, connection);
    shut_down(socket);
  }
  close_socket(socket);
  return true;
}

}  // namespace overbend
