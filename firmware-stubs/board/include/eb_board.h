#ifndef EB_BOARD_H
#define EB_BOARD_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "eb_can.h"
#include "eb_config.h"
#include "eb_drive.h"
#include "eb_io7.h"
#include "eb_motors.h"
#include "eb_pins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Who commanded the motors last: whose silence stops them. */
enum eb_owner { EB_OWNER_NONE, EB_OWNER_SERIAL, EB_OWNER_BUS, EB_OWNER_DEMO };

/* An EyeBot I/O board: state and nothing else. Never allocates, never waits, knows no clock: time
 * is what eb_board_process() is told. One thread. */
struct eb_board {
  struct eb_config config;
  struct eb_pins pins; /* the port fills and reads it between the calls */
  struct eb_motors motors;
  struct eb_drive drive;
  struct eb_io7 io7;
  struct eb_node node;
  enum eb_owner owner;
  uint32_t silent_us; /* since the last good request on the serial line */
  uint32_t period_us; /* into the control period */
  uint64_t uptime_us;
  uint32_t demo_us;   /* into the demo drive */
  uint32_t demos;     /* how often it was started */
  uint32_t watchdogs; /* how often silence or a lost link stopped motors that ran */
  uint16_t digital_out, digital_outputs, pull_up, pull_down;
  uint8_t servo_lower[EB_SERVOS], servo_upper[EB_SERVOS]; /* 10 us */
};

/* Power-up. `pins` is where the counters stand, or null for all zero. */
void eb_board_init(struct eb_board* board, const struct eb_config* config,
                   const struct eb_pins* pins);
/* Lets time go by. Call it every 10 ms or more often, with fresh pins. */
void eb_board_process(struct eb_board* board, uint32_t elapsed_us);

/* The serial line: bytes of the host in, bytes for the host out. */
void eb_board_receive(struct eb_board* board, const uint8_t* bytes, size_t count);
size_t eb_board_transmit(struct eb_board* board, uint8_t* out, size_t room);
/* The host closed the line, or the cable is out: motors stop at once. */
void eb_board_link_lost(struct eb_board* board);

/* The bus: one frame in; the next one out, false when there is none. */
void eb_board_can_receive(struct eb_board* board, const struct eb_can_frame* frame);
bool eb_board_can_transmit(struct eb_board* board, struct eb_can_frame* frame);
/* The controller left the bus: motors stop at once. The host is told when it is back. */
void eb_board_can_lost(struct eb_board* board);
/* Offers a scan, which is copied; false while the one before is still on its way, without a bus,
 * or when it has no points or too many. */
bool eb_board_lidar(struct eb_board* board, const struct eb_scan* scan);

/* The same of a reading of range matrix 1 ... 8, mm: the top row first, each from the left. */
bool eb_board_zones(struct eb_board* board, int matrix, const uint16_t range_mm[EB_ZONES]);

/* For the parts of the board. */
#define EB_DEMO_DUTY 3000
void eb_board_run(struct eb_board* board, const struct eb_request* request);
void eb_board_stop_motors(struct eb_board* board);
void eb_board_servo(struct eb_board* board, int index, uint8_t position);
void eb_board_port(struct eb_board* board, int port, int mode);
uint16_t eb_board_levels(const struct eb_board* board);
void eb_board_levels_out(struct eb_board* board, uint16_t ports, uint16_t levels);
void eb_node_init(struct eb_node* node, const struct eb_config* config);
void eb_node_time(struct eb_board* board, uint32_t elapsed_us);
bool eb_node_frame(struct eb_board* board, int due, struct eb_can_frame* frame);

#ifdef __cplusplus
}
#endif

#endif
