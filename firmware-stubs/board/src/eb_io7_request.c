#include <string.h>

#include "eb_config.h"
#include "eb_io7.h"
#include "opcodes.h"

void eb_io7_init(struct eb_io7* io7, const struct eb_config* config) {
  const char* letters = config->io7.letters != 0 ? config->io7.letters : EB_LETTERS_PAGE;
  size_t i;
  memset(io7, 0, sizeof *io7);
  io7->binary = config->io7.binary;
  io7->lsb_first = config->io7.lsb_first;
  io7->verbose = config->io7.verbose;
  io7->echo = config->io7.echo;
  io7->prompt_after_raw = config->io7.prompt_after_raw;
  memcpy(io7->prompt, config->io7.prompt, sizeof io7->prompt - 1);
  memcpy(io7->line_end, config->io7.line_end, sizeof io7->line_end - 1);
  for (i = 0; letters[i] != 0 && i + 1 < sizeof io7->letters; ++i) io7->letters[i] = letters[i];
}

void eb_io7_reset(struct eb_io7* io7) {
  io7->length = 0;
  io7->too_long = false;
  io7->after_cr = false;
  io7->after_request = false;
  io7->skipping = false;
  io7->quiet_us = 0;
  io7->reply_count = 0;
}

void eb_io7_quiet(struct eb_io7* io7, uint32_t elapsed_us) {
  if (io7->quiet_us < EB_QUIET_US) {
    io7->quiet_us = elapsed_us > EB_QUIET_US ? EB_QUIET_US : io7->quiet_us + elapsed_us;
  }
  if (io7->quiet_us < EB_QUIET_US) return;
  io7->skipping = false;
  if (!io7->binary) return;
  io7->length = 0;
  io7->after_request = false;
}

static const struct eb_letter* letter_here(const struct eb_io7* io7, uint8_t byte) {
  if (byte == 0 || byte > 127 || strchr(io7->letters, byte) == 0) return 0;
  return eb_find_letter((char)byte);
}

static bool fits(const struct eb_field* field, int32_t value) {
  if (field->width != 0) return value >= field->first && value <= field->last;
  return value == IO7_PORT_INPUT || value == IO7_PORT_OUTPUT || value == IO7_PORT_PULL_UP ||
         value == IO7_PORT_PULL_DOWN;
}

static bool all_fit(const struct eb_letter* row, const struct eb_request* request) {
  int i;
  for (i = 0; i < row->count; ++i) {
    if (!fits(&row->field[i], request->argument[i])) return false;
  }
  return true;
}

static bool is_digit(uint8_t byte) { return byte >= '0' && byte <= '9'; }
static bool is_blank(uint8_t byte) { return byte == ' ' || byte == '\t'; }

/* A decimal with an optional minus sign; six digits are more than any argument has. */
static bool read_number(const struct eb_io7* io7, int* at, int32_t* value) {
  const bool negative = *at < io7->length && io7->line[*at] == '-';
  int digits = 0;
  if (negative) ++*at;
  *value = 0;
  while (*at < io7->length && is_digit(io7->line[*at]) && digits < 7) {
    *value = *value * 10 + (io7->line[*at] - '0');
    ++*at;
    ++digits;
  }
  if (negative) *value = -*value;
  return digits > 0 && digits < 7;
}

/* A letter, then its arguments, each after at least one blank, and nothing else. */
static bool read_line(const struct eb_io7* io7, struct eb_request* request) {
  const struct eb_letter* row = letter_here(io7, io7->line[0]);
  int at = 1;
  int i;
  if (row == 0) return false;
  request->letter = row->letter;
  request->count = row->count;
  for (i = 0; i < row->count; ++i) {
    if (at >= io7->length || !is_blank(io7->line[at])) return false;
    while (at < io7->length && is_blank(io7->line[at])) ++at;
    if (at >= io7->length) return false;
    if (row->field[i].width == 0) {
      request->argument[i] = io7->line[at++];
    } else if (!read_number(io7, &at, &request->argument[i])) {
      return false;
    }
  }
  while (at < io7->length && is_blank(io7->line[at])) ++at;
  return at == io7->length && all_fit(row, request);
}

static enum eb_found end_of_line(struct eb_io7* io7, struct eb_request* request) {
  enum eb_found found = EB_FOUND_EMPTY_LINE;
  if (io7->too_long) {
    found = EB_FOUND_ERROR;
  } else if (io7->length > 0) {
    found = read_line(io7, request) ? EB_FOUND_REQUEST : EB_FOUND_ERROR;
  }
  if (found == EB_FOUND_ERROR) ++io7->bad_requests;
  io7->length = 0;
  io7->too_long = false;
  return found;
}

static enum eb_found push_ascii(struct eb_io7* io7, uint8_t byte, struct eb_request* request) {
  const bool after_cr = io7->after_cr;
  io7->after_cr = byte == '\r';
  if (byte == '\n' && after_cr) return EB_FOUND_NOTHING;
  if (io7->echo) {
    const char echoed[2] = {(char)byte, '\n'};
    eb_io7_put(io7, echoed, byte == '\r' ? 2 : 1);
  }
  if (byte == '\r' || byte == '\n') return end_of_line(io7, request);
  if (io7->length < EB_LINE) {
    io7->line[io7->length++] = byte;
  } else {
    io7->too_long = true;
  }
  return EB_FOUND_NOTHING;
}

static int32_t binary_argument(const struct eb_io7* io7, const struct eb_field* field, int at) {
  int32_t value = io7->line[at];
  if (field->width == 2) {
    const int32_t second = io7->line[at + 1];
    value = io7->lsb_first ? value + second * 256 : value * 256 + second;
  }
  if (field->first < 0 && field->width == 1 && value > 127) value -= 256;
  if (field->first < 0 && field->width == 2 && value > 32767) value -= 65536;
  return value;
}

static enum eb_found push_binary(struct eb_io7* io7, uint8_t byte, struct eb_request* request) {
  const struct eb_letter* row;
  int at = 1;
  int i;
  if (io7->skipping) return EB_FOUND_NOTHING;
  if (io7->echo) {
    const char echoed = (char)byte;
    eb_io7_put(io7, &echoed, 1);
  }
  if (io7->length == 0 && (byte == '\r' || byte == '\n')) {
    const bool belongs = io7->after_request; /* a host that ends its requests like lines */
    io7->after_request = false;
    return byte == '\r' && !belongs ? EB_FOUND_EMPTY_LINE : EB_FOUND_NOTHING;
  }
  io7->after_request = false;
  io7->line[io7->length++] = byte;
  row = letter_here(io7, io7->line[0]);
  if (row != 0) {
    request->letter = row->letter;
    request->count = row->count;
    for (i = 0; i < row->count; ++i) {
      const int width = row->field[i].width == 2 ? 2 : 1;
      if (io7->length < at + width) return EB_FOUND_NOTHING;
      request->argument[i] = binary_argument(io7, &row->field[i], at);
      at += width;
    }
    io7->length = 0;
    io7->after_request = true;
    if (all_fit(row, request)) return EB_FOUND_REQUEST;
  }
  /* What follows could be arguments: no byte of it may be taken for a letter. */
  io7->length = 0;
  io7->skipping = true;
  ++io7->bad_requests;
  return EB_FOUND_ERROR;
}

enum eb_found eb_io7_push(struct eb_io7* io7, uint8_t byte, struct eb_request* request) {
  io7->quiet_us = 0;
  return io7->binary ? push_binary(io7, byte, request) : push_ascii(io7, byte, request);
}
