#include "eb_drive.h"

#include <string.h>

#include "eb_math.h"
#include "opcodes.h"

#define PERIOD 0.01F
#define PERIOD_US 10000U
#define INFINITE 1.0e30F
#define ROUNDING 1.00001F
#define TURN 4294967296.0F
#define TWO_PI 6.2831853071795865F
#define STARVED_TICKS 20.0F
#define FOLLOW 0.2F
#define CREEP_DISTANCE 1.0e-4F
#define CREEP_ANGLE 1.0e-3F
/* Ends of a move that the heading may lack. More than that was not the drive's doing: somebody
 * turned the robot by hand. */
#define MOST_OWED 10.0F

void eb_drive_init(struct eb_drive* drive, const struct eb_drive_config* config) {
  const float tick = 1.0F / config->ticks_per_metre;
  memset(drive, 0, sizeof *drive);
  drive->config = *config;
  drive->linear_step =
      config->linear_acceleration > 0.0F ? config->linear_acceleration * PERIOD : INFINITE;
  drive->angular_step =
      config->angular_acceleration > 0.0F ? config->angular_acceleration * PERIOD : INFINITE;
  /* A goal between two ticks is reached at either of them. */
  drive->distance_end = tick + CREEP_DISTANCE;
  drive->angle_end = tick / config->wheel_base + CREEP_ANGLE;
  drive->top = config->full_ticks * tick / PERIOD;
  drive->turn_per_tick = tick / config->wheel_base / TWO_PI * TURN;
  if (config->motor_lag > 0.0F) {
    const float x = PERIOD / config->motor_lag;
    drive->decay = 1.0F / (1.0F + x * (1.0F + x * (0.5F + x / 6.0F))); /* e^-x */
  }
  drive->move_state = EYECAN_MOVE_IDLE;
}

static float half_base(const struct eb_drive* drive) { return drive->config.wheel_base / 2.0F; }

static float rim(const struct eb_drive* drive, float linear, float angular) {
  return eb_abs(linear) + eb_abs(angular) * half_base(drive);
}

static void set_part(struct eb_goal_part* part, float amount) {
  part->open = amount != 0.0F;
  part->left = amount;
  part->side = amount;
}

/* Metres that a wheel rolled in the last period. */
static float last_moved(const struct eb_drive* drive, int wheel) {
  const int last = (drive->moved_at + EB_MEASURED_PERIODS - 1) % EB_MEASURED_PERIODS;
  return (float)drive->moved[wheel][last] / drive->config.ticks_per_metre;
}

static void take_over(struct eb_drive* drive) {
  if (!drive->active) {
    /* Whoever had the motors before: the ramp starts from the speed that there is. The last period
     * is coarse, but the mean of more would start a robot again that has just been stopped. */
    const float left = last_moved(drive, 0) / PERIOD;
    const float right = last_moved(drive, 1) / PERIOD;
    drive->linear = (left + right) / 2.0F;
    drive->angular = (right - left) / drive->config.wheel_base;
  }
  drive->active = true;
  drive->held_us = 0;
  drive->stalled[0] = drive->stalled[1] = false;
  drive->starved[0] = drive->starved[1] = 0.0F;
}

void eb_drive_speed(struct eb_drive* drive, float linear, float angular) {
  float wheel;
  linear = eb_limit(linear, -drive->config.max_linear, drive->config.max_linear);
  angular = eb_limit(angular, -drive->config.max_angular, drive->config.max_angular);
  wheel = rim(drive, linear, angular);
  if (wheel > drive->top) { /* both scaled, so that the curvature stays */
    linear *= drive->top / wheel;
    angular *= drive->top / wheel;
  }
  /* Hosts repeat themselves: a wheel that is held stays held. */
  if (drive->active && drive->move_state == EYECAN_MOVE_SPEED && linear == drive->target_linear &&
      angular == drive->target_angular) {
    return;
  }
  take_over(drive);
  drive->target_linear = linear;
  drive->target_angular = angular;
  set_part(&drive->distance, 0.0F);
  set_part(&drive->angle, 0.0F);
  drive->keeps_heading = false;
  drive->move_state = EYECAN_MOVE_SPEED;
}

/* No goal any more; the ramp takes the speed to zero. */
static void run_out(struct eb_drive* drive, uint8_t state) {
  drive->target_linear = drive->target_angular = 0.0F;
  set_part(&drive->distance, 0.0F);
  set_part(&drive->angle, 0.0F);
  drive->keeps_heading = false;
  drive->move_state = state;
}

