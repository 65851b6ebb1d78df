#include "rv_rover.h"

#include <string.h>

#define PERIOD_US 10000U
#define SPEED_PERIODS 2U
#define STATE_PERIODS 5U
#define DRIVE_LENGTH 8

/* What is due, in the order in which it is sent. */
#define DUE_STATE 0
#define DUE_ENCODERS 1
#define DUE_SPEED 2
#define DUE_RANGES 3
#define DUE_COUNT 4

static uint8_t crc_step(uint8_t crc, uint8_t byte) {
  int bit;
  crc = (uint8_t)(crc ^ byte);
  for (bit = 0; bit < 8; ++bit) {
    crc = (uint8_t)((crc & 0x80U) != 0 ? (unsigned)crc << 1U ^ 0x1DU : (unsigned)crc << 1U);
  }
  return crc;
}

uint8_t rv_checksum(const uint8_t data[8]) {
  uint8_t crc = crc_step(crc_step(0, RV_DATA_ID & 0xFFU), RV_DATA_ID >> 8U);
  int i;
  for (i = 1; i < DRIVE_LENGTH; ++i) crc = crc_step(crc, data[i]);
  return crc;
}

static void stand(struct rv_rover* rover, enum rv_state state) {
  eb_motors_stop(&rover->motors);
  eb_motors_apply(&rover->motors, &rover->pins);
  rover->state = state;
}

void rv_rover_init(struct rv_rover* rover, const struct rv_config* config,
                   const struct eb_pins* pins) {
  memset(rover, 0, sizeof *rover);
  rover->config = *config;
  if (rover->config.ticks_per_turn == 0) rover->config.ticks_per_turn = 1;
  rover->pins = *pins;
  eb_motors_init(&rover->motors, config->full_ticks, pins);
  rover->sensor = EB_PSDS - 1;
  rover->counter = 0xFF; /* none */
}

static void period(struct rv_rover* rover) {
  eb_motors_sample(&rover->motors, &rover->pins);
  eb_motors_control(&rover->motors, &rover->pins);
  ++rover->periods;
  rover->due |= 1U << DUE_ENCODERS | 1U << DUE_RANGES;
  if (rover->periods % SPEED_PERIODS == 0) rover->due |= 1U << DUE_SPEED;
  if (rover->periods % STATE_PERIODS == 0) rover->due |= 1U << DUE_STATE;
}

void rv_rover_process(struct rv_rover* rover, uint32_t elapsed_us) {
  while (elapsed_us > 0) {
    const uint32_t rest = PERIOD_US - rover->period_us;
    const uint32_t piece = elapsed_us < rest ? elapsed_us : rest;
    elapsed_us -= piece;
    rover->period_us += piece;
    if (rover->silent_us < RV_SILENCE_US) rover->silent_us += piece;
    if (rover->heard && rover->silent_us >= RV_SILENCE_US) {
      rover->heard = false;
      stand(rover, RV_SILENT);
    }
    if (rover->period_us < PERIOD_US) continue;
    rover->period_us = 0;
    period(rover);
  }
}

/* Whether a command with this counter follows the one before. */
static bool follows(const struct rv_rover* rover, uint8_t counter) {
  const int steps = (counter + RV_LAST_COUNTER + 1 - rover->counter) % (RV_LAST_COUNTER + 1);
  /* After silence any other one: who sends the same frame again and again is no living host. */
  if (!rover->heard) return counter != rover->counter;
  return steps >= 1 && steps <= RV_FARTHEST_COUNTER;
}

static int32_t big_endian_16(const uint8_t* bytes) {
  const int32_t value = (int32_t)bytes[0] << 8 | bytes[1];
  return value < 0x8000 ? value : value - 0x10000;
}

/* Speeds are in 0.1 turns a minute: 1/256 ticks per 10 ms. */
static int32_t ticks_q8(const struct rv_rover* rover, int32_t tenth_rpm) {
  return (int32_t)((int64_t)tenth_rpm * rover->config.ticks_per_turn * 256 / 60000);
}

