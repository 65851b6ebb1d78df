#include "eb_motors.h"

#include <string.h>

#include "eb_math.h"

/* The scale of the board's gains is not documented. With these the default gains 4, 1, 1 settle
 * with little overshoot for motors with a lag of 1 ms to 1 s. */
#define SCALE 32
#define INTEGRAL_SCALE 128

#define ERROR_LIMIT_Q8 (512 * 256)
#define INTEGRAL_LIMIT_Q8 (4096 * 256)

void eb_motors_init(struct eb_motors* motors, float full_ticks, const struct eb_pins* pins) {
  int i;
  memset(motors, 0, sizeof *motors);
  motors->full_q8 = eb_round(eb_limit(full_ticks, 1.0F, 32000.0F) * 256.0F);
  for (i = 0; i < EB_MOTORS; ++i) {
    motors->motor[i].p = 4;
    motors->motor[i].i = 1;
    motors->motor[i].d = 1;
    motors->motor[i].counter = pins->encoder[i];
  }
}

static void forget(struct eb_motor* motor) {
  motor->last_error_q8 = 0;
  motor->integral_q8 = 0;
}

void eb_motors_set_duty(struct eb_motors* motors, int index, int16_t duty) {
  struct eb_motor* motor = &motors->motor[index];
  motor->controlled = false;
  motor->duty = (int16_t)eb_clamp(duty, -EB_DUTY_FULL, EB_DUTY_FULL);
  forget(motor);
}

void eb_motors_set_speed(struct eb_motors* motors, int index, int32_t ticks_q8) {
  struct eb_motor* motor = &motors->motor[index];
  if (!motor->controlled) {
    /* What it did up to now was nobody's target. */
    motor->aimed_q8 = (int32_t)motor->moved * 256;
    forget(motor);
  }
  motor->controlled = true;
  motor->target_q8 = eb_clamp(ticks_q8, -motors->full_q8, motors->full_q8);
}

void eb_motors_set_gains(struct eb_motors* motors, int index, uint8_t p, uint8_t i, uint8_t d) {
  motors->motor[index].p = p;
  motors->motor[index].i = i;
  motors->motor[index].d = d;
}

void eb_motors_stop(struct eb_motors* motors) {
  int i;
  for (i = 0; i < EB_MOTORS; ++i) eb_motors_set_duty(motors, i, 0);
}

void eb_motors_unwind(struct eb_motors* motors, int index) {
  forget(&motors->motor[index]);
  motors->motor[index].aimed_q8 = (int32_t)motors->motor[index].moved * 256;
}

void eb_motors_sample(struct eb_motors* motors, const struct eb_pins* pins) {
  int i;
  for (i = 0; i < EB_MOTORS; ++i) {
    struct eb_motor* motor = &motors->motor[i];
    const uint16_t now = pins->encoder[i];
    const uint16_t apart = (uint16_t)(now - motor->counter);
    motor->moved = (int16_t)(apart < 0x8000U ? (int32_t)apart : (int32_t)apart - 0x10000);
    motor->counter = now;
    /* Wraps after 2^31 ticks, as the frames on the bus do. */
    motor->ticks = (int32_t)((uint32_t)motor->ticks + (uint32_t)(int32_t)motor->moved);
  }
}

static int16_t controlled_duty(struct eb_motor* motor, int32_t full_q8) {
  const int32_t error =
      eb_clamp(motor->aimed_q8 - (int32_t)motor->moved * 256, -ERROR_LIMIT_Q8, ERROR_LIMIT_Q8);
  /* Standing still is not aimed at but braked to: what the integral gathered on the way would
   * drive the wheel past it. */
  const int32_t integral = motor->target_q8 == 0 ? 0
                                                 : eb_clamp(motor->integral_q8 + error,
                                                            -INTEGRAL_LIMIT_Q8, INTEGRAL_LIMIT_Q8);
  const int32_t correction =
      (motor->p * error + motor->d * (error - motor->last_error_q8)) / SCALE +
      motor->i * integral / INTEGRAL_SCALE;
  int32_t asked = motor->target_q8 + correction;
  if (asked >= -full_q8 && asked <= full_q8) {
    motor->integral_q8 = integral; /* a motor at its limit must not wind the integral up */
  }
  asked = eb_clamp(asked, -full_q8, full_q8);
  /* A wheel that stands within a tick of where it should is not hunted over the tick's edge. */
  if (motor->target_q8 == 0 && motor->aimed_q8 == 0 && motor->moved >= -1 && motor->moved <= 1) {
    asked = 0;
  }
  motor->last_error_q8 = error;
  motor->aimed_q8 = motor->target_q8;
  return (int16_t)((int64_t)asked * EB_DUTY_FULL / full_q8);
}

void eb_motors_control(struct eb_motors* motors, struct eb_pins* pins) {
  int i;
  for (i = 0; i < EB_MOTORS; ++i) {
    struct eb_motor* motor = &motors->motor[i];
    if (motor->controlled) motor->duty = controlled_duty(motor, motors->full_q8);
    pins->duty[i] = motor->duty;
  }
}

void eb_motors_apply(const struct eb_motors* motors, struct eb_pins* pins) {
  int i;
  for (i = 0; i < EB_MOTORS; ++i) {
    if (!motors->motor[i].controlled) pins->duty[i] = motors->motor[i].duty;
  }
}
