#include "eb_board.h"
#include "eb_math.h"
#include "opcodes.h"

static void one(struct eb_board* board, int32_t value, int width) {
  eb_io7_numbers(&board->io7, &value, 1, width);
}

static void word(struct eb_board* board, uint16_t value) { one(board, value, 2); }

/* An ADC port that nothing is connected to is held at 0. */
static uint16_t psd(const struct eb_board* board, int index) {
  const uint16_t raw = board->pins.psd[index];
  return raw == EB_PSD_ABSENT ? 0 : raw;
}

/* A serial host takes the motors wheel by wheel. Whoever had them before leaves them standing. */
static void own_wheels(struct eb_board* board) {
  if (board->owner != EB_OWNER_SERIAL || board->drive.active) eb_board_stop_motors(board);
  board->owner = EB_OWNER_SERIAL;
}
/* By v and omega: the ramp starts from the speed that there is. */
static void own_drive(struct eb_board* board) {
  if (board->owner == EB_OWNER_DEMO) eb_board_stop_motors(board);
  board->owner = EB_OWNER_SERIAL;
}

static void start_demo(struct eb_board* board) {
  own_wheels(board);
  board->owner = EB_OWNER_DEMO;
  board->demo_us = 0;
  ++board->demos;
  eb_motors_set_duty(&board->motors, 0, EB_DEMO_DUTY);
  eb_motors_set_duty(&board->motors, 1, EB_DEMO_DUTY);
  eb_motors_apply(&board->motors, &board->pins);
  eb_io7_say(&board->io7, "demo");
}

static int32_t metres_to_mm(float metres) {
  return eb_clamp(eb_round(metres * 1000.0F), IO7_WORD_FIRST, IO7_WORD_LAST);
}

static int32_t radians_to_deg(float radians) {
  return eb_clamp(eb_round(radians / EB_DEGREE), IO7_WORD_FIRST, IO7_WORD_LAST);
}

static float metres(int32_t mm) { return (float)mm * 0.001F; }
static float radians(int32_t deg) { return (float)deg * EB_DEGREE; }

static void send_pose(struct eb_board* board) {
  const int32_t cdeg = eb_drive_heading_cdeg(&board->drive);
  int32_t values[3];
  values[0] = eb_clamp(eb_drive_x_mm(&board->drive), IO7_WORD_FIRST, IO7_WORD_LAST);
  values[1] = eb_clamp(eb_drive_y_mm(&board->drive), IO7_WORD_FIRST, IO7_WORD_LAST);
  values[2] = (cdeg + (cdeg < 0 ? -50 : 50)) / 100;
  eb_io7_numbers(&board->io7, values, 3, 2);
}

static void send_speed(struct eb_board* board) {
  int32_t values[2];
  values[0] = metres_to_mm(eb_drive_linear(&board->drive));
  values[1] = radians_to_deg(eb_drive_angular(&board->drive));
  eb_io7_numbers(&board->io7, values, 2, 2);
}

/* How the last move stands. */
static int32_t progress(const struct eb_drive* drive) {
  if (drive->move_state == EYECAN_MOVE_RUNNING) return 0;
  return drive->move_state == EYECAN_MOVE_ABORTED ? -1 : 1;
}

static void run_drive(struct eb_board* board, char letter, const int32_t* a) {
  struct eb_drive* drive = &board->drive;
  switch (letter) {
    case IO7_VW_SET_SPEED:
      own_drive(board);
      eb_drive_speed(drive, metres(a[0]), radians(a[1]));
      break;
    case IO7_VW_STRAIGHT:
      own_drive(board);
      eb_drive_move(drive, metres(a[1]), 0.0F, metres(a[0]));
      break;
    case IO7_VW_TURN:
      own_drive(board);
      eb_drive_move(drive, 0.0F, radians(a[1]), radians(a[0]));
      break;
    case IO7_VW_CURVE:
      own_drive(board);
      eb_drive_move(drive, metres(a[0]), radians(a[1]), metres(a[2]));
      break;
    case IO7_VW_GET_SPEED:
      send_speed(board);
      break;
    case IO7_VW_GET_POSE:
      send_pose(board);
      break;
    case IO7_VW_SET_POSE:
      eb_drive_set_pose(drive, a[0], a[1], a[2] * 100);
      break;
    case IO7_VW_REMAINING:
      one(board, eb_clamp(eb_drive_remaining_mm(drive), 0, IO7_WORD_LAST), 2);
      break;
    case IO7_VW_DONE:
      one(board, progress(drive), 1);
      break;
    default:
      break;
  }
}

