#ifndef EB_BOARD_APP_H
#define EB_BOARD_APP_H

#include "eb_board.h"
#include "plant_link.h"

#ifdef __cplusplus
extern "C" {
#endif

#define EB_TICK_US 10000U
/* A board whose plant was silent for this long knows nothing any more, and answers nothing. */
#define EB_PLANT_LATE_US 500000U
#define EB_PLANT_REPEAT_US 100000U

enum eb_app_state {
  EB_APP_ASKING,     /* waits for its configuration */
  EB_APP_CONFIGURED, /* waits for its first inputs */
  EB_APP_RUNNING
};

/* A board whose wires are at the other end of the plant link. One period of the board is one
 * exchange: outputs out, the world goes on, inputs in. So the control loop is exact however late
 * the other end answers; what was missed is made up for, up to half a second. Knows no registers.
 */
struct eb_app {
  struct eb_board board;
  struct eb_plant_parser parser;
  struct eb_config config;
  struct eb_pins pins; /* of the power-up */
  enum eb_app_state state;
  bool fresh; /* inputs are there that no period has used */
  bool lost;  /* the host went away: what is on its way to it is nobody's */
  bool due;   /* `sent` is to go out */
  uint8_t sequence, losses;
  uint32_t owed_us;   /* time that the board has not seen yet */
  uint32_t waited_us; /* for the plant's answer */
  uint32_t repeat_us; /* since the last frame went out */
  uint8_t sent[EB_PLANT_FRAME];
  size_t sent_count;
};

void eb_app_init(struct eb_app* app);
/* Lets time go by; call it every 10 ms or more often. */
void eb_app_time(struct eb_app* app, uint32_t elapsed_us);
/* A byte from the plant, a byte from the host. */
void eb_app_plant(struct eb_app* app, uint8_t byte);
void eb_app_host(struct eb_app* app, uint8_t byte);
/* Bytes for the plant: a whole frame, or 0. */
size_t eb_app_to_plant(struct eb_app* app, uint8_t out[EB_PLANT_FRAME]);
/* Bytes for the host. */
size_t eb_app_to_host(struct eb_app* app, uint8_t* out, size_t room);
/* True once after the host went away. */
bool eb_app_host_lost(struct eb_app* app);

#ifdef __cplusplus
}
#endif

#endif
