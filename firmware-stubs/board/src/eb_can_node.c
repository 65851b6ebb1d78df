#include <string.h>

#include "eb_board.h"
#include "eb_math.h"
#include "opcodes.h"

#define COMMAND_LIMIT_US 250000U
#define HOST_LIMIT_US 300000U
#define ESTOP_LIMIT_US 500000U
#define TWIN_LIMIT_US 1000000U
#define FAULT_GAP_US 20000U
#define FAULT_REPEAT_US 1000000U
#define LONG_AGO_US 0x7FFFFFFFU

static const uint32_t period_us[EB_DUE_COUNT] = {0,      /* EB_DUE_FAULT */
                                                 20000,  /* EB_DUE_POSE */
                                                 20000,  /* EB_DUE_SPEED */
                                                 20000,  /* EB_DUE_ENC12 */
                                                 100000, /* EB_DUE_ENC34 */
                                                 50000,  /* EB_DUE_PSD_A */
                                                 50000,  /* EB_DUE_PSD_B */
                                                 50000,  /* EB_DUE_PSD_RAW */
                                                 50000,  /* EB_DUE_DIGITAL */
                                                 100000, /* EB_DUE_ANALOG_A */
                                                 100000, /* EB_DUE_ANALOG_B */
                                                 100000, /* EB_DUE_STATUS */
                                                 0,      /* EB_DUE_LIDAR_HEADER */
                                                 0,      /* EB_DUE_LIDAR_CHUNK */
                                                 0,      /* EB_DUE_ZONES */
                                                 5000000 /* EB_DUE_VERSION */,
                                                 100000 /* EB_DUE_HEARTBEAT */};

static uint32_t bit_of(int due) { return (uint32_t)1 << due; }

static void later(uint32_t* timer, uint32_t elapsed_us) {
  *timer = *timer > LONG_AGO_US - elapsed_us ? LONG_AGO_US : *timer + elapsed_us;
}

void eb_node_init(struct eb_node* node, const struct eb_config* config) {
  memset(node, 0, sizeof *node);
  node->id = config->node <= EYECAN_NODE_LAST ? config->node : 0;
  node->fd = config->can_fd;
  node->state = EYECAN_STATE_BOOT;
  node->due = bit_of(EB_DUE_HEARTBEAT) | bit_of(EB_DUE_VERSION);
  node->since_us[EB_DUE_FAULT] = LONG_AGO_US;
  node->host_us = node->estop_us = node->twin_us = LONG_AGO_US;
}

static void enter(struct eb_node* node, uint8_t state) {
  if (node->state != state) node->due |= bit_of(EB_DUE_HEARTBEAT);
  node->state = state;
}

/* Motors off, and nothing that was commanded may go on. */
static void leave_operation(struct eb_board* board, uint8_t state) {
  struct eb_node* node = &board->node;
  if (board->owner == EB_OWNER_BUS) {
    ++board->watchdogs;
    eb_board_stop_motors(board);
  }
  node->commanded = false;
  node->raw = false;
  node->timed_out = false;
  enter(node, state);
}

static void event(struct eb_node* node, uint16_t code, uint32_t aux) {
  node->event_code = code;
  node->event_aux = aux & 0xFFFFFFU;
}

/* ---- commands ---- */

static void command_state(struct eb_board* board, const int32_t* v) {
  struct eb_node* node = &board->node;
  if (v[1] != EYECAN_NODE_ALL && v[1] != node->id) return;
  switch (v[0]) {
    case EYECAN_NMT_ENABLE:
      if (node->estop_us < ESTOP_LIMIT_US || node->twin_us < TWIN_LIMIT_US) return;
      if (node->state != EYECAN_STATE_OPERATIONAL) {
        leave_operation(board, EYECAN_STATE_OPERATIONAL);
        node->host_us = 0;
        node->move_known = false;
      }
      node->faults &= (uint16_t) ~(EYECAN_FLAG_ESTOP | EYECAN_FLAG_HOST_LOST |
                                   EYECAN_FLAG_DUPLICATE_NODE | EYECAN_FLAG_COMMAND_TIMEOUT);
      break;
    case EYECAN_NMT_STOP:
      leave_operation(board, EYECAN_STATE_STOPPED);
      break;
    case EYECAN_NMT_STANDBY:
      leave_operation(board, EYECAN_STATE_STANDBY);
      break;
    default: /* EYECAN_NMT_RESET */
      eb_board_stop_motors(board);
      eb_board_init(board, &board->config, &board->pins);
      break;
  }
}