void rv_rover_receive(struct rv_rover* rover, const struct eb_can_frame* frame) {
  const uint8_t counter = frame->data[1] & 0x0FU;
  int32_t left;
  int32_t right;
  if (!frame->extended || frame->id != RV_DRIVE || frame->remote || frame->fd) return;
  if (frame->length != DRIVE_LENGTH || counter > RV_LAST_COUNTER ||
      rv_checksum(frame->data) != frame->data[0] || !follows(rover, counter)) {
    if (rover->rejected < 0xFFFFU) ++rover->rejected;
    return;
  }
  rover->counter = counter;
  rover->heard = true;
  rover->silent_us = 0;
  left = big_endian_16(frame->data + 2);
  right = -big_endian_16(frame->data + 4);
  if ((frame->data[1] & 0x10U) == 0 || (left == 0 && right == 0)) {
    if (rover->state != RV_STANDING) stand(rover, RV_STANDING);
    return;
  }
  rover->state = RV_DRIVING;
  eb_motors_set_speed(&rover->motors, 0, ticks_q8(rover, left));
  eb_motors_set_speed(&rover->motors, 1, ticks_q8(rover, right));
}

void rv_rover_lost(struct rv_rover* rover) {
  rover->heard = false;
  stand(rover, RV_SILENT);
}

static void put(uint8_t* bytes, uint32_t value, int count) {
  int i;
  for (i = count - 1; i >= 0; --i) {
    bytes[i] = (uint8_t)(value & 0xFFU);
    value >>= 8U;
  }
}

static void start_frame(struct eb_can_frame* frame, uint32_t id, uint8_t length) {
  memset(frame, 0, sizeof *frame);
  frame->id = id;
  frame->extended = true;
  frame->length = length;
}

static void encoders(struct rv_rover* rover, struct eb_can_frame* frame) {
  start_frame(frame, RV_ENCODERS, 7);
  put(frame->data, (uint32_t)rover->motors.motor[0].ticks, 3);
  put(frame->data + 3, 0U - (uint32_t)rover->motors.motor[1].ticks, 3);
  frame->data[6] = rover->alive;
  rover->alive = (uint8_t)((rover->alive + 1U) & 0x0FU);
}

static uint32_t tenth_rpm(const struct rv_rover* rover, int index) {
  const int32_t ticks = rover->motors.motor[index].moved;
  return (uint32_t)(ticks * 60000 / (int32_t)rover->config.ticks_per_turn);
}

static void speeds(const struct rv_rover* rover, struct eb_can_frame* frame) {
  start_frame(frame, RV_SPEED, 4);
  put(frame->data, tenth_rpm(rover, 0), 2);
  put(frame->data + 2, 0U - tenth_rpm(rover, 1), 2);
}

static void state(const struct rv_rover* rover, struct eb_can_frame* frame) {
  const struct eb_motor* motor = rover->motors.motor;
  const bool moves = motor[0].moved != 0 || motor[1].moved != 0;
  start_frame(frame, RV_STATE, 6);
  frame->data[0] = (uint8_t)rover->state;
  frame->data[1] = moves || rover->state == RV_DRIVING ? 1 : 0;
  put(frame->data + 2, rover->rejected, 2);
  put(frame->data + 4, rover->pins.supply_cv, 2);
}

/* The next sensor that is connected; false when there is none. */
static bool range(struct rv_rover* rover, struct eb_can_frame* frame) {
  int tried;
  for (tried = 0; tried < EB_PSDS; ++tried) {
    uint16_t raw;
    rover->sensor = (uint8_t)((rover->sensor + 1U) % EB_PSDS);
    raw = rover->pins.psd[rover->sensor];
    if (raw == EB_PSD_ABSENT) continue;
    start_frame(frame, RV_RANGES, 3);
    frame->data[0] = (uint8_t)(rover->sensor + 1U);
    put(frame->data + 1, rover->config.psd_mm[raw & (RV_PSD_TABLE - 1)], 2);
    return true;
  }
  return false;
}

bool rv_rover_transmit(struct rv_rover* rover, struct eb_can_frame* frame) {
  int due;
  for (due = 0; due < DUE_COUNT; ++due) {
    if ((rover->due & 1U << due) == 0) continue;
    rover->due &= ~(1U << due);
    switch (due) {
      case DUE_STATE:
        state(rover, frame);
        return true;
      case DUE_ENCODERS:
        encoders(rover, frame);
        return true;
      case DUE_SPEED:
        speeds(rover, frame);
        return true;
      default:
        if (range(rover, frame)) return true;
    }
  }
  return false;
}
