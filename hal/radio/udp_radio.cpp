#include "radio/udp_radio.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <map>
#include <mutex>
#include <random>
#include <system_error>
#include <thread>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <sys/socket.h>

#include "eyebridge/base/unique_fd.hpp"
#include "radio/radio_datagram.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;
using Kind = RadioDatagram::Kind;
using WallTime = std::chrono::steady_clock::time_point;

constexpr auto kBeacon = 1s;
constexpr auto kGone = 3s;
constexpr auto kAnswers = 100ms;  // of others to a Hello
constexpr int kSlice = 20;        // milliseconds; how late stop() is noticed

tl::unexpected<Error> no_socket(const RadioSetting& setting, const char* doing) {
  const std::string reason = std::generic_category().message(errno);
  return fail(Errc::Disconnected, "radio udp:" + setting.group + ": " + doing + ": " + reason);
}

sockaddr_in address_of(const std::string& host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  ::inet_pton(AF_INET, host.c_str(), &address.sin_addr);
  return address;
}

template <class Option>
bool set_option(int fd, int level, int name, const Option& value) {
  return ::setsockopt(fd, level, name, &value, sizeof value) == 0;
}

Result<UniqueFd> open_socket(const RadioSetting& setting) {
  UniqueFd fd(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  if (!fd.valid()) return no_socket(setting, "making a socket");
  // All processes of this computer listen at the same port.
  if (!set_option(fd.get(), SOL_SOCKET, SO_REUSEADDR, int{1})) return no_socket(setting, "sharing");
  // To the group alone, so that other traffic to the port is not taken for radio.
  const sockaddr_in group = address_of(setting.group, setting.port);
  if (::bind(fd.get(), reinterpret_cast<const sockaddr*>(&group), sizeof group) != 0) {
    return no_socket(setting, "listening");
  }
  const ip_mreq membership{group.sin_addr, address_of(setting.interface, 0).sin_addr};
  if (!set_option(fd.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, membership) ||
      !set_option(fd.get(), IPPROTO_IP, IP_MULTICAST_IF, membership.imr_interface) ||
      !set_option(fd.get(), IPPROTO_IP, IP_MULTICAST_LOOP, int{1})) {
    return no_socket(setting, "joining the group");
  }
  return fd;
}

class UdpRadio final : public Radio {
 public:
  UdpRadio(const RadioSetting& setting, int id, const RadioErrors& errors, Clock& clock,
           LogSink& log)
      : setting_(setting),
        group_(address_of(setting.group, setting.port)),
        id_(id),
        errors_(errors),
        clock_(clock),
        log_(log) {
    std::random_device device;
    run_ = std::uint64_t{device()} << 32U | device();
  }
  ~UdpRadio() override { (void)stop(); }
  UdpRadio(const UdpRadio&) = delete;
  UdpRadio& operator=(const UdpRadio&) = delete;

  [[nodiscard]] int id() const override { return id_; }

  Result<void> start() override {
    const std::lock_guard switching(switching_);
    if (thread_.joinable()) return {};
    Result<UniqueFd> fd = open_socket(setting_);
    if (!fd) return tl::unexpected(fd.error());
    {
      const std::lock_guard lock(mutex_);
      fd_ = std::move(*fd);
      inbox_.emplace(id_, errors_);
      heard_.clear();
    }
    if (auto said = tell(Kind::Hello); !said) return said;
    thread_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
    // By this name robios knows that it is none of the program's own threads.
    ::pthread_setname_np(thread_.native_handle(), "eb:radio");
    std::this_thread::sleep_for(kAnswers);
    return {};
  }

  Result<void> stop() override {
    const std::lock_guard switching(switching_);
    if (!thread_.joinable()) return {};
    thread_.request_stop();
    thread_.join();
    (void)tell(Kind::Bye);
    const std::lock_guard lock(mutex_);
    fd_.reset();
    inbox_.reset();
    return {};
  }

  Result<void> send(int receiver, const std::string& text) override {
    if (auto good = check_message(receiver, text); !good) return good;
    RadioDatagram datagram{Kind::Message, static_cast<std::uint8_t>(id_), 0, run_, text};
    if (receiver != kEveryone) datagram.receiver = static_cast<std::uint8_t>(receiver);
    if (receiver == id_) {
      const std::lock_guard lock(mutex_);
      if (!inbox_) return radio_is_off();
      inbox_->add({id_, text}, clock_.now());
      return {};
    }
    return tell(datagram);
  }

  Result<std::optional<RadioMessage>> receive() override {
    const std::lock_guard lock(mutex_);
    if (!inbox_) return radio_is_off();
    return inbox_->take(clock_.now());
  }

  Result<std::vector<int>> robots() override {
    const std::lock_guard lock(mutex_);
    if (!inbox_) return radio_is_off();
    const WallTime now = std::chrono::steady_clock::now();
    std::erase_if(heard_, [&](const auto& entry) { return now - entry.second > kGone; });
    std::vector<int> ids{id_};
    for (const auto& [id, when] : heard_) ids.push_back(id);
    std::sort(ids.begin(), ids.end());
    return ids;
  }

 private:
  Result<void> tell(Kind kind) {
    return tell(RadioDatagram{kind, static_cast<std::uint8_t>(id_), 0, run_, {}});
  }

  Result<void> tell(const RadioDatagram& datagram) {
    const std::vector<std::uint8_t> bytes = encode(datagram);
    const std::lock_guard lock(mutex_);
    if (!fd_.valid()) return radio_is_off();
    // A full buffer loses the message, as the air does.
    if (::sendto(fd_.get(), bytes.data(), bytes.size(), 0,
                 reinterpret_cast<const sockaddr*>(&group_), sizeof group_) < 0 &&
        errno != EAGAIN && errno != ENOBUFS) {
      return no_socket(setting_, "sending");
    }
    return {};
  }

  void listen(const std::stop_token& stop) {
    WallTime next = std::chrono::steady_clock::now() + kBeacon;
    std::array<std::uint8_t, 2048> buffer{};
    pollfd entry{fd_.get(), POLLIN, 0};
    while (!stop.stop_requested()) {
      (void)::poll(&entry, 1, kSlice);
      for (ssize_t count = 0; (count = ::recv(entry.fd, buffer.data(), buffer.size(), 0)) > 0;) {
        if (const auto datagram = decode_radio({buffer.data(), static_cast<std::size_t>(count)})) {
          take(*datagram);
        }
      }
      if (std::chrono::steady_clock::now() < next) continue;
      next += kBeacon;
      (void)tell(Kind::Here);
    }
  }

  void take(const RadioDatagram& datagram) {
    if (datagram.run == run_) return;
    if (datagram.sender == id_) return warn_of_twin();
    if (datagram.kind == Kind::Hello) (void)tell(Kind::Here);
    const std::lock_guard lock(mutex_);
    if (datagram.kind == Kind::Bye) {
      heard_.erase(datagram.sender);
      return;
    }
    heard_[datagram.sender] = std::chrono::steady_clock::now();
    const bool is_meant = datagram.receiver == 0 || datagram.receiver == id_;
    if (datagram.kind == Kind::Message && is_meant) {
      inbox_->add({datagram.sender, datagram.text}, clock_.now());
    }
  }

  void warn_of_twin() {
    if (std::exchange(warned_, true)) return;
    log_.write(Severity::Warning, "radio: another robot has the number " + std::to_string(id_) +
                                      ", too; expected a number of its own, --radio '…?id=2'");
  }

  const RadioSetting setting_;
  const sockaddr_in group_;
  const int id_;
  const RadioErrors errors_;
  Clock& clock_;
  LogSink& log_;
  std::uint64_t run_ = 0;
  bool warned_ = false;  // only the thread's

  std::mutex switching_;  // taken before mutex_
  std::mutex mutex_;
  UniqueFd fd_;
  std::optional<RadioInbox> inbox_;  ///< While it is on.
  std::map<int, WallTime> heard_;
  std::jthread thread_;
};

}  // namespace

std::unique_ptr<Radio> make_udp_radio(const RadioSetting& setting, int id,
                                      const RadioErrors& errors, Clock& clock, LogSink& log) {
  return std::make_unique<UdpRadio>(setting, id, errors, clock, log);
}

}  // namespace eyebridge::hal
