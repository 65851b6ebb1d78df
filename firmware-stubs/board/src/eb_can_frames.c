#include "eb_board.h"
#include "eb_math.h"
#include "opcodes.h"

static int32_t to_word(int32_t value) { return eb_clamp(value, -32768, 32767); }

/* The most important steady fault. */
static uint16_t code_of(uint16_t faults) {
  if (faults & EYECAN_FLAG_ESTOP) return EYECAN_FAULT_ESTOP;
  if (faults & EYECAN_FLAG_DUPLICATE_NODE) return EYECAN_FAULT_DUPLICATE_NODE;
  if (faults & EYECAN_FLAG_HOST_LOST) return EYECAN_FAULT_HOST_LOST;
  if (faults & EYECAN_FLAG_COMMAND_TIMEOUT) return EYECAN_FAULT_COMMAND_TIMEOUT;
  if (faults & EYECAN_FLAG_MOTOR_BLOCKED) return EYECAN_FAULT_MOTOR_BLOCKED;
  if (faults & EYECAN_FLAG_LOW_BATTERY) return EYECAN_FAULT_LOW_BATTERY;
  return EYECAN_FAULT_NONE;
}

static int32_t register_of(uint16_t code) {
  if (code == EYECAN_FAULT_NONE) return 0;
  if ((code & 0xF000U) == 0x3000U) return EYECAN_REGISTER_ANY | EYECAN_REGISTER_VOLTAGE;
  if ((code & 0xF000U) == 0x7000U) return EYECAN_REGISTER_ANY | EYECAN_REGISTER_CURRENT;
  return EYECAN_REGISTER_ANY | EYECAN_REGISTER_COMMUNICATION;
}

static void fill_fault(struct eb_node* node, int32_t* v) {
  uint16_t code = node->event_code;
  v[3] = 0;
  if (code != 0) {
    v[3] = (int32_t)node->event_aux;
    node->event_code = 0;
    node->event_sent = true;
  } else {
    code = code_of(node->faults);
    node->event_sent = false;
    node->sent_faults = node->faults;
  }
  v[0] = code;
  v[1] = register_of(code);
  v[2] = node->faults;
  node->since_us[EB_DUE_FAULT] = 0;
}

static void fill_speed(const struct eb_board* board, int32_t* v) {
  const struct eb_drive* drive = &board->drive;
  const struct eb_node* node = &board->node;
  v[0] = to_word(eb_round(eb_drive_linear(drive) * 1000.0F));
  v[1] = to_word(eb_round(eb_drive_angular(drive) / EB_DEGREE * 100.0F));
  v[2] = drive->move_state;
  v[3] = drive->stalled[0] ? 1 : 0;
  v[4] = drive->stalled[1] ? 1 : 0;
  v[5] = node->state == EYECAN_STATE_OPERATIONAL ? 1 : 0;
  v[6] = node->timed_out ? 1 : 0;
  v[7] = node->move_seq;
  v[8] = to_word(eb_drive_remaining_mm(drive));
}

static int32_t psd_mm(const struct eb_board* board, int index) {
  const uint16_t raw = board->pins.psd[index];
  if (board->config.psd_mm == 0 || raw >= EB_PSD_TABLE) return EYECAN_ABSENT;
  return eb_clamp(board->config.psd_mm[raw], 0, EYECAN_PSD_OUT_OF_RANGE);
}

static int32_t adc(uint16_t value) { return value > IO7_ADC_LAST ? EYECAN_ABSENT : value; }

static void fill_psds(const struct eb_board* board, int due, int32_t* v) {
  int i;
  for (i = 0; i < 4 && due == EB_DUE_PSD_A; ++i) v[i] = psd_mm(board, i);
  for (i = 0; i < 4 && due == EB_DUE_PSD_RAW; ++i) v[i] = adc(board->pins.psd[i]);
  for (i = 0; i < 2 && due == EB_DUE_PSD_B; ++i) {
    v[i] = psd_mm(board, 4 + i);
    v[2 + i] = adc(board->pins.psd[4 + i]);
  }
}

static void fill_status(const struct eb_board* board, int32_t* v) {
  v[0] = board->pins.supply_cv;
  v[1] = adc(board->pins.analog[8]);
  v[2] = board->pins.ir_key;
  v[3] = (int32_t)(board->uptime_us / 100000U & 0xFFFFFFU);
}

static void fill_version(const struct eb_board* board, int32_t* v) {
  int i;
  v[0] = EYECAN_PROTOCOL_VERSION;
  for (i = 0; i < IO7_VERSION_LENGTH; ++i) v[1 + i] = board->config.io7.version[i];
  v[5] = EYECAN_HARDWARE_EYEBOT_IO;
  v[6] = EYECAN_CAPABLE_OF_MOVES | (board->config.lidar ? EYECAN_CAPABLE_OF_SCANS : 0) |
         EYECAN_CAPABLE_OF_ZONES * board->config.matrices;
}

static bool scan_header(const struct eb_node* node, struct eb_can_frame* frame) {
  int32_t v[5];
  v[0] = node->scan_id;
  v[1] = node->scan.points;
  v[2] = node->scan.range_deg;
  v[3] = node->scan.tilt_deg;
  v[4] = node->scan_time_ms;
  return eb_can_pack(frame, EYECAN_S_LIDAR_HDR, false, node->id, v);
}