static void take_motors(struct eb_board* board, bool raw, bool repeated) {
  struct eb_node* node = &board->node;
  if (board->owner != EB_OWNER_BUS || (raw && board->drive.active)) eb_board_stop_motors(board);
  board->owner = EB_OWNER_BUS;
  node->raw = raw;
  node->commanded = repeated;
  node->command_us = 0;
  node->timed_out = false;
  node->faults &= (uint16_t)~EYECAN_FLAG_COMMAND_TIMEOUT;
}

static void command_speed(struct eb_board* board, const int32_t* v) {
  take_motors(board, false, true);
  eb_drive_speed(&board->drive, (float)v[0] * 0.001F, (float)v[1] * 0.01F * EB_DEGREE);
}

static void command_move(struct eb_board* board, const int32_t* v) {
  struct eb_node* node = &board->node;
  const float distance = v[0] == EYECAN_VW_TURN ? 0.0F : (float)v[2] * 0.001F;
  const float angle = v[0] == EYECAN_VW_STRAIGHT ? 0.0F : (float)v[3] * 0.1F * EB_DEGREE;
  const bool on_the_spot = distance == 0.0F;
  /* Repeated until its number is echoed: it is executed once. */
  if (node->move_known && node->move_seq == v[1]) return;
  take_motors(board, false, false);
  eb_drive_move(&board->drive, distance, angle,
                on_the_spot ? (float)v[4] * EB_DEGREE : (float)v[4] * 0.001F);
  node->move_known = true;
  node->move_seq = (uint8_t)v[1];
  node->due |= bit_of(EB_DUE_SPEED);
}

static void command_motors(struct eb_board* board, const int32_t* v) {
  int i;
  take_motors(board, true, true);
  for (i = 0; i < EB_MOTORS; ++i) {
    if ((v[4] >> i & 1) == 0) continue;
    if (v[5] == EYECAN_MOTOR_TICKS) {
      eb_motors_set_speed(&board->motors, i, v[i] * 256);
    } else {
      eb_motors_set_duty(&board->motors, i, (int16_t)(v[i] * 100));
    }
  }
  eb_motors_apply(&board->motors, &board->pins);
}

static void command_port(struct eb_board* board, const int32_t* v) {
  static const char modes[] = {IO7_PORT_INPUT, IO7_PORT_OUTPUT, IO7_PORT_PULL_UP,
                               IO7_PORT_PULL_DOWN};
  eb_board_port(board, (int)v[0], modes[v[1]]);
}

static void command_servos(struct eb_board* board, const int32_t* v) {
  int i;
  for (i = 0; i < 7; ++i) eb_board_servo(board, (int)v[0] * 7 + i, (uint8_t)v[1 + i]);
}

/* Commands that move something: only in operation. */
static void command_action(struct eb_board* board, int function, const int32_t* v) {
  switch (function) {
    case EYECAN_C_VW_SPEED:
      command_speed(board, v);
      return;
    case EYECAN_C_VW_MOVE:
      command_move(board, v);
      return;
    case EYECAN_C_MOTOR:
      command_motors(board, v);
      return;
    case EYECAN_C_SERVO:
      command_servos(board, v);
      return;
    case EYECAN_C_DIGITAL:
      eb_board_levels_out(board, (uint16_t)v[0], (uint16_t)v[1]);
      return;
    default:
      return;
  }
}

static void command(struct eb_board* board, int function, const int32_t* v) {
  struct eb_node* node = &board->node;
  switch (function) {
    case EYECAN_C_NMT:
      command_state(board, v);
      return;
    case EYECAN_C_ESTOP:
      node->estop_us = 0;
      node->faults |= EYECAN_FLAG_ESTOP;
      leave_operation(board, EYECAN_STATE_STOPPED);
      return;
    case EYECAN_C_SET_POSE:
      eb_drive_set_pose(&board->drive, v[0], v[1], v[2]);
      node->due |= bit_of(EB_DUE_POSE); /* the host waits for it */
      return;
    case EYECAN_C_PID:
      eb_motors_set_gains(&board->motors, (int)v[0] - 1, (uint8_t)v[1], (uint8_t)v[2],
                          (uint8_t)v[3]);
      return;
    case EYECAN_C_DIGITAL_CFG:
      command_port(board, v);
      return;
    default:
      if (node->state == EYECAN_STATE_OPERATIONAL) command_action(board, function, v);
      return;
  }
}

