#include <string.h>

#include "eb_can.h"
#include "opcodes.h"

#define U(bits) \
  { (bits), false, 0, (int32_t)((1UL << (bits)) - 1UL) }
#define S(bits) \
  { -(bits), false, -(int32_t)(1UL << ((bits)-1)), (int32_t)((1UL << ((bits)-1)) - 1UL) }
#define S32 \
  { -32, false, -2147483647 - 1, 2147483647 }
#define FROM(bits, first, last) \
  { (bits), false, (first), (last) }
#define MM \
  { 16, true, 0, EYECAN_PSD_OUT_OF_RANGE }
#define ADC \
  { 16, true, 0, 4095 }
#define CHARACTER \
  { 8, false, 0x20, 0x7E }
#define FIVE_MM MM, MM, MM, MM, MM
#define LIDAR_INDEX_LAST 12287 /* three points for each of 4096 chunks */

static const struct eb_signal nmt[] = {U(8), FROM(8, 0, EYECAN_NODE_LAST)};
static const struct eb_signal estop[] = {FROM(8, EYECAN_ESTOP_USER, EYECAN_ESTOP_HOST_FAULT), U(8)};
static const struct eb_signal fault[] = {U(16), U(8), U(16), U(24)};
static const struct eb_signal pose[] = {S(24), S(24), S(16)};
static const struct eb_signal speed[] = {
    S(16), S(16), FROM(4, EYECAN_MOVE_IDLE, EYECAN_MOVE_ABORTED), U(1), U(1), U(1), U(1),
    U(8),  S(16)};
static const struct eb_signal encoders[] = {S32, S32};
static const struct eb_signal psd_mm[] = {MM, MM, MM, MM};
static const struct eb_signal psd_b[] = {MM, MM, ADC, ADC};
static const struct eb_signal four_adc[] = {ADC, ADC, ADC, ADC};
static const struct eb_signal digital[] = {U(16), U(16), U(16)};
static const struct eb_signal vw_speed[] = {S(16), S(16), U(8), U(8)};
static const struct eb_signal vw_move[] = {FROM(8, EYECAN_VW_STRAIGHT, EYECAN_VW_DRIVE), U(8),
                                           S(16), S(16), FROM(-16, 0, 32767)};
static const struct eb_signal motor[] = {
    S(8), S(8), S(8), S(8), U(4), FROM(4, EYECAN_MOTOR_PERCENT, EYECAN_MOTOR_TICKS), U(8)};
static const struct eb_signal pid[] = {FROM(8, 1, 4), U(8), U(8), U(8)};
static const struct eb_signal servo[] = {FROM(8, 0, 1), U(8), U(8), U(8), U(8), U(8), U(8), U(8)};
static const struct eb_signal set_digital[] = {U(16), U(16)};
static const struct eb_signal port[] = {FROM(8, 0, 15),
                                        FROM(8, EYECAN_PORT_INPUT, EYECAN_PORT_PULL_DOWN)};
static const struct eb_signal status[] = {{16, true, 0, 0xFFFE}, ADC, U(8), U(24)};
static const struct eb_signal lidar[] = {U(8), FROM(16, 1, LIDAR_INDEX_LAST + 1), FROM(16, 1, 360),
                                         FROM(-8, -90, 90), U(16)};
static const struct eb_signal chunk[] = {U(4), U(12), MM, MM, MM};
static const struct eb_signal chunk_fd[] = {U(8),    FROM(8, 1, 30), FROM(16, 0, LIDAR_INDEX_LAST),
                                            FIVE_MM, FIVE_MM,        FIVE_MM,
                                            FIVE_MM, FIVE_MM,        FIVE_MM};
static const struct eb_signal zones[] = {
    FROM(4, 1, EB_MATRICES), U(4), FROM(8, 0, (EB_ZONES - 1) / EB_ZONES_A_FRAME), MM, MM, MM};
static const struct eb_signal version[] = {U(8),      CHARACTER, CHARACTER, CHARACTER,
                                           CHARACTER, U(8),      U(16)};
static const struct eb_signal heartbeat[] = {FROM(8, 0, 0x7F)};

#define COUNT(list) (uint8_t)(sizeof(list) / sizeof((list)[0])), (list)

static const struct eb_message messages[] = {
    {EYECAN_C_NMT, false, 0, 0, 2, COUNT(nmt)},
    {EYECAN_C_ESTOP, false, 0, 14, 2, COUNT(estop)},
    {EYECAN_S_FAULT, false, 1, 14, 8, COUNT(fault)},
    {EYECAN_S_POSE, false, 1, 14, 8, COUNT(pose)},
    {EYECAN_S_SPEED, false, 1, 14, 8, COUNT(speed)},
    {EYECAN_S_ENC12, false, 1, 14, 8, COUNT(encoders)},
    {EYECAN_S_ENC34, false, 1, 14, 8, COUNT(encoders)},
    {EYECAN_S_PSD_A, false, 1, 14, 8, COUNT(psd_mm)},
    {EYECAN_S_PSD_B, false, 1, 14, 8, COUNT(psd_b)},
    {EYECAN_S_PSD_RAW, false, 1, 14, 8, COUNT(four_adc)},
    {EYECAN_S_DIGITAL, false, 1, 14, 6, COUNT(digital)},
    {EYECAN_C_VW_SPEED, false, 1, 14, 6, COUNT(vw_speed)},
    {EYECAN_C_VW_MOVE, false, 1, 14, 8, COUNT(vw_move)},
    {EYECAN_C_SET_POSE, false, 1, 14, 8, COUNT(pose)},
    {EYECAN_C_MOTOR, false, 1, 14, 8, COUNT(motor)},
    {EYECAN_C_PID, false, 1, 14, 4, COUNT(pid)},
    {EYECAN_C_SERVO, false, 1, 14, 8, COUNT(servo)},
    {EYECAN_C_DIGITAL, false, 1, 14, 4, COUNT(set_digital)},
    {EYECAN_C_DIGITAL_CFG, false, 1, 14, 2, COUNT(port)},
    {EYECAN_S_ANALOG_A, false, 1, 14, 8, COUNT(four_adc)},
    {EYECAN_S_ANALOG_B, false, 1, 14, 8, COUNT(four_adc)},
    {EYECAN_S_STATUS, false, 1, 14, 8, COUNT(status)},
    {EYECAN_S_LIDAR_HDR, false, 1, 14, 8, COUNT(lidar)},
    {EYECAN_S_LIDAR_CHUNK, false, 1, 14, 8, COUNT(chunk)},
    {EYECAN_S_LIDAR_CHUNK, true, 1, 14, 64, COUNT(chunk_fd)},
    {EYECAN_S_ZONES, false, 1, 14, 8, COUNT(zones)},
    {EYECAN_S_VERSION, false, 1, 14, 8, COUNT(version)},
    {EYECAN_HEARTBEAT, false, 1, 15, 1, COUNT(heartbeat)}};