static bool scan_chunk(struct eb_node* node, struct eb_can_frame* frame) {
  const int count = node->fd ? 30 : 3;
  const int first = node->next_chunk * count;
  const int there = node->scan.points - first < count ? node->scan.points - first : count;
  int32_t v[EB_MAX_SIGNALS];
  int head = 0;
  int i;
  if (node->fd) {
    v[head++] = node->scan_id;
    v[head++] = there;
    v[head++] = first;
  } else {
    v[head++] = node->scan_id & 0x0F;
    v[head++] = node->next_chunk;
  }
  for (i = 0; i < count; ++i) {
    v[head + i] = i < there ? eb_clamp(node->scan.range_mm[first + i], 0, EYECAN_PSD_OUT_OF_RANGE)
                            : EYECAN_ABSENT;
  }
  if (++node->next_chunk < node->chunks) node->due |= (uint32_t)1 << EB_DUE_LIDAR_CHUNK;
  return eb_can_pack(frame, EYECAN_S_LIDAR_CHUNK, node->fd, node->id, v);
}

static bool zones(struct eb_node* node, struct eb_can_frame* frame) {
  const int first = node->zones_chunk * EB_ZONES_A_FRAME;
  int32_t v[3 + EB_ZONES_A_FRAME];
  int i;
  v[0] = node->zones_matrix;
  v[1] = node->zones_reading & 0x0F;
  v[2] = node->zones_chunk;
  for (i = 0; i < EB_ZONES_A_FRAME; ++i) {
    v[3 + i] = first + i < EB_ZONES
                   ? eb_clamp(node->zones_mm[first + i], 0, EYECAN_PSD_OUT_OF_RANGE)
                   : EYECAN_ABSENT;
  }
  ++node->zones_chunk;
  if (node->zones_chunk * EB_ZONES_A_FRAME < EB_ZONES) node->due |= (uint32_t)1 << EB_DUE_ZONES;
  return eb_can_pack(frame, EYECAN_S_ZONES, false, node->id, v);
}

static void fill_digital(struct eb_board* board, int32_t* v) {
  board->node.digital_in = eb_board_levels(board);
  board->node.digital_out = board->digital_out;
  v[0] = board->node.digital_in;
  v[1] = board->digital_out & board->digital_outputs;
  v[2] = board->digital_outputs;
}

bool eb_node_frame(struct eb_board* board, int due, struct eb_can_frame* frame) {
  static const uint8_t functions[EB_DUE_COUNT] = {
      EYECAN_S_FAULT,     EYECAN_S_POSE,        EYECAN_S_SPEED,    EYECAN_S_ENC12,
      EYECAN_S_ENC34,     EYECAN_S_PSD_A,       EYECAN_S_PSD_B,    EYECAN_S_PSD_RAW,
      EYECAN_S_DIGITAL,   EYECAN_S_ANALOG_A,    EYECAN_S_ANALOG_B, EYECAN_S_STATUS,
      EYECAN_S_LIDAR_HDR, EYECAN_S_LIDAR_CHUNK, EYECAN_S_ZONES,    EYECAN_S_VERSION,
      EYECAN_HEARTBEAT};
  struct eb_node* node = &board->node;
  int32_t v[EB_MAX_SIGNALS];
  int i;
  switch (due) {
    case EB_DUE_FAULT:
      fill_fault(node, v);
      break;
    case EB_DUE_POSE:
      v[0] = eb_drive_x_mm(&board->drive);
      v[1] = eb_drive_y_mm(&board->drive);
      v[2] = eb_drive_heading_cdeg(&board->drive);
      break;
    case EB_DUE_SPEED:
      fill_speed(board, v);
      break;
    case EB_DUE_ENC12:
    case EB_DUE_ENC34:
      for (i = 0; i < 2; ++i) v[i] = board->motors.motor[(due == EB_DUE_ENC12 ? 0 : 2) + i].ticks;
      break;
    case EB_DUE_PSD_A:
    case EB_DUE_PSD_B:
    case EB_DUE_PSD_RAW:
      fill_psds(board, due, v);
      break;
    case EB_DUE_DIGITAL:
      fill_digital(board, v);
      break;
    case EB_DUE_ANALOG_A:
    case EB_DUE_ANALOG_B:
      for (i = 0; i < 4; ++i) v[i] = adc(board->pins.analog[(due == EB_DUE_ANALOG_A ? 0 : 4) + i]);
      break;
    case EB_DUE_STATUS:
      fill_status(board, v);
      break;
    case EB_DUE_LIDAR_HEADER:
      return scan_header(node, frame);
    case EB_DUE_LIDAR_CHUNK:
      return scan_chunk(node, frame);
    case EB_DUE_ZONES:
      return zones(node, frame);
    case EB_DUE_VERSION:
      fill_version(board, v);
      break;
    default:
      v[0] = node->state;
      break;
  }
  return eb_can_pack(frame, functions[due], false, node->id, v);
}