/* Another node answers to our number. */
static void meet_twin(struct eb_board* board) {
  struct eb_node* node = &board->node;
  node->twin_us = 0;
  node->faults |= EYECAN_FLAG_DUPLICATE_NODE;
  if (node->state == EYECAN_STATE_OPERATIONAL) leave_operation(board, EYECAN_STATE_STANDBY);
}

static bool from_robot(int function) {
  return function == EYECAN_HEARTBEAT || function == EYECAN_BULK_RESPONSE ||
         (eb_find_message(function, false) != 0 &&
          (function == EYECAN_S_FAULT ||
           (function >= EYECAN_S_POSE && function <= EYECAN_S_DIGITAL) ||
           function >= EYECAN_S_ANALOG_A));
}

void eb_board_can_receive(struct eb_board* board, const struct eb_can_frame* frame) {
  struct eb_node* node = &board->node;
  const int function = (int)(frame->id >> EYECAN_NODE_BITS);
  const int to = (int)(frame->id & EYECAN_NODE_MASK);
  int32_t values[EB_MAX_SIGNALS];
  if (node->id == 0 || frame->extended || frame->id > 0x7FFU) return;
  if (frame->remote) {
    if (to == node->id && function == EYECAN_S_VERSION) node->due |= bit_of(EB_DUE_VERSION);
    return;
  }
  if (function == EYECAN_HEARTBEAT && to == EYECAN_NODE_HOST) {
    if (eb_can_unpack(frame, values) == EB_CAN_GOOD) node->host_us = 0;
    return;
  }
  if (to == node->id && from_robot(function)) {
    meet_twin(board);
    return;
  }
  if (to != node->id && to != EYECAN_NODE_ALL) return;
  if (node->state == EYECAN_STATE_BOOT) return;
  switch (eb_can_unpack(frame, values)) {
    case EB_CAN_GOOD:
      command(board, function, values);
      break;
    case EB_CAN_SHORT:
      event(node, EYECAN_FAULT_FRAME_LENGTH, frame->id | (uint32_t)frame->length << 16U);
      break;
    case EB_CAN_BAD_VALUE:
      event(node, EYECAN_FAULT_BAD_VALUE, frame->id);
      break;
    case EB_CAN_NOT_OURS:
      break;
  }
}

/* ---- time ---- */

static void set_fault(struct eb_node* node, uint16_t fault, bool there) {
  node->faults = there ? (uint16_t)(node->faults | fault) : (uint16_t)(node->faults & ~fault);
}

static void supervise(struct eb_board* board, uint32_t elapsed_us) {
  struct eb_node* node = &board->node;
  later(&node->host_us, elapsed_us);
  later(&node->command_us, elapsed_us);
  later(&node->estop_us, elapsed_us);
  later(&node->twin_us, elapsed_us);
  if (node->state != EYECAN_STATE_OPERATIONAL) return;
  if (node->host_us >= HOST_LIMIT_US) {
    node->faults |= EYECAN_FLAG_HOST_LOST;
    leave_operation(board, EYECAN_STATE_STANDBY);
    return;
  }
  if (!node->commanded || node->timed_out || node->command_us < COMMAND_LIMIT_US) return;
  node->timed_out = true;
  node->faults |= EYECAN_FLAG_COMMAND_TIMEOUT;
  ++board->watchdogs;
  if (node->raw) {
    eb_board_stop_motors(board);
    board->owner = EB_OWNER_BUS;
  } else {
    eb_drive_speed(&board->drive, 0.0F, 0.0F); /* down the ramp */
  }
}

