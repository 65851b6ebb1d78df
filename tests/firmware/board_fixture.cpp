#include "board_fixture.hpp"

#include <algorithm>
#include <cmath>

#include "golden.hpp"

namespace eyebridge::firmware {

eb_config config_with(const std::function<void(eb_config&)>& change) {
  eb_config config;
  eb_config_default(&config);
  if (change) change(config);
  return config;
}

BoardUnderTest::BoardUnderTest(const eb_config& config) {
  eb_board_init(&board, &config, nullptr);
  board.pins.supply_cv = 740;
}

std::string BoardUnderTest::ask(std::string_view bytes) {
  eb_board_receive(&board, reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  std::string answer(EB_REPLY + 1, '\0');
  answer.resize(
      eb_board_transmit(&board, reinterpret_cast<std::uint8_t*>(answer.data()), answer.size()));
  return answer;
}

void BoardUnderTest::wait_us(std::uint32_t us, const std::function<void()>& each) {
  while (us > 0) {
    const std::uint32_t piece = std::min<std::uint32_t>(us, 10'000);
    eb_board_process(&board, piece);
    us -= piece;
    if (each) each();
  }
}

void BoardUnderTest::send(std::string_view frame) {
  const eb_can_frame sent = frame_of(frame);
  eb_board_can_receive(&board, &sent);
}

std::vector<std::string> BoardUnderTest::frames() {
  std::vector<std::string> all;
  for (eb_can_frame frame; eb_board_can_transmit(&board, &frame);) all.push_back(text_of(frame));
  return all;
}

void BoardUnderTest::enable() {
  frames();
  send("70F#05");
  send(std::string("000#010") + "0123456789ABCDEF"[board.node.id]);
  frames();
}

std::string text_of(const eb_can_frame& frame) {
  constexpr char kHex[] = "0123456789ABCDEF";
  std::string text;
  for (const int shift : {8, 4, 0}) text += kHex[frame.id >> shift & 0xF];
  text += frame.fd ? "##1" : "#";
  for (int i = 0; i < frame.length; ++i) {
    text += kHex[frame.data[i] >> 4];
    text += kHex[frame.data[i] & 0xF];
  }
  return text;
}

eb_can_frame frame_of(std::string_view text) {
  eb_can_frame frame{};
  frame.remote = text.ends_with("#R");
  const bridges::CanFrame read =
      bridges::test::frame_from_text(frame.remote ? text.substr(0, text.size() - 1) : text);
  frame.id = static_cast<std::uint16_t>(read.id);
  frame.fd = read.fd;
  frame.length = read.length;
  std::copy(read.data.begin(), read.data.end(), frame.data);
  return frame;
}

void Plant::step(eb_board& board) {
  for (int i = 0; i < EB_MOTORS; ++i) {
    const double end = held ? 0.0 : full_ticks * board.pins.duty[i] / EB_DUTY_FULL;
    const double kept = lag > 0.0 && !held ? std::exp(-0.01 / lag) : 0.0;
    const double before = speed[i];
    speed[i] = end + (before - end) * kept;
    travel[i] += lag > 0.0 && !held ? end + (before - end) * lag * (1 - kept) / 0.01 : speed[i];
    board.pins.encoder[i] = static_cast<std::uint16_t>(std::llround(travel[i]));
  }
}

}  // namespace eyebridge::firmware
