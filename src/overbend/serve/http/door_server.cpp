#include "serve/http/door_server.h"

#include <unistd.h>

#include <condition_variable>
#include <mutex>
#include <system_error>
#include <thread>

namespace overbend {
namespace {

/// Of the connection that a thread serves: how many came before it.
thread_local std::uint64_t arrival_here = 0;

/// A thread for each connection: none waits for the slowness of another. The doorkeeper bounds their number; some more
/// are those that are being sent away.
class ThreadPerConnection : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> serve) override {
    {
      std::unique_lock<std::mutex> hold(mutex_);
      changed_.wait(hold, [&] { return running_ < kMost; });
      ++running_;
    }
    const auto run = [this, serve = std::move(serve), arrival = arrivals_++] {
      arrival_here = arrival;
      serve();
      const std::lock_guard<std::mutex> hold(mutex_);
      --running_;
      changed_.notify_all();
    };
    try {
      std::thread(run).detach();
    } catch (const std::system_error&) {
      run();  // the system has no more threads: this one first, then the next
    }
  }

  void shutdown() override {
    std::unique_lock<std::mutex> hold(mutex_);
    changed_.wait(hold, [&] { return running_ == 0; });
  }

 private:
  static constexpr std::size_t kMost = Doorkeeper::kMostVisitors + 64;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t running_ = 0;
  std::uint64_t arrivals_ = 0;  ///< Told by one thread, that which accepts.
};

/// Size of the body according to the header; anything else is rejected.
std::uint64_t body_size(const httplib::Request& request) {
  return request.has_header("Content-Length") ? request.get_header_value<std::uint64_t>("Content-Length") : 0;
}

}  // namespace

DoorServer::DoorServer(Judge judge, const RequestBounds& bounds) : judge_(std::move(judge)), bounds_(bounds) {
  new_task_queue = [] { return new ThreadPerConnection; };
}

/// One request and its answer. False when none can follow on this connection.
bool DoorServer::serve_request(Doorkeeper::Visit& visit, Connection& connection) {
  bool understood = false, close = false;
  const auto head_read = [&](httplib::Request& request) {
    understood = true;
    const Standing standing = judge_(request);
    if (standing == Standing::known) visit.trust();
    connection.expect_body(body_size(request));
    if (standing != Standing::refused) return;
    // Its body, if there is one, is left where it is, so the connection ends with the answer, which says so.
    request.headers.erase("Connection");
    request.set_header("Connection", "close");
    close = true;
  };
  const bool answered = process_request(connection, false, close, head_read);
  return answered && understood && !close && connection.unread() == 0;
}

void DoorServer::widen() {
  ::listen(svr_sock_, SOMAXCONN);
}

void DoorServer::serve(Doorkeeper::Visit& visit, Connection& connection) {
  while (svr_sock_ != INVALID_SOCKET && connection.wait_for_request()) {
    if (serve_request(visit, connection)) continue;
    connection.drain();
    return;
  }
}

bool DoorServer::process_and_close_socket(int socket) {
  {
    Doorkeeper::Visit visit(keeper_, socket, arrival_here);
    Connection connection(socket, bounds_);
    serve(visit, connection);
    ::shutdown(socket, SHUT_RDWR);
  }
  ::close(socket);
  return true;
}

}  // namespace overbend
