#include "eb_board.h"

#include <string.h>

#include "eb_math.h"
#include "opcodes.h"

#define PERIOD_US 10000U
#define DEMO_STRAIGHT_US 1500000U
#define DEMO_TURN_US 2500000U

static const struct eb_config default_config = {
    {false, false, false, false, false, "", "\r\n", "1.04", 0},
    {6484.0F, 0.09F, 0.6F, 5.2359878F, 1.0F, 10.0F, 0.0F, 110.0F, 2000000U},
    300000U,
    600U,
    0,
    false,
    false,
    0,
    0};

void eb_config_default(struct eb_config* config) { *config = default_config; }

void eb_board_init(struct eb_board* board, const struct eb_config* config,
                   const struct eb_pins* pins) {
  int i;
  /* The caller's structs may be the board's own: a reset. */
  const struct eb_config kept = *config;
  struct eb_pins at;
  memset(&at, 0, sizeof at);
  if (pins != 0) at = *pins;
  memset(board, 0, sizeof *board);
  board->config = kept;
  board->pins = at;
  eb_motors_init(&board->motors, kept.drive.full_ticks, &at);
  eb_drive_init(&board->drive, &kept.drive);
  eb_io7_init(&board->io7, &kept);
  eb_node_init(&board->node, &kept);
  for (i = 0; i < EB_SERVOS; ++i) {
    board->servo_lower[i] = 100;
    board->servo_upper[i] = 200;
    board->pins.servo_us[i] = 0;
  }
  for (i = 0; i < EB_PORTS; ++i)
    eb_board_port(board, i, i < 8 ? IO7_PORT_PULL_UP : IO7_PORT_OUTPUT);
  board->node.digital_in = eb_board_levels(board);
  eb_board_stop_motors(board);
}

void eb_board_stop_motors(struct eb_board* board) {
  eb_drive_release(&board->drive);
  eb_motors_stop(&board->motors);
  eb_motors_apply(&board->motors, &board->pins);
  board->owner = EB_OWNER_NONE;
}

void eb_board_servo(struct eb_board* board, int index, uint8_t position) {
  const int32_t lower = board->servo_lower[index] * 10;
  const int32_t upper = board->servo_upper[index] * 10;
  board->pins.servo_us[index] = (uint16_t)(lower + (upper - lower) * position / 255);
}

void eb_board_port(struct eb_board* board, int port, int mode) {
  const uint16_t bit = (uint16_t)(1U << port);
  const uint16_t others = (uint16_t)~bit;
  board->digital_outputs &= others;
  board->pull_up &= others;
  board->pull_down &= others;
  if (mode == IO7_PORT_OUTPUT) board->digital_outputs |= bit;
  if (mode == IO7_PORT_PULL_UP) board->pull_up |= bit;
  if (mode == IO7_PORT_PULL_DOWN) board->pull_down |= bit;
  board->pins.digital_outputs = board->digital_outputs;
  board->pins.digital_out = board->digital_out & board->digital_outputs;
}

uint16_t eb_board_levels(const struct eb_board* board) {
  /* An output reads as itself; what nothing drives floats to its resistor, or reads 0. */
  const uint16_t driven = board->pins.digital_driven;
  const uint16_t in =
      (uint16_t)((board->pins.digital_in & driven) | (board->pull_up & (uint16_t)~driven));
  return (uint16_t)((board->digital_out & board->digital_outputs) |
                    (in & (uint16_t)~board->digital_outputs));
}

void eb_board_levels_out(struct eb_board* board, uint16_t ports, uint16_t levels) {
  board->digital_out = (uint16_t)((board->digital_out & ~ports) | (levels & ports));
  board->pins.digital_out = board->digital_out & board->digital_outputs;
}

static bool motors_run(const struct eb_board* board) {
  int i;
  for (i = 0; i < EB_MOTORS; ++i) {
    const struct eb_motor* motor = &board->motors.motor[i];
    if (motor->duty != 0 || (motor->controlled && motor->target_q8 != 0)) return true;
  }
  return board->drive.move_state == EYECAN_MOVE_RUNNING ||
         board->drive.move_state == EYECAN_MOVE_SPEED;
}

static void watchdog(struct eb_board* board) {
  if (motors_run(board)) ++board->watchdogs;
  eb_board_stop_motors(board);
}

static void demo(struct eb_board* board, uint32_t elapsed_us) {
  const bool turning = board->demo_us >= DEMO_STRAIGHT_US;
  board->demo_us += elapsed_us;
  if (board->demo_us >= DEMO_TURN_US) {
    eb_board_stop_motors(board);
    return;
  }
  if (turning || board->demo_us < DEMO_STRAIGHT_US) return;
  eb_motors_set_duty(&board->motors, 0, -EB_DEMO_DUTY);
  eb_motors_set_duty(&board->motors, 1, EB_DEMO_DUTY);
  eb_motors_apply(&board->motors, &board->pins);
}

static void time_piece(struct eb_board* board, uint32_t elapsed_us) {
  board->uptime_us += elapsed_us;
  eb_io7_quiet(&board->io7, elapsed_us);
  if (board->owner == EB_OWNER_DEMO) demo(board, elapsed_us);
  if (board->silent_us < 0x7FFFFFFFU) board->silent_us += elapsed_us;
  if (board->owner == EB_OWNER_SERIAL && board->config.silence_us > 0 &&
      board->silent_us >= board->config.silence_us) {
    watchdog(board);
  }
  board->period_us += elapsed_us;
  if (board->period_us >= PERIOD_US) {
    board->period_us = 0;
    eb_motors_sample(&board->motors, &board->pins);
    eb_drive_period(&board->drive, &board->motors);
    eb_motors_control(&board->motors, &board->pins);
  }
  eb_node_time(board, elapsed_us);
}

void eb_board_process(struct eb_board* board, uint32_t elapsed_us) {
  while (elapsed_us > 0) {
    const uint32_t rest = PERIOD_US - board->period_us;
    const uint32_t piece = elapsed_us < rest ? elapsed_us : rest;
    time_piece(board, piece);
    elapsed_us -= piece;
  }
}

void eb_board_receive(struct eb_board* board, const uint8_t* bytes, size_t count) {
  size_t i;
  for (i = 0; i < count; ++i) {
    struct eb_request request;
    switch (eb_io7_push(&board->io7, bytes[i], &request)) {
      case EB_FOUND_NOTHING:
        break;
      case EB_FOUND_REQUEST:
        board->silent_us = 0;
        eb_board_run(board, &request);
        break;
      case EB_FOUND_EMPTY_LINE:
        if (board->io7.prompt[0] != 0) {
          eb_io7_say(&board->io7, "");
          eb_io7_prompt(&board->io7, true);
        }
        break;
      case EB_FOUND_ERROR:
        if (board->io7.verbose) eb_io7_say(&board->io7, "error: h lists the commands");
        eb_io7_prompt(&board->io7, false);
        break;
    }
  }
}

size_t eb_board_transmit(struct eb_board* board, uint8_t* out, size_t room) {
  return eb_io7_take(&board->io7, out, room);
}

void eb_board_link_lost(struct eb_board* board) {
  eb_io7_reset(&board->io7);
  if (board->owner == EB_OWNER_SERIAL || board->owner == EB_OWNER_DEMO) watchdog(board);
}
