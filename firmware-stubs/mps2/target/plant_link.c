#include "plant_link.h"

#include <string.h>

#define SYNC 0xA5U
#define HEAD 4U /* sync, kind, sequence, length */
#define TAIL 2U

/* Bits of the first byte of Config. */
#define FLAG_BINARY 1U
#define FLAG_VERBOSE 2U
#define FLAG_LSB 4U
#define FLAG_PROMPT 8U
#define FLAG_VW 16U

/* CRC-16/CCITT-FALSE. */
static uint16_t crc_of(const uint8_t* bytes, size_t count) {
  uint32_t crc = 0xFFFFU;
  size_t i;
  int bit;
  for (i = 0; i < count; ++i) {
    crc ^= (uint32_t)bytes[i] << 8U;
    for (bit = 0; bit < 8; ++bit) crc = (crc & 0x8000U) != 0 ? crc << 1U ^ 0x1021U : crc << 1U;
  }
  return (uint16_t)(crc & 0xFFFFU);
}

size_t eb_plant_pack(const struct eb_plant_frame* frame, uint8_t out[EB_PLANT_FRAME]) {
  const size_t end = HEAD + frame->length;
  uint16_t crc;
  out[0] = SYNC;
  out[1] = frame->kind;
  out[2] = frame->sequence;
  out[3] = frame->length;
  memcpy(out + HEAD, frame->payload, frame->length);
  crc = crc_of(out + 1, end - 1);
  out[end] = (uint8_t)(crc & 0xFFU);
  out[end + 1] = (uint8_t)(crc >> 8U);
  return end + TAIL;
}

static void drop(struct eb_plant_parser* parser, size_t count) {
  parser->count = (uint8_t)(parser->count - count);
  memmove(parser->bytes, parser->bytes + count, parser->count);
}

void eb_plant_push(struct eb_plant_parser* parser, uint8_t byte) {
  parser->bytes[parser->count++] = byte;
}

bool eb_plant_next(struct eb_plant_parser* parser, struct eb_plant_frame* frame) {
  const uint8_t* bytes = parser->bytes;
  while (parser->count > 0) {
    bool good = bytes[0] == SYNC;
    if (good && parser->count < HEAD) return false;
    good = good && bytes[3] <= EB_PLANT_PAYLOAD;
    if (good) {
      const size_t end = HEAD + bytes[3];
      if (parser->count < end + TAIL) return false;
      good = crc_of(bytes + 1, end - 1) == (bytes[end] | bytes[end + 1] << 8U);
      if (good) {
        frame->kind = bytes[1];
        frame->sequence = bytes[2];
        frame->length = bytes[3];
        memcpy(frame->payload, bytes + HEAD, frame->length);
        drop(parser, end + TAIL);
        return true;
      }
    }
    drop(parser, 1);
    ++parser->dropped;
  }
  return false;
}

static void put8(struct eb_plant_frame* frame, uint32_t value) {
  frame->payload[frame->length++] = (uint8_t)(value & 0xFFU);
}

static void put16(struct eb_plant_frame* frame, uint32_t value) {
  put8(frame, value);
  put8(frame, value >> 8U);
}

static uint16_t get16(const uint8_t** at) {
  const uint16_t value = (uint16_t)((*at)[0] | (*at)[1] << 8U);
  *at += 2;
  return value;
}

static uint32_t get32(const uint8_t** at) {
  const uint32_t low = get16(at);
  return low | (uint32_t)get16(at) << 16U;
}

static float get_float(const uint8_t** at) {
  const uint32_t bits = get32(at);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static void begin(struct eb_plant_frame* frame, enum eb_plant_kind kind, uint8_t sequence) {
  frame->kind = (uint8_t)kind;
  frame->sequence = sequence;
  frame->length = 0;
}

void eb_plant_hello(struct eb_plant_frame* frame) {
  begin(frame, EB_PLANT_HELLO, 0);
  put8(frame, EB_PLANT_FORMAT);
}

void eb_plant_outputs(struct eb_plant_frame* frame, uint8_t sequence, uint32_t elapsed_us,
                      uint8_t losses, const struct eb_pins* pins) {
  int i;
  begin(frame, EB_PLANT_OUTPUTS, sequence);
  put16(frame, elapsed_us);
  put16(frame, elapsed_us >> 16U);
  for (i = 0; i < EB_MOTORS; ++i) put16(frame, (uint16_t)pins->duty[i]);
  for (i = 0; i < EB_SERVOS; ++i) put16(frame, pins->servo_us[i]);
  put16(frame, pins->digital_out);
  put16(frame, pins->digital_outputs);
  put8(frame, losses);
}

/* What the arithmetic of the board is made for; a number that is none fits nowhere. */
static bool drivable(const struct eb_drive_config* drive) {
  const float value[8] = {drive->ticks_per_metre,     drive->wheel_base,
                          drive->max_linear,          drive->max_angular,
                          drive->linear_acceleration, drive->angular_acceleration,
                          drive->motor_lag,           drive->full_ticks};
  static const float low[8] = {1.0F, 0.001F, 0.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F};
  static const float high[8] = {1.0e6F, 10.0F, 100.0F, 1000.0F, 1.0e4F, 1.0e5F, 10.0F, 32000.0F};
  int i;
  for (i = 0; i < 8; ++i) {
    if (!(value[i] >= low[i] && value[i] <= high[i])) return false;
  }
  return true;
}

bool eb_plant_config(const struct eb_plant_frame* frame, struct eb_config* config) {
  const uint8_t* at = frame->payload;
  struct eb_drive_config* drive = &config->drive;
  uint8_t flags;
  if (frame->kind != EB_PLANT_CONFIG || frame->length != 41) return false;
  eb_config_default(config);
  flags = *at++;
  config->io7.binary = (flags & FLAG_BINARY) != 0;
  config->io7.verbose = (flags & FLAG_VERBOSE) != 0;
  config->io7.lsb_first = (flags & FLAG_LSB) != 0;
  config->io7.prompt[0] = (flags & FLAG_PROMPT) != 0 ? '>' : 0;
  config->io7.letters = (flags & FLAG_VW) != 0 ? EB_LETTERS_ALL : EB_LETTERS_PAGE;
  config->silence_us = get32(&at);
  drive->stall_timeout_us = get32(&at);
  drive->ticks_per_metre = get_float(&at);
  drive->wheel_base = get_float(&at);
  drive->max_linear = get_float(&at);
  drive->max_angular = get_float(&at);
  drive->linear_acceleration = get_float(&at);
  drive->angular_acceleration = get_float(&at);
  drive->motor_lag = get_float(&at);
  drive->full_ticks = get_float(&at);
  return drivable(drive);
}

bool eb_plant_inputs(const struct eb_plant_frame* frame, struct eb_pins* pins, uint8_t* losses) {
  const uint8_t* at = frame->payload;
  int i;
  if (frame->kind != EB_PLANT_INPUTS || frame->length != 46) return false;
  for (i = 0; i < EB_MOTORS; ++i) pins->encoder[i] = get16(&at);
  for (i = 0; i < EB_PSDS; ++i) pins->psd[i] = get16(&at);
  for (i = 0; i < EB_ANALOGS; ++i) pins->analog[i] = get16(&at);
  pins->supply_cv = get16(&at);
  pins->digital_in = get16(&at);
  pins->digital_driven = get16(&at);
  pins->ir_key = *at++;
  *losses = *at++;
  return true;
}
