#ifndef EB_DRIVE_H
#define EB_DRIVE_H

#include <stdbool.h>
#include <stdint.h>

#include "eb_config.h"
#include "eb_motors.h"

#ifdef __cplusplus
extern "C" {
#endif

#define EB_MEASURED_PERIODS 5

/* Distance or angle of a move. */
struct eb_goal_part {
  bool open;  /* not there yet */
  float left; /* what remains, signed: metres or radians */
  float side; /* sign of `left` in the period before */
};

/* Driving by v and omega over motors 1 (left) and 2 (right), and dead reckoning from their
 * encoders. The controller is the one of the simulated robots: both parts of a move end together,
 * ramps are linear, progress is what the wheels report. Metres, radians, seconds. */
struct eb_drive {
  struct eb_drive_config config;
  float linear_step, angular_step; /* change of speed in one period */
  float distance_end, angle_end;   /* a goal this near is reached */
  float top;                       /* of a wheel's rim */
  float turn_per_tick;             /* 2^-32 of a turn */
  float decay;                     /* what is left of a difference in speed after a period */

  bool active;                         /* v-omega control has the motors */
  uint8_t move_state;                  /* EYECAN_MOVE_... */
  float linear, angular;               /* commanded in the last period */
  float target_linear, target_angular; /* of speed mode */
  float linear_top, angular_top;       /* of the running move */
  struct eb_goal_part distance, angle;
  bool keeps_heading; /* moves follow each other, nothing else drove in between */
  float heading_owed; /* what the moves so far wanted and the wheels lack, radians */
  uint32_t held_us;
  float starved[2]; /* ticks that a wheel should have made since it last moved */
  bool stalled[2];  /* left, right */
  float speed[2];   /* of the wheels now, as the lag of the motors lets expect, ticks a period */

  int64_t x_q16, y_q16; /* odometry, 2^-16 mm */
  uint32_t heading;     /* 2^-32 of a turn */
  int16_t moved[2][EB_MEASURED_PERIODS];
  uint8_t moved_at;
};

void eb_drive_init(struct eb_drive* drive, const struct eb_drive_config* config);
/* Takes the motors: drives at this speed until the next command. */
void eb_drive_speed(struct eb_drive* drive, float linear, float angular);
/* Takes the motors: drives `distance` while turning by `angle`; `speed` is that along the path, or
 * of the turn when `distance` is 0. Without speed or goal it stops and is done at once. */
void eb_drive_move(struct eb_drive* drive, float distance, float angle, float speed);
/* Gives the motors up; a move that runs is aborted. The motors are stopped by the caller. */
void eb_drive_release(struct eb_drive* drive);

/* Every 10 ms after eb_motors_sample(): odometry and progress, then the wheels' targets. */
void eb_drive_period(struct eb_drive* drive, struct eb_motors* motors);

/* What is left of the running move, millimetres; turns and no move: 0. */
int32_t eb_drive_remaining_mm(const struct eb_drive* drive);
/* Measured over the last 50 ms. */
float eb_drive_linear(const struct eb_drive* drive);
float eb_drive_angular(const struct eb_drive* drive);
/* Odometry. The heading is in -18000 ... 17999. */
int32_t eb_drive_x_mm(const struct eb_drive* drive);
int32_t eb_drive_y_mm(const struct eb_drive* drive);
int32_t eb_drive_heading_cdeg(const struct eb_drive* drive);
void eb_drive_set_pose(struct eb_drive* drive, int32_t x_mm, int32_t y_mm, int32_t heading_cdeg);

#ifdef __cplusplus
}
#endif

#endif
