#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "board/board_link.hpp"
#include "board/tick_counter.hpp"
#include "eyebridge/base/clock.hpp"
#include "eyebridge/bridges/client/io7_client.hpp"

namespace eyebridge::hal {

/// A board that speaks IO7, over any line of bytes.
class Io7Link final : public BoardLink {
 public:
  /// `client` is connected; `clock`, the one of its lines, must outlive this. Reads every encoder
  /// of `tables` once, and tells the servos' limits.
  Io7Link(std::unique_ptr<bridges::Io7Client> client, Clock& clock, const BoardTables& tables);

  [[nodiscard]] bool has_motor(int id) const override;
  [[nodiscard]] bool has_speed_control() const override { return letters_.has(IO7_MOTOR_SPEED); }
  [[nodiscard]] bool has_encoder(int id) const override;
  [[nodiscard]] bool has_servo(int id) const override;
  [[nodiscard]] bool has_psd(int id) const override;
  [[nodiscard]] bool has_digital() const override;
  [[nodiscard]] bool has_analog() const override;
  [[nodiscard]] bool has_remote() const override { return false; }  // no letter for it

  Result<void> motor_duty(int id, int percent) override;
  Result<void> motor_speed(int id, int ticks_per_10ms) override;
  Result<void> motor_pid(int id, int p, int i, int d) override;
  Result<BoardCount> encoder(int id) override;
  Result<void> servo(int id, int position) override;
  Result<int> psd_raw(int id) override;
  Result<double> psd_metres(int id) override;
  Result<void> digital_setup(int port, LineMode mode) override;
  Result<bool> digital_in(int port) override;
  Result<std::uint16_t> digital_in_all() override;
  Result<void> digital_out(int port, bool high) override;
  Result<int> analog(int channel) override;
  Result<double> supply_voltage() override;
  Result<std::string> version() override;
  Result<int> remote_key() override;
  /// By the v-omega letters, when the profile allows them and the board lists all of them.
  std::unique_ptr<DriveController> make_drive(const BoardDriveShape& shape) override;
  Result<void> stop() override { return client_->confirm_stop(); }
  void look_after() override;
  [[nodiscard]] std::uint32_t generation() const override { return client_->generation(); }

  /// The bridge below, for statistics.
  [[nodiscard]] bridges::Io7Client& client() { return *client_; }

 private:
  static constexpr std::size_t kEncoders = IO7_ENCODER_LAST;
  struct Gains {
    int p = 0, i = 0, d = 0;
  };

  /// `asked`, when not null, becomes the time at which the question that was answered went out.
  Result<int> ask(const bridges::io7::Request& request, Time* asked = nullptr);
  Result<void> tell(const bridges::io7::Request& request);
  struct Reading {
    std::uint16_t count = 0;
    Time asked{0};
  };
  Result<Reading> plausible_count(int id, Time now);  // under counting_
  void tell_parameters();
  /// The encoder that nobody has read for longest, and for too long; 0: none.
  int longest_unread();

  const std::unique_ptr<bridges::Io7Client> client_;
  Clock& clock_;
  const BoardTables tables_;
  const bridges::io7::LetterSet letters_;
  bool vw_letters_ = false;
  double fastest_ = 0;  ///< Ticks per second that no wheel exceeds.

  std::mutex counting_;
  std::array<TickCounter, kEncoders> counters_;
  std::array<Time, kEncoders> counted_{};
  std::mutex parameters_;
  std::array<std::optional<Gains>, IO7_MOTOR_LAST> gains_;
  // Only the thread that looks after the link:
  std::uint32_t told_generation_ = 0;
  std::array<Time, kEncoders> tried_{};
};

}  // namespace eyebridge::hal