static void stand(struct eb_drive* drive, uint8_t state) {
  drive->linear = drive->angular = 0.0F;
  run_out(drive, state);
}

/* The angle of a move with what those before it owe: a tick's worth after a turn, or what a
 * straight was off, which would add up over many. */
static float settle_heading(struct eb_drive* drive, float angle) {
  const bool kept = drive->keeps_heading && drive->move_state != EYECAN_MOVE_RUNNING &&
                    eb_abs(drive->heading_owed) <= MOST_OWED * drive->angle_end;
  drive->heading_owed = (kept ? drive->heading_owed : 0.0F) + angle;
  drive->keeps_heading = true;
  return angle == 0.0F ? 0.0F : drive->heading_owed;
}

void eb_drive_move(struct eb_drive* drive, float distance, float angle, float speed) {
  take_over(drive);
  speed = eb_abs(speed);
  if (speed == 0.0F || (distance == 0.0F && angle == 0.0F)) {
    run_out(drive, EYECAN_MOVE_DONE);
    return;
  }
  drive->linear_top = drive->config.max_linear;
  drive->angular_top = drive->config.max_angular;
  if (distance != 0.0F) {
    drive->linear_top = eb_limit(speed, 0.0F, drive->linear_top);
  } else {
    drive->angular_top = eb_limit(speed, 0.0F, drive->angular_top);
  }
  set_part(&drive->distance, distance);
  set_part(&drive->angle, settle_heading(drive, angle));
  drive->target_linear = drive->target_angular = 0.0F;
  drive->move_state = EYECAN_MOVE_RUNNING;
}

void eb_drive_release(struct eb_drive* drive) {
  const bool running = drive->move_state == EYECAN_MOVE_RUNNING;
  if (drive->active) stand(drive, running ? EYECAN_MOVE_ABORTED : EYECAN_MOVE_IDLE);
  drive->active = false;
}

/* One period of speed towards a target that is within the limits. Never changes a part by more
 * than its step, never asks more of a wheel than it can do; arrives exactly. */
static void approach(struct eb_drive* drive, float to_linear, float to_angular) {
  const float linear =
      eb_limit(to_linear, drive->linear - drive->linear_step, drive->linear + drive->linear_step);
  const float angular = eb_limit(to_angular, drive->angular - drive->angular_step,
                                 drive->angular + drive->angular_step);
  const float linear_apart = eb_abs(to_linear - drive->linear);
  const float angular_apart = eb_abs(to_angular - drive->angular);
  float part = 1.0F;
  if (rim(drive, linear, angular) <= drive->top * ROUNDING) {
    drive->linear = linear;
    drive->angular = angular;
    return;
  }
  /* The speeds that the wheels can do are a convex set that holds both ends, so the straight way
   * between them is allowed where the two parts on their own are not. */
  if (linear_apart > drive->linear_step) part = drive->linear_step / linear_apart;
  if (angular_apart > drive->angular_step && drive->angular_step / angular_apart < part) {
    part = drive->angular_step / angular_apart;
  }
  drive->linear += part * (to_linear - drive->linear);
  drive->angular += part * (to_angular - drive->angular);
}

/* How much of what is left one period may drive, so that slowing down in the periods after it
 * ends at the goal. `share` is acceleration * period^2 / what is left. */
static float stopping_share(float share) {
  const float count = (eb_sqrt(1.0F + 8.0F / share) - 1.0F) / 2.0F;
  const float n = (float)(int32_t)eb_limit(count, 0.0F, 1.0e6F);
  if (n < 1.0F) return 1.0F;
  return (1.0F + share * n * (n + 1.0F) / 2.0F) / (n + 1.0F);
}

/* Narrows low ... high to the factors f for which f * amount is one step of speed from `speed`. */
static void narrow(float amount, float speed, float step, float* low, float* high) {
  float a, b;
  if (amount == 0.0F) {
    if (eb_abs(speed) > step) *high = -INFINITE;
    return;
  }
  a = (speed - step) / amount;
  b = (speed + step) / amount;
  if (a > b) {
    const float swap = a;
    a = b;
    b = swap;
  }
  if (a > *low) *low = a;
  if (b < *high) *high = b;
}

