#ifndef EB_CONFIG_H
#define EB_CONFIG_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The dialect that this board speaks on its serial line. */
struct eb_io7_config {
  bool binary;           /* requests are a letter and bytes; else ASCII lines */
  bool verbose;          /* replies start as text; O 0 switches to raw bytes */
  bool lsb_first;        /* byte order of raw replies and binary requests */
  bool prompt_after_raw; /* the prompt follows raw replies too */
  bool echo;             /* requests are sent back */
  char prompt[8];        /* ends in NUL; empty: none */
  char line_end[3];      /* of text replies; ends in NUL */
  char version[5];       /* four printable characters */
  const char* letters; /* the letters that exist; null: all of the command page, without v-omega */
};

/* What the board knows of the robot that it drives. Motor 1 is left, 2 is right. */
struct eb_drive_config {
  float ticks_per_metre;
  float wheel_base;           /* metres */
  float max_linear;           /* metres per second */
  float max_angular;          /* radians per second */
  float linear_acceleration;  /* metres per second squared; 0 = no ramp */
  float angular_acceleration; /* radians per second squared; 0 = no ramp */
  float motor_lag;            /* time constant of the motors, seconds */
  float full_ticks;           /* encoder ticks per 10 ms at full duty, at most 32000 */
  uint32_t stall_timeout_us;  /* a move that is held this long is given up */
};

/* Everything that is set when the board is made. */
struct eb_config {
  struct eb_io7_config io7;
  struct eb_drive_config drive;
  uint32_t silence_us;     /* motors stop when the serial host is silent for this long; 0 = never */
  uint16_t low_battery_cv; /* below: fault on CAN; 0 = never */
  uint8_t node;            /* 1 ... 14 on the CAN bus; else no CAN */
  bool can_fd;             /* LIDAR in CAN FD frames */
  bool lidar;              /* there is one: its scans are announced on CAN */
  uint8_t matrices;        /* bit n - 1: range matrix n is there: announced, too */
  const uint16_t* psd_mm;  /* what S_PsdA says: millimetres by raw value, EB_PSD_TABLE entries, */
                           /* outlives the board; null: absent */
};

#define EB_PSD_TABLE 4096
#define EB_LETTERS_ALL "hOEmMdsSpevViIocaxXqQyYCzZ"
#define EB_LETTERS_PAGE "hOEmMdsSpevViIoca"

/* Raw replies, most significant byte first, ASCII requests, no prompt, no v-omega letters; a robot
 * of 9 cm wheel base with 6484 ticks a metre; motors stop after 300 ms of silence; no CAN. */
void eb_config_default(struct eb_config* config);

#ifdef __cplusplus
}
#endif

#endif
