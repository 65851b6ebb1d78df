#ifndef EB_MOTORS_H
#define EB_MOTORS_H

#include <stdbool.h>
#include <stdint.h>

#include "eb_pins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Numbers named _q8 are in units of 1/256. */

/* One motor with its encoder and speed controller. */
struct eb_motor {
  bool controlled;       /* by PID; else `duty` goes out as it is */
  int16_t duty;          /* 0.01 % */
  int32_t target_q8;     /* ticks per 10 ms */
  int32_t aimed_q8;      /* target of the period that `moved` belongs to */
  int32_t last_error_q8; /* ticks per 10 ms */
  int32_t integral_q8;   /* ticks */
  uint8_t p, i, d;
  uint16_t counter; /* of the pin, when last seen */
  int32_t ticks;    /* extended from the counter, since the board was made */
  int16_t moved;    /* ticks in the last period */
};

struct eb_motors {
  struct eb_motor motor[EB_MOTORS];
  int32_t full_q8; /* ticks per 10 ms at full duty */
};

/* All motors off; the counters start where the pins stand. `full_ticks` is at least 1. */
void eb_motors_init(struct eb_motors* motors, float full_ticks, const struct eb_pins* pins);
/* Uncontrolled, -10000 ... 10000; takes effect at once with eb_motors_apply(). */
void eb_motors_set_duty(struct eb_motors* motors, int index, int16_t duty);
/* PID-controlled, 1/256 ticks per 10 ms; clamped to what full duty does. */
void eb_motors_set_speed(struct eb_motors* motors, int index, int32_t ticks_q8);
void eb_motors_set_gains(struct eb_motors* motors, int index, uint8_t p, uint8_t i, uint8_t d);
/* Everything off at once. */
void eb_motors_stop(struct eb_motors* motors);
/* The integral of a wheel that is held is of no use. */
void eb_motors_unwind(struct eb_motors* motors, int index);

/* Every 10 ms: first what the encoders did, then, when new targets are set, what the motors do. */
void eb_motors_sample(struct eb_motors* motors, const struct eb_pins* pins);
void eb_motors_control(struct eb_motors* motors, struct eb_pins* pins);
/* Uncontrolled motors only: between two periods. */
void eb_motors_apply(const struct eb_motors* motors, struct eb_pins* pins);

#ifdef __cplusplus
}
#endif

#endif
