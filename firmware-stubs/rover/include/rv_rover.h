#ifndef RV_ROVER_H
#define RV_ROVER_H

#include <stdbool.h>
#include <stdint.h>

#include "eb_can.h"
#include "eb_motors.h"
#include "eb_pins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Its frames, as examples/rover/rover.dbc has them; identifiers have 29 bits. */
#define RV_DRIVE 0x0CFF0127U
#define RV_ENCODERS 0x0CFF0210U
#define RV_SPEED 0x0CFF0211U
#define RV_RANGES 0x18FF0220U
#define RV_STATE 0x18FF0201U

#define RV_DATA_ID 0x2A51U    /* of RV_DRIVE, in its checksum */
#define RV_LAST_COUNTER 14    /* of RV_DRIVE */
#define RV_FARTHEST_COUNTER 3 /* steps from one command to the next; a larger step is refused */
#define RV_SILENCE_US 100000U
#define RV_PSD_TABLE 4096

/* Everything that is set when the rover is made. */
struct rv_config {
  uint32_t ticks_per_turn; /* of a wheel, at least 1 */
  float full_ticks;        /* ticks per 10 ms at full duty */
  const uint16_t* psd_mm;  /* millimetres by raw value, RV_PSD_TABLE entries; outlives the rover */
};

enum rv_state { RV_STANDING, RV_DRIVING, RV_SILENT };

/* A robot with two wheels and messages of its own: state and nothing else. Never allocates, never
 * waits, knows no clock. The left motor is 0; the right one is mounted the other way round. One
 * thread. */
struct rv_rover {
  struct rv_config config;
  struct eb_pins pins; /* the port fills and reads it between the calls */
  struct eb_motors motors;
  enum rv_state state;
  uint32_t period_us; /* into the control period */
  uint32_t silent_us; /* since the last good command */
  uint32_t periods;   /* since the start */
  uint32_t due;       /* a bit for each frame */
  uint16_t rejected;  /* commands that were not obeyed */
  uint8_t counter;    /* of the last good command */
  uint8_t alive;
  uint8_t sensor; /* 0 ... EB_PSDS - 1: whose distance was sent last */
  bool heard;     /* there was a good command since the last silence */
};

/* Power-up; `pins` says where the counters stand. */
void rv_rover_init(struct rv_rover* rover, const struct rv_config* config,
                   const struct eb_pins* pins);
/* Lets time go by. Call it every 10 ms or more often, with fresh pins. */
void rv_rover_process(struct rv_rover* rover, uint32_t elapsed_us);
/* The bus: one frame in; the next one out, false when there is none. */
void rv_rover_receive(struct rv_rover* rover, const struct eb_can_frame* frame);
bool rv_rover_transmit(struct rv_rover* rover, struct eb_can_frame* frame);
/* The controller left the bus: motors stop at once. */
void rv_rover_lost(struct rv_rover* rover);

/* Checksum of a command's eight bytes: AUTOSAR E2E profile 1. */
uint8_t rv_checksum(const uint8_t data[8]);

#ifdef __cplusplus
}
#endif

#endif