const struct eb_message* eb_find_message(int function, bool fd) {
  size_t i;
  for (i = 0; i < sizeof messages / sizeof messages[0]; ++i) {
    if (messages[i].function == function && messages[i].fd == fd) return &messages[i];
  }
  return 0;
}

static int width_of(const struct eb_signal* signal) {
  return signal->bits < 0 ? -signal->bits : signal->bits;
}

static bool accepts(const struct eb_signal* signal, int32_t value) {
  return (value >= signal->first && value <= signal->last) ||
         (signal->absent && value == EYECAN_ABSENT);
}

/* Rules that no single number can state. */
static bool consistent(const struct eb_message* message, const int32_t* values) {
  int i;
  switch (message->function) {
    case EYECAN_C_NMT:
      return values[0] == EYECAN_NMT_ENABLE || values[0] == EYECAN_NMT_STOP ||
             values[0] == EYECAN_NMT_STANDBY || values[0] == EYECAN_NMT_RESET;
    case EYECAN_C_MOTOR:
      for (i = 0; i < 4 && values[5] == EYECAN_MOTOR_PERCENT; ++i) {
        if (values[i] < -100 || values[i] > 100) return false;
      }
      return true;
    case EYECAN_S_LIDAR_CHUNK:
      return !message->fd || values[2] + values[1] <= LIDAR_INDEX_LAST + 1;
    case EYECAN_HEARTBEAT:
      return values[0] == EYECAN_STATE_BOOT || values[0] == EYECAN_STATE_STOPPED ||
             values[0] == EYECAN_STATE_OPERATIONAL || values[0] == EYECAN_STATE_STANDBY;
    default:
      return true;
  }
}

bool eb_can_pack(struct eb_can_frame* frame, int function, bool fd, int node,
                 const int32_t* values) {
  const struct eb_message* message = eb_find_message(function, fd);
  int at = 0;
  int i;
  memset(frame, 0, sizeof *frame);
  if (message == 0 || node < message->first_node || node > message->last_node) return false;
  if (!consistent(message, values)) return false;
  frame->id = (uint16_t)(function << EYECAN_NODE_BITS | node);
  frame->fd = fd;
  frame->length = message->length;
  for (i = 0; i < message->count; ++i) {
    const int width = width_of(&message->signals[i]);
    int bit;
    if (!accepts(&message->signals[i], values[i])) return false;
    for (bit = 0; bit < width; ++bit, ++at) {
      const uint32_t one = (uint32_t)values[i] >> bit & 1U;
      frame->data[at / 8] = (uint8_t)(frame->data[at / 8] | one << at % 8);
    }
  }
  return true;
}

static int32_t take(const struct eb_can_frame* frame, int at, const struct eb_signal* signal) {
  const int width = width_of(signal);
  uint32_t bits = 0;
  int bit;
  for (bit = 0; bit < width; ++bit, ++at) {
    bits |= ((uint32_t)frame->data[at / 8] >> at % 8 & 1U) << bit;
  }
  if (signal->bits >= 0 || (bits >> (width - 1)) == 0) return (int32_t)bits;
  /* Two's complement, without a conversion that is the compiler's choice. */
  return -1 - (int32_t)(~bits & (0x7FFFFFFFU >> (32 - width)));
}

enum eb_can_unpacked eb_can_unpack(const struct eb_can_frame* frame,
                                   int32_t values[EB_MAX_SIGNALS]) {
  const int node = (int)(frame->id & EYECAN_NODE_MASK);
  const struct eb_message* message =
      frame->remote || frame->extended || frame->id > 0x7FFU
          ? 0
          : eb_find_message((int)(frame->id >> EYECAN_NODE_BITS), frame->fd);
  int at = 0;
  int i;
  if (message == 0 || node < message->first_node || node > message->last_node) {
    return EB_CAN_NOT_OURS;
  }
  if (frame->length < message->length) return EB_CAN_SHORT;
  for (i = 0; i < message->count; ++i) {
    values[i] = take(frame, at, &message->signals[i]);
    if (!accepts(&message->signals[i], values[i])) return EB_CAN_BAD_VALUE;
    at += width_of(&message->signals[i]);
  }
  return consistent(message, values) ? EB_CAN_GOOD : EB_CAN_BAD_VALUE;
}