static void run_motors(struct eb_board* board, char letter, const int32_t* a) {
  const int motor = (int)a[0] - IO7_MOTOR_FIRST;
  if (letter == IO7_PID) {
    eb_motors_set_gains(&board->motors, motor, (uint8_t)a[1], (uint8_t)a[2], (uint8_t)a[3]);
    return;
  }
  own_wheels(board);
  if (letter == IO7_MOTOR_SPEED) {
    eb_motors_set_speed(&board->motors, motor, a[1] * 256);
  } else {
    eb_motors_set_duty(&board->motors, motor, (int16_t)(a[1] * 100));
    eb_motors_apply(&board->motors, &board->pins);
  }
}

static void run_ports(struct eb_board* board, char letter, const int32_t* a) {
  const uint16_t bit = (uint16_t)(1U << a[0]);
  switch (letter) {
    case IO7_DIGITAL_IN:
      one(board, (eb_board_levels(board) & bit) != 0 ? 1 : 0, 1);
      break;
    case IO7_DIGITAL_OUT:
      eb_board_levels_out(board, bit, a[1] != 0 ? bit : 0);
      break;
    default:
      eb_board_port(board, (int)a[0], (int)a[1]);
      break;
  }
}

static void run_servo_limits(struct eb_board* board, const int32_t* a) {
  const int servo = (int)a[0] - IO7_SERVO_FIRST;
  board->servo_lower[servo] = (uint8_t)a[1];
  board->servo_upper[servo] = (uint8_t)a[2];
}

void eb_board_run(struct eb_board* board, const struct eb_request* request) {
  const int32_t* a = request->argument;
  switch (request->letter) {
    case IO7_HELP:
      eb_io7_help(&board->io7);
      break;
    case IO7_OUTPUT:
      board->io7.verbose = a[0] != 0;
      break;
    case IO7_DEMO:
      start_demo(board);
      break;
    case IO7_MOTOR:
    case IO7_MOTOR_SPEED:
    case IO7_PID:
      run_motors(board, request->letter, a);
      break;
    case IO7_SERVO:
      eb_board_servo(board, (int)a[0] - IO7_SERVO_FIRST, (uint8_t)a[1]);
      break;
    case IO7_SERVO_LIMITS:
      run_servo_limits(board, a);
      break;
    case IO7_PSD:
      word(board, psd(board, (int)a[0] - IO7_PSD_FIRST));
      break;
    case IO7_ENCODER:
      word(board, board->pins.encoder[a[0] - IO7_ENCODER_FIRST]);
      break;
    case IO7_VERSION:
      eb_io7_characters(&board->io7, board->config.io7.version);
      break;
    case IO7_VOLTAGE:
      word(board, board->pins.supply_cv);
      break;
    case IO7_DIGITAL_IN_ALL:
      word(board, eb_board_levels(board));
      break;
    case IO7_DIGITAL_IN:
    case IO7_DIGITAL_OUT:
    case IO7_PORT_CONFIG:
      run_ports(board, request->letter, a);
      break;
    case IO7_ANALOG:
      word(board, board->pins.analog[a[0]]);
      break;
    default:
      run_drive(board, request->letter, a);
      break;
  }
  eb_io7_prompt(&board->io7, request->letter == IO7_HELP);
}
