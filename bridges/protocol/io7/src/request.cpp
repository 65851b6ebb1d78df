#include "eyebridge/bridges/io7/request.hpp"

#include <algorithm>
#include <charconv>
#include <string>

#include "text.hpp"

namespace eyebridge::bridges::io7 {
namespace {

std::string name_of(const Command& command) {
  return "IO7 " + std::string(command.name) + " ('" + command.letter + "')";
}

bool accepts(const Field& field, int value) {
  if (!field.letter) return value >= field.first && value <= field.last;
  return value == IO7_PORT_INPUT || value == IO7_PORT_OUTPUT || value == IO7_PORT_PULL_UP ||
         value == IO7_PORT_PULL_DOWN;
}

tl::unexpected<Error> out_of_range(const Command& command, const Field& field, int value) {
  const std::string expected =
      field.letter ? "one of i, o, I, J"
                   : std::to_string(field.first) + " to " + std::to_string(field.last);
  return fail(Errc::OutOfRange, name_of(command) + ": " + std::string(field.name) + " is " +
                                    std::to_string(value) + "; expected " + expected);
}

/// Empty when the arguments are as the table wants them. Succeeding costs no allocation.
Result<void> check(const Command& command, const Request& request) {
  if (request.count != command.argument_count) {
    return fail(Errc::OutOfRange, name_of(command) + ": " + std::to_string(request.count) +
                                      " arguments; expected " +
                                      std::to_string(command.argument_count));
  }
  for (std::size_t i = 0; i < request.count; ++i) {
    const Field& field = command.argument_fields[i];
    if (!accepts(field, request.arguments[i])) {
      return out_of_range(command, field, request.arguments[i]);
    }
  }
  return {};
}

void put(RequestBytes& out, std::uint8_t byte) { out.bytes[out.length++] = byte; }

void put_ascii(RequestBytes& out, const Field& field, int value) {
  put(out, ' ');
  if (field.letter) return put(out, static_cast<std::uint8_t>(value));
  char digits[12];
  const auto end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  for (const char* digit = digits; digit != end; ++digit) {
    put(out, static_cast<std::uint8_t>(*digit));
  }
}

void put_binary(RequestBytes& out, const Field& field, int value, ByteOrder order) {
  const auto bits = static_cast<unsigned>(value);
  const auto low = static_cast<std::uint8_t>(bits & 0xFFU);
  const auto high = static_cast<std::uint8_t>((bits >> 8U) & 0xFFU);
  if (field.width == 1) return put(out, low);
  put(out, order == ByteOrder::MsbFirst ? high : low);
  put(out, order == ByteOrder::MsbFirst ? low : high);
}

bool read_ascii(const Command& command, std::string_view text, Request& request) {
  for (const Field& field : command.arguments()) {
    if (text.size() < 2 || text.front() != ' ') return false;
    text.remove_prefix(1);
    int value = 0;
    if (field.letter) {
      value = static_cast<unsigned char>(text.front());
      text.remove_prefix(1);
    } else {
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
      if (error != std::errc{}) return false;
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    }
    request.arguments[request.count++] = value;
  }
  return text.empty();
}

bool read_binary(const Command& command, std::span<const std::uint8_t> bytes, ByteOrder order,
                 Request& request) {
  for (const Field& field : command.arguments()) {
    if (bytes.size() < field.width) return false;
    int value = bytes[0];
    if (field.width == 2) {
      value = order == ByteOrder::MsbFirst ? bytes[0] << 8 | bytes[1] : bytes[1] << 8 | bytes[0];
    }
    if (field.first < 0 && value >= 1 << (8 * field.width - 1)) value -= 1 << (8 * field.width);
    request.arguments[request.count++] = value;
    bytes = bytes.subspan(field.width);
  }
  return bytes.empty();
}

}  // namespace

Result<RequestBytes> encode(const Request& request, const Profile& profile) {
  const Command* command = find_command(request.letter);
  if (command == nullptr || (!command->documented && !profile.vw_letters)) {
    return fail(Errc::Unsupported,
                std::string("IO7 letter '") + request.letter + "' is none that may be sent");
  }
  if (!profile.letters.has(request.letter)) {
    return fail(Errc::Unsupported, name_of(*command) + " is not in this board's command list");
  }
  if (auto good = check(*command, request); !good) return tl::unexpected(std::move(good.error()));

  RequestBytes out;
  put(out, static_cast<std::uint8_t>(request.letter));
  for (std::size_t i = 0; i < request.count; ++i) {
    const Field& field = command->argument_fields[i];
    if (profile.request_form == RequestForm::Ascii) {
      put_ascii(out, field, request.arguments[i]);
    } else {
      put_binary(out, field, request.arguments[i], profile.byte_order);
    }
  }
  if (profile.request_form == RequestForm::Ascii) {
    for (const std::uint8_t byte : bytes_of(profile.terminator)) put(out, byte);
  }
  return out;
}

Result<Request> decode_request(std::span<const std::uint8_t> bytes, const Profile& profile) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto corrupt = [text] {
    return fail(Errc::Corrupt, "this is no IO7 request: " + quoted(text));
  };
  const Command* command = text.empty() ? nullptr : find_command(text.front());
  if (command == nullptr) return corrupt();
  Request request{.letter = command->letter};
  if (profile.request_form == RequestForm::Ascii) {
    const auto end = bytes_of(profile.terminator);
    if (bytes.size() <= end.size() ||
        !std::equal(end.begin(), end.end(),
                    bytes.end() - static_cast<std::ptrdiff_t>(end.size()))) {
      return corrupt();
    }
    if (!read_ascii(*command, text.substr(1, text.size() - 1 - end.size()), request)) {
      return corrupt();
    }
  } else if (!read_binary(*command, bytes.subspan(1), profile.byte_order, request)) {
    return corrupt();
  }
  if (!check(*command, request)) return corrupt();
  return request;
}

}  // namespace eyebridge::bridges::io7