static void watch_faults(struct eb_board* board) {
  struct eb_node* node = &board->node;
  const uint16_t low = board->config.low_battery_cv;
  const bool held = board->drive.stalled[0] || board->drive.stalled[1];
  const uint32_t since = node->since_us[EB_DUE_FAULT];
  set_fault(node, EYECAN_FLAG_MOTOR_BLOCKED, held);
  set_fault(node, EYECAN_FLAG_LOW_BATTERY, low > 0 && board->pins.supply_cv < low);
  if (since < FAULT_GAP_US) return;
  if (node->event_code != 0 || node->event_sent || node->faults != node->sent_faults ||
      (node->faults != 0 && since >= FAULT_REPEAT_US)) {
    node->due |= bit_of(EB_DUE_FAULT);
  }
}

static void schedule(struct eb_board* board, uint32_t elapsed_us) {
  struct eb_node* node = &board->node;
  int due;
  for (due = 0; due < EB_DUE_COUNT; ++due) {
    later(&node->since_us[due], elapsed_us);
    if (period_us[due] == 0 || node->since_us[due] < period_us[due]) continue;
    node->since_us[due] -= period_us[due];
    if (node->since_us[due] >= period_us[due]) node->since_us[due] = 0;
    node->due |= bit_of(due);
  }
}

void eb_node_time(struct eb_board* board, uint32_t elapsed_us) {
  struct eb_node* node = &board->node;
  const uint16_t in = eb_board_levels(board);
  if (node->id == 0) return;
  supervise(board, elapsed_us);
  schedule(board, elapsed_us);
  watch_faults(board);
  if (in != node->digital_in || board->digital_out != node->digital_out) {
    node->due |= bit_of(EB_DUE_DIGITAL);
  }
}

bool eb_board_can_transmit(struct eb_board* board, struct eb_can_frame* frame) {
  struct eb_node* node = &board->node;
  int due;
  if (node->id == 0) return false;
  /* The first frame after power-up says so. */
  if (node->state == EYECAN_STATE_BOOT) {
    const bool made = !node->booted && eb_node_frame(board, EB_DUE_HEARTBEAT, frame);
    node->booted = true;
    node->state = EYECAN_STATE_STANDBY;
    if (made) return true;
  }
  for (due = 0; due < EB_DUE_COUNT; ++due) {
    if ((node->due & bit_of(due)) == 0) continue;
    node->due &= ~bit_of(due);
    if (eb_node_frame(board, due, frame)) return true;
  }
  return false;
}

void eb_board_can_lost(struct eb_board* board) {
  struct eb_node* node = &board->node;
  if (node->id == 0) return;
  if (node->state == EYECAN_STATE_OPERATIONAL) {
    node->faults |= EYECAN_FLAG_HOST_LOST;
    leave_operation(board, EYECAN_STATE_STANDBY);
  }
  event(node, EYECAN_FAULT_BUS_OFF_RECOVERED, 0);
}

bool eb_board_lidar(struct eb_board* board, const struct eb_scan* scan) {
  struct eb_node* node = &board->node;
  const uint32_t waiting = bit_of(EB_DUE_LIDAR_HEADER) | bit_of(EB_DUE_LIDAR_CHUNK);
  if (node->id == 0 || (node->due & waiting) != 0 || scan->points == 0 ||
      scan->points > EB_LIDAR_POINTS) {
    return false;
  }
  node->scan = *scan;
  ++node->scan_id;
  node->scan_time_ms = (uint16_t)(board->uptime_us / 1000U & 0xFFFFU);
  node->next_chunk = 0;
  node->chunks = (uint16_t)(node->fd ? (scan->points + 29) / 30 : (scan->points + 2) / 3);
  node->due |= waiting;
  return true;
}

bool eb_board_zones(struct eb_board* board, int matrix, const uint16_t range_mm[EB_ZONES]) {
  struct eb_node* node = &board->node;
  if (node->id == 0 || (node->due & bit_of(EB_DUE_ZONES)) != 0 || matrix < 1 ||
      matrix > EB_MATRICES) {
    return false;
  }
  memcpy(node->zones_mm, range_mm, sizeof node->zones_mm);
  node->zones_matrix = (uint8_t)matrix;
  node->zones_chunk = 0;
  ++node->zones_reading;
  node->due |= bit_of(EB_DUE_ZONES);
  return true;
}