static void towards_goal(struct eb_drive* drive, float distance, float angle) {
  /* Both parts go on in proportion, so that they end together and a curve is one arc: everything
   * is a factor (per second) with which what is left becomes the speed. */
  const float d = eb_abs(distance);
  const float a = eb_abs(angle);
  float share = INFINITE;
  float low = -INFINITE;
  float high = INFINITE;
  float factor, top;
  if (d == 0.0F && a == 0.0F) {
    approach(drive, 0.0F, 0.0F);
    return;
  }
  top = drive->top / (d + a * half_base(drive));
  if (d > 0.0F) {
    share = PERIOD * drive->linear_step / d;
    if (drive->linear_top / d < top) top = drive->linear_top / d;
  }
  if (a > 0.0F) {
    if (PERIOD * drive->angular_step / a < share) share = PERIOD * drive->angular_step / a;
    if (drive->angular_top / a < top) top = drive->angular_top / a;
  }
  factor = stopping_share(share) / PERIOD;
  if (factor > top) factor = top;
  narrow(distance, drive->linear, drive->linear_step, &low, &high);
  narrow(angle, drive->angular, drive->angular_step, &low, &high);
  if (low <= high) factor = eb_limit(factor, low, high);
  approach(drive, factor * distance, factor * angle);
}

static void advance_part(struct eb_goal_part* part, float travelled, float speed, float step,
                         float end) {
  if (!part->open) return;
  part->left -= travelled;
  /* A start too fast for a short goal runs past it and comes back: only slow passing counts. */
  if (eb_abs(speed) <= step * ROUNDING &&
      (eb_abs(part->left) <= end || part->left * part->side < 0.0F)) {
    part->open = false;
  }
  if (part->left != 0.0F) part->side = part->left < 0.0F ? -1.0F : 1.0F;
}

static void dead_reckon(struct eb_drive* drive, int32_t left, int32_t right) {
  const float way = (float)(left + right) * 0.5F / drive->config.ticks_per_metre * 1000.0F;
  const float turned = (float)(right - left) * drive->turn_per_tick;
  const int32_t turn = eb_round(eb_limit(turned, -1.0e9F, 1.0e9F));
  float sine, cosine;
  /* The chord of so short an arc points along its middle heading. */
  eb_sin_cos(drive->heading + (uint32_t)(turn / 2), &sine, &cosine);
  drive->heading += (uint32_t)turn;
  drive->x_q16 += eb_round(way * cosine * 65536.0F);
  drive->y_q16 += eb_round(way * sine * 65536.0F);
}

/* A wheel that should turn and does not is held. */
static bool watch_wheel(struct eb_drive* drive, int index, const struct eb_motor* motor) {
  if (motor->moved != 0 || motor->aimed_q8 == 0) {
    drive->starved[index] = 0.0F;
    if (motor->moved != 0) drive->stalled[index] = false;
    return drive->stalled[index];
  }
  drive->starved[index] += eb_abs((float)motor->aimed_q8) / 256.0F;
  if (drive->starved[index] >= STARVED_TICKS) drive->stalled[index] = true;
  return drive->stalled[index];
}

static void watch_stall(struct eb_drive* drive, struct eb_motors* motors) {
  int i;
  bool held = false;
  for (i = 0; i < 2; ++i) {
    if (!watch_wheel(drive, i, &motors->motor[i])) continue;
    held = true;
    eb_motors_unwind(motors, i);
  }
  if (!held) {
    drive->held_us = 0;
    return;
  }
  drive->linear = drive->angular = 0.0F; /* the ramp starts again */
  drive->held_us += PERIOD_US;
  if (drive->move_state == EYECAN_MOVE_RUNNING &&
      drive->held_us >= drive->config.stall_timeout_us) {
    stand(drive, EYECAN_MOVE_ABORTED);
  }
}

static void progress(struct eb_drive* drive, float distance, float angle) {
  advance_part(&drive->distance, distance, drive->linear, drive->linear_step, drive->distance_end);
  advance_part(&drive->angle, angle, drive->angular, drive->angular_step, drive->angle_end);
  if (!drive->distance.open && !drive->angle.open &&
      eb_abs(drive->linear) <= drive->linear_step * ROUNDING &&
      eb_abs(drive->angular) <= drive->angular_step * ROUNDING) {
    drive->move_state = EYECAN_MOVE_DONE;
  }
}

/* The speed of a lagging wheel now: what the last target makes of it, drawn towards what was
 * measured. A tick a period alone would be too coarse to know how far it still rolls. */
static void follow_wheel(struct eb_drive* drive, int index, const struct eb_motor* motor) {
  const float target = (float)motor->aimed_q8 / 256.0F;
  const float before = drive->speed[index];
  const float after = target + (before - target) * drive->decay;
  drive->speed[index] = after + FOLLOW * ((float)motor->moved - (before + after) / 2.0F);
}

