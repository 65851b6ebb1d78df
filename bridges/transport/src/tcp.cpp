#include "eyebridge/bridges/tcp.hpp"

#include <optional>
#include <utility>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>

#include "eyebridge/base/unique_fd.hpp"
#include "eyebridge/bridges/fd_stream.hpp"

namespace eyebridge::bridges {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// Looks up and connects on its own io_context, so that one deadline covers both.
class Connector {
 public:
  explicit Connector(const TcpSettings& settings) : settings_(settings) {}

  /// No value: not finished in time.
  std::optional<error_code> run() {
    resolver_.async_resolve(settings_.host, std::to_string(settings_.port),
                            tcp::resolver::numeric_service,
                            [this](const error_code& error, const tcp::resolver::results_type& to) {
                              unknown_host_ = bool(error);
                              result_ = error;
                              if (!error) connect(to);
                            });
    context_.run_for(settings_.connect_timeout);
    return result_;
  }

  tcp::socket& socket() { return socket_; }
  [[nodiscard]] bool unknown_host() const { return unknown_host_; }

 private:
  void connect(const tcp::resolver::results_type& to) {
    result_.reset();
    asio::async_connect(socket_, to,
                        [this](const error_code& error, const auto&) { result_ = error; });
  }

  const TcpSettings& settings_;
  asio::io_context context_{1};
  tcp::resolver resolver_{context_};
  tcp::socket socket_{context_};
  std::optional<error_code> result_;
  bool unknown_host_ = false;
};

}  // namespace

Result<std::unique_ptr<ByteStream>> open_tcp(const TcpSettings& settings, Clock& clock) {
  const bool is_ipv6 = settings.host.find(':') != std::string::npos;
  const std::string name =
      (is_ipv6 ? "[" + settings.host + "]" : settings.host) + ":" + std::to_string(settings.port);
  Connector connector(settings);
  const std::optional<error_code> result = connector.run();
  if (!result) {
    return fail(Errc::Timeout, name + ": no answer within " +
                                   std::to_string(settings.connect_timeout.count()) +
                                   " ms; expected a board or firmware that listens there");
  }
  if (connector.unknown_host()) {
    return fail(Errc::Disconnected, name + ": unknown host: " + result->message());
  }
  error_code error = *result;
  if (error == asio::error::connection_refused) {
    return fail(Errc::Disconnected,
                name + ": connection refused; expected a board or firmware that listens there");
  }
  // Small requests would otherwise wait for the acknowledgement of the one before.
  if (!error) connector.socket().set_option(tcp::no_delay(true), error);
  UniqueFd fd(error ? -1 : connector.socket().release(error));
  if (error) return fail(Errc::Disconnected, name + ": cannot connect: " + error.message());
  return make_fd_stream(std::move(fd), name, clock);
}

}  // namespace eyebridge::bridges
