#include "eyebridge/bridges/io7/command_table.hpp"

#include <algorithm>

#include "opcodes.h"

namespace eyebridge::bridges::io7 {
namespace {

constexpr Field kMotor{"motor", IO7_MOTOR_FIRST, IO7_MOTOR_LAST};
constexpr Field kServo{"servo", IO7_SERVO_FIRST, IO7_SERVO_LAST};
constexpr Field kPort{"port", IO7_PORT_FIRST, IO7_PORT_LAST};
constexpr Field kAdc{"ADC value", 0, IO7_ADC_LAST, 2};

constexpr Field gain(std::string_view name) { return {name, IO7_GAIN_FIRST, IO7_GAIN_LAST}; }
constexpr Field limit(std::string_view name) {
  return {name, IO7_SERVO_LIMIT_FIRST, IO7_SERVO_LIMIT_LAST};
}
constexpr Field word(std::string_view name) { return {name, IO7_WORD_FIRST, IO7_WORD_LAST, 2}; }

template <std::size_t N>
struct List {
  std::array<Field, N> fields;
};
template <class... Fields>
constexpr List<sizeof...(Fields)> fields(Fields... list) {
  return {{list...}};
}

/// A row: what is sent, then what is answered.
template <std::size_t Arguments, std::size_t Values>
constexpr Command row(char letter, std::string_view name, List<Arguments> arguments,
                      List<Values> values) {
  Command command{.letter = letter, .name = name};
  std::copy(arguments.fields.begin(), arguments.fields.end(), command.argument_fields.begin());
  std::copy(values.fields.begin(), values.fields.end(), command.value_fields.begin());
  command.argument_count = Arguments;
  command.value_count = Values;
  command.reply = Values == 0 ? ReplyKind::None : ReplyKind::Values;
  return command;
}

constexpr Command answered_by(ReplyKind reply, Command command) {
  command.reply = reply;
  return command;
}
constexpr Command guessed(Command command) {
  command.documented = false;
  return command;
}

constexpr auto kNothing = fields();
constexpr Field kPortMode{"mode", 0, 127, 1, true};

constexpr Command kCommands[] = {
    answered_by(ReplyKind::List, row(IO7_HELP, "help", kNothing, kNothing)),
    row(IO7_OUTPUT, "output mode", fields(Field{"verbose", 0, 1}), kNothing),
    row(IO7_MOTOR, "motor", fields(kMotor, Field{"duty in percent", IO7_DUTY_FIRST, IO7_DUTY_LAST}),
        kNothing),
    row(IO7_MOTOR_SPEED, "motor speed",
        fields(kMotor, Field{"ticks per 10 ms", IO7_TICKS_FIRST, IO7_TICKS_LAST}), kNothing),
    row(IO7_PID, "PID", fields(kMotor, gain("p"), gain("i"), gain("d")), kNothing),
    row(IO7_SERVO, "servo",
        fields(kServo, Field{"position", IO7_SERVO_POSITION_FIRST, IO7_SERVO_POSITION_LAST}),
        kNothing),
    row(IO7_SERVO_LIMITS, "servo limits", fields(kServo, limit("lower"), limit("upper")), kNothing),
    row(IO7_PSD, "PSD", fields(Field{"sensor", IO7_PSD_FIRST, IO7_PSD_LAST}), fields(kAdc)),
    row(IO7_ENCODER, "encoder", fields(Field{"encoder", IO7_ENCODER_FIRST, IO7_ENCODER_LAST}),
        fields(Field{"counter", 0, IO7_COUNTER_LAST, 2})),
    answered_by(ReplyKind::Version, row(IO7_VERSION, "version", kNothing, kNothing)),
    row(IO7_VOLTAGE, "voltage", kNothing, fields(Field{"10 mV", 0, IO7_VOLTAGE_LAST, 2})),
    row(IO7_DIGITAL_IN, "digital in", fields(kPort), fields(Field{"bit", 0, 1})),
    row(IO7_DIGITAL_IN_ALL, "all digital in", kNothing, fields(Field{"bits", 0, 0xFFFF, 2})),
    row(IO7_DIGITAL_OUT, "digital out", fields(kPort, Field{"bit", 0, 1}), kNothing),
    row(IO7_PORT_CONFIG, "port config", fields(kPort, kPortMode), kNothing),
    row(IO7_ANALOG, "analog in", fields(Field{"port", IO7_ANALOG_FIRST, IO7_ANALOG_LAST}),
        fields(kAdc)),
    guessed(row(IO7_VW_SET_SPEED, "set speed", fields(word("mm/s"), word("deg/s")), kNothing)),
    guessed(row(IO7_VW_GET_SPEED, "get speed", kNothing, fields(word("mm/s"), word("deg/s")))),
    guessed(row(IO7_VW_GET_POSE, "get pose", kNothing, fields(word("x"), word("y"), word("phi")))),
    guessed(row(IO7_VW_SET_POSE, "set pose", fields(word("x"), word("y"), word("phi")), kNothing)),
    guessed(row(IO7_VW_STRAIGHT, "straight", fields(word("mm/s"), word("distance")), kNothing)),
    guessed(row(IO7_VW_TURN, "turn", fields(word("deg/s"), word("angle")), kNothing)),
    guessed(row(IO7_VW_CURVE, "curve", fields(word("distance"), word("angle"), word("mm/s")),
                kNothing)),
    guessed(row(IO7_VW_REMAINING, "remaining", kNothing, fields(word("mm")))),
    guessed(row(IO7_VW_DONE, "done", kNothing, fields(Field{"state", -1, 1}))),
};

}  // namespace

std::size_t Command::raw_reply_length() const {
  if (reply == ReplyKind::Version) return IO7_VERSION_LENGTH;
  std::size_t length = 0;
  for (const Field& field : values()) length += field.width;
  return length;
}

std::span<const Command> commands() { return kCommands; }

const Command* find_command(char letter) {
  const auto* found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                   [letter](const Command& row) { return row.letter == letter; });
  return found == std::end(kCommands) ? nullptr : found;
}

}  // namespace eyebridge::bridges::io7
