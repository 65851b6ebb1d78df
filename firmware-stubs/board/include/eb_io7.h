#ifndef EB_IO7_H
#define EB_IO7_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define EB_LINE 40
#define EB_REPLY 2048
#define EB_ARGUMENTS 4
/* A binary request that stops in its middle is dropped, and noise is over, after this silence. */
#define EB_QUIET_US 20000U

struct eb_config;

/* A request that was understood; every argument is within its range. */
struct eb_request {
  char letter;
  uint8_t count;
  int32_t argument[EB_ARGUMENTS];
};

/* One argument of a letter. */
struct eb_field {
  int32_t first, last;
  uint8_t width; /* bytes in the binary form; 0 is a letter out of "ioIJ" */
};

/* One letter of the protocol. */
struct eb_letter {
  char letter;
  uint8_t count;
  struct eb_field field[EB_ARGUMENTS];
  const char* help;
};

/* Null when the protocol has no such letter. */
const struct eb_letter* eb_find_letter(char letter);
/* All letters, the last one followed by a row with letter 0. */
const struct eb_letter* eb_letters(void);

enum eb_found { EB_FOUND_NOTHING, EB_FOUND_REQUEST, EB_FOUND_EMPTY_LINE, EB_FOUND_ERROR };

/* The serial line: bytes to requests, values to bytes. No clock but quiet(). */
struct eb_io7 {
  bool binary, lsb_first, verbose, echo, prompt_after_raw;
  char prompt[8];
  char line_end[3];
  char letters[64]; /* those that exist here */
  uint8_t line[EB_LINE];
  uint8_t length;
  bool too_long;
  bool after_cr;      /* an LF that comes now belongs to the CR before it */
  bool after_request; /* binary: a CR that comes now ends what came just before */
  bool skipping;      /* binary: noise, until the line is quiet */
  uint32_t quiet_us;
  uint8_t reply[EB_REPLY];
  uint16_t reply_at, reply_count;
  bool reply_lost;       /* there was no room for a reply: it was left out as a whole */
  uint32_t bad_requests; /* unknown letters, bad arguments, since the start */
};

void eb_io7_init(struct eb_io7* io7, const struct eb_config* config);
/* Takes one byte; fills `request` when it completes one. */
enum eb_found eb_io7_push(struct eb_io7* io7, uint8_t byte, struct eb_request* request);
/* Tells that nothing came for that long. */
void eb_io7_quiet(struct eb_io7* io7, uint32_t elapsed_us);
/* Forgets what was half said in both directions. */
void eb_io7_reset(struct eb_io7* io7);

/* Replies, in the form that is switched on. `width` is bytes a value in the raw form. */
void eb_io7_numbers(struct eb_io7* io7, const int32_t* values, int count, int width);
void eb_io7_characters(struct eb_io7* io7, const char* text);
/* Lines of text in either form. */
void eb_io7_help(struct eb_io7* io7);
void eb_io7_say(struct eb_io7* io7, const char* text);
/* Ends the answer to a request. */
void eb_io7_prompt(struct eb_io7* io7, bool after_text);
void eb_io7_put(struct eb_io7* io7, const char* text, size_t length);
/* Takes up to `room` bytes of what is to be sent. */
size_t eb_io7_take(struct eb_io7* io7, uint8_t* out, size_t room);

#ifdef __cplusplus
}
#endif

#endif