/* How far the wheels still roll when the motors are told to stand still, ticks. */
static float rolling(const struct eb_drive* drive, const struct eb_motor* motor, int index) {
  return drive->speed[index] / PERIOD * drive->config.motor_lag / (1.0F + (float)motor->p / 32.0F);
}

void eb_drive_period(struct eb_drive* drive, struct eb_motors* motors) {
  const int32_t left = motors->motor[0].moved;
  const int32_t right = motors->motor[1].moved;
  const float per_tick = 1.0F / drive->config.ticks_per_metre;
  const float ticks_q8 = drive->config.ticks_per_metre * PERIOD * 256.0F;
  float turning;
  drive->moved[0][drive->moved_at] = (int16_t)left;
  drive->moved[1][drive->moved_at] = (int16_t)right;
  drive->moved_at = (uint8_t)((drive->moved_at + 1) % EB_MEASURED_PERIODS);
  dead_reckon(drive, left, right);
  drive->heading_owed -= (float)(right - left) * per_tick / drive->config.wheel_base;
  follow_wheel(drive, 0, &motors->motor[0]);
  follow_wheel(drive, 1, &motors->motor[1]);
  if (!drive->active) return;
  if (drive->move_state == EYECAN_MOVE_RUNNING) {
    progress(drive, (float)(left + right) * 0.5F * per_tick,
             (float)(right - left) * per_tick / drive->config.wheel_base);
  }
  watch_stall(drive, motors);
  if (drive->move_state == EYECAN_MOVE_RUNNING) {
    const float l = rolling(drive, &motors->motor[0], 0) * per_tick;
    const float r = rolling(drive, &motors->motor[1], 1) * per_tick;
    towards_goal(drive, drive->distance.open ? drive->distance.left - (l + r) / 2.0F : 0.0F,
                 drive->angle.open ? drive->angle.left - (r - l) / drive->config.wheel_base : 0.0F);
  } else {
    approach(drive, drive->target_linear, drive->target_angular);
  }
  turning = drive->angular * half_base(drive);
  eb_motors_set_speed(motors, 0, eb_round((drive->linear - turning) * ticks_q8));
  eb_motors_set_speed(motors, 1, eb_round((drive->linear + turning) * ticks_q8));
}

int32_t eb_drive_remaining_mm(const struct eb_drive* drive) {
  return drive->distance.open ? eb_round(eb_abs(drive->distance.left) * 1000.0F) : 0;
}

static float measured(const struct eb_drive* drive, int wheel) {
  int32_t sum = 0;
  int i;
  for (i = 0; i < EB_MEASURED_PERIODS; ++i) sum += drive->moved[wheel][i];
  return (float)sum / ((float)EB_MEASURED_PERIODS * PERIOD * drive->config.ticks_per_metre);
}

float eb_drive_linear(const struct eb_drive* drive) {
  return (measured(drive, 0) + measured(drive, 1)) / 2.0F;
}

float eb_drive_angular(const struct eb_drive* drive) {
  return (measured(drive, 1) - measured(drive, 0)) / drive->config.wheel_base;
}

static int32_t to_mm(int64_t q16) {
  const int64_t rounded = q16 >= 0 ? (q16 + 32768) / 65536 : -((32768 - q16) / 65536);
  return rounded > 0x7FFFFF ? 0x7FFFFF : rounded < -0x800000 ? -0x800000 : (int32_t)rounded;
}

int32_t eb_drive_x_mm(const struct eb_drive* drive) { return to_mm(drive->x_q16); }
int32_t eb_drive_y_mm(const struct eb_drive* drive) { return to_mm(drive->y_q16); }

int32_t eb_drive_heading_cdeg(const struct eb_drive* drive) {
  /* 0 ... 36000 first: a right shift of a negative number is the compiler's choice. */
  const int32_t cdeg = (int32_t)(((uint64_t)drive->heading * 36000U + 0x80000000U) >> 32U);
  return cdeg >= 18000 ? cdeg - 36000 : cdeg;
}

void eb_drive_set_pose(struct eb_drive* drive, int32_t x_mm, int32_t y_mm, int32_t heading_cdeg) {
  const int32_t cdeg = (heading_cdeg % 36000 + 36000) % 36000;
  drive->x_q16 = (int64_t)x_mm * 65536;
  drive->y_q16 = (int64_t)y_mm * 65536;
  drive->heading = (uint32_t)((((uint64_t)cdeg << 32U) + 18000U) / 36000U);
}
