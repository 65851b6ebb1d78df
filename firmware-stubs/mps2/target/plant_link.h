#ifndef EB_PLANT_LINK_H
#define EB_PLANT_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "eb_config.h"
#include "eb_pins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The firmware's end of the plant link: what the wires of the board carry, as frames on a UART.
 * The format is in ../README.md. */

#define EB_PLANT_FORMAT 1 /* said in Hello */
#define EB_PLANT_PAYLOAD 48
#define EB_PLANT_FRAME (EB_PLANT_PAYLOAD + 6)

enum eb_plant_kind {
  EB_PLANT_HELLO = 'H',
  EB_PLANT_CONFIG = 'C',
  EB_PLANT_OUTPUTS = 'O',
  EB_PLANT_INPUTS = 'I'
};

struct eb_plant_frame {
  uint8_t kind, sequence, length;
  uint8_t payload[EB_PLANT_PAYLOAD];
};

/* Writes a frame's bytes; returns how many these are. */
size_t eb_plant_pack(const struct eb_plant_frame* frame, uint8_t out[EB_PLANT_FRAME]);

/* Finds frames in a stream of bytes. All zero is the start. */
struct eb_plant_parser {
  uint8_t bytes[EB_PLANT_FRAME];
  uint8_t count;
  uint32_t dropped; /* bytes that belonged to no frame, since the start */
};
/* Takes a byte; after each one, next() is asked until it has no more. */
void eb_plant_push(struct eb_plant_parser* parser, uint8_t byte);
/* The next whole frame; false when there is none yet. After a frame that is broken the search goes
 * on right behind its first byte: the one after it is not lost. */
bool eb_plant_next(struct eb_plant_parser* parser, struct eb_plant_frame* frame);

void eb_plant_hello(struct eb_plant_frame* frame);
/* The outer side of `pins`; the world is to go on by `elapsed_us`. */
void eb_plant_outputs(struct eb_plant_frame* frame, uint8_t sequence, uint32_t elapsed_us,
                      uint8_t losses, const struct eb_pins* pins);
/* False when it is not such a frame, or its drive is none that a board can have. The rest of
 * `config` is as eb_config_default() says. */
bool eb_plant_config(const struct eb_plant_frame* frame, struct eb_config* config);
/* Sets the inner side of `pins`; false when it is not such a frame. */
bool eb_plant_inputs(const struct eb_plant_frame* frame, struct eb_pins* pins, uint8_t* losses);

#ifdef __cplusplus
}
#endif

#endif
