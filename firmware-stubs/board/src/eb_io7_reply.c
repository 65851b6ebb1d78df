#include <string.h>

#include "eb_io7.h"

void eb_io7_put(struct eb_io7* io7, const char* text, size_t length) {
  size_t i;
  if (length > (size_t)(EB_REPLY - io7->reply_count)) {
    io7->reply_lost = true;
    return;
  }
  for (i = 0; i < length; ++i) {
    const int at = (io7->reply_at + io7->reply_count) % EB_REPLY;
    io7->reply[at] = (uint8_t)text[i];
    ++io7->reply_count;
  }
}

static void put(struct eb_io7* io7, const char* text) { eb_io7_put(io7, text, strlen(text)); }

static int put_decimal(char* out, int32_t value) {
  char digits[12];
  int count = 0;
  int length = 0;
  uint32_t rest = value < 0 ? 0U - (uint32_t)value : (uint32_t)value;
  do {
    digits[count++] = (char)('0' + rest % 10U);
    rest /= 10U;
  } while (rest > 0U);
  if (value < 0) out[length++] = '-';
  while (count > 0) out[length++] = digits[--count];
  return length;
}

static void put_text_numbers(struct eb_io7* io7, const int32_t* values, int count) {
  char line[48];
  int length = 0;
  int i;
  for (i = 0; i < count; ++i) {
    if (i > 0) line[length++] = ' ';
    length += put_decimal(line + length, values[i]);
  }
  for (i = 0; io7->line_end[i] != 0; ++i) line[length++] = io7->line_end[i];
  eb_io7_put(io7, line, (size_t)length);
}

void eb_io7_numbers(struct eb_io7* io7, const int32_t* values, int count, int width) {
  char bytes[8];
  int length = 0;
  int i;
  if (io7->verbose) {
    put_text_numbers(io7, values, count);
    return;
  }
  for (i = 0; i < count; ++i) {
    const uint32_t bits = (uint32_t)values[i];
    const char low = (char)(bits & 0xFFU);
    const char high = (char)(bits >> 8U & 0xFFU);
    if (width == 1) {
      bytes[length++] = low;
    } else {
      bytes[length++] = io7->lsb_first ? low : high;
      bytes[length++] = io7->lsb_first ? high : low;
    }
  }
  eb_io7_put(io7, bytes, (size_t)length);
}

void eb_io7_characters(struct eb_io7* io7, const char* text) {
  put(io7, text);
  if (io7->verbose) put(io7, io7->line_end);
}

void eb_io7_say(struct eb_io7* io7, const char* text) {
  put(io7, text);
  put(io7, io7->line_end);
}

void eb_io7_help(struct eb_io7* io7) {
  const struct eb_letter* row;
  for (row = eb_letters(); row->letter != 0; ++row) {
    if (strchr(io7->letters, row->letter) == 0) continue;
    eb_io7_put(io7, &row->letter, 1);
    put(io7, ": ");
    eb_io7_say(io7, row->help);
  }
}

void eb_io7_prompt(struct eb_io7* io7, bool after_text) {
  if (after_text || io7->verbose || io7->prompt_after_raw) put(io7, io7->prompt);
}

size_t eb_io7_take(struct eb_io7* io7, uint8_t* out, size_t room) {
  size_t taken = 0;
  while (taken < room && io7->reply_count > 0) {
    out[taken++] = io7->reply[io7->reply_at];
    io7->reply_at = (uint16_t)((io7->reply_at + 1) % EB_REPLY);
    --io7->reply_count;
  }
  return taken;
}
