#include "board_app.h"

#include <string.h>

static void send(struct eb_app* app, const struct eb_plant_frame* frame) {
  app->sent_count = eb_plant_pack(frame, app->sent);
  app->due = true;
  app->waited_us = 0;
  app->repeat_us = 0;
}

void eb_app_init(struct eb_app* app) {
  struct eb_plant_frame hello;
  memset(app, 0, sizeof *app);
  eb_plant_hello(&hello);
  send(app, &hello);
}

static void run_period(struct eb_app* app) {
  struct eb_plant_frame outputs;
  eb_board_process(&app->board, EB_TICK_US);
  app->owed_us -= EB_TICK_US;
  app->fresh = false;
  ++app->sequence;
  eb_plant_outputs(&outputs, app->sequence, EB_TICK_US, app->losses, &app->board.pins);
  send(app, &outputs);
}

void eb_app_time(struct eb_app* app, uint32_t elapsed_us) {
  if (elapsed_us > EB_PLANT_LATE_US) elapsed_us = EB_PLANT_LATE_US;
  if (app->waited_us < EB_PLANT_LATE_US) app->waited_us += elapsed_us;
  app->repeat_us += elapsed_us;
  if (!app->fresh && app->repeat_us >= EB_PLANT_REPEAT_US) {
    app->due = true; /* the plant knows a repetition by its number */
    app->repeat_us = 0;
  }
  if (app->state != EB_APP_RUNNING) return;
  app->owed_us += elapsed_us;
  if (app->owed_us > EB_PLANT_LATE_US) app->owed_us = EB_PLANT_LATE_US;
  if (app->fresh && app->owed_us >= EB_TICK_US) run_period(app);
}

static void take_inputs(struct eb_app* app, const struct eb_plant_frame* frame) {
  uint8_t losses;
  struct eb_pins* pins = app->state == EB_APP_RUNNING ? &app->board.pins : &app->pins;
  if (frame->sequence != app->sequence || app->fresh) return; /* the answer to a repetition */
  if (!eb_plant_inputs(frame, pins, &losses)) return;
  if (app->state == EB_APP_CONFIGURED) {
    eb_board_init(&app->board, &app->config, pins);
    app->state = EB_APP_RUNNING;
    app->losses = losses;
    app->owed_us = EB_TICK_US;
  }
  app->fresh = true;
  if (losses != app->losses) {
    app->losses = losses;
    app->lost = true;
    eb_board_link_lost(&app->board);
  }
}

static void take(struct eb_app* app, const struct eb_plant_frame* frame) {
  if (app->state == EB_APP_ASKING) {
    if (eb_plant_config(frame, &app->config)) app->state = EB_APP_CONFIGURED;
  } else {
    take_inputs(app, frame);
  }
}

void eb_app_plant(struct eb_app* app, uint8_t byte) {
  struct eb_plant_frame frame;
  eb_plant_push(&app->parser, byte);
  while (eb_plant_next(&app->parser, &frame)) take(app, &frame);
}

void eb_app_host(struct eb_app* app, uint8_t byte) {
  const bool late = !app->fresh && app->waited_us >= EB_PLANT_LATE_US;
  if (app->state == EB_APP_RUNNING && !late) eb_board_receive(&app->board, &byte, 1);
}

size_t eb_app_to_plant(struct eb_app* app, uint8_t out[EB_PLANT_FRAME]) {
  if (!app->due) return 0;
  app->due = false;
  memcpy(out, app->sent, app->sent_count);
  return app->sent_count;
}

size_t eb_app_to_host(struct eb_app* app, uint8_t* out, size_t room) {
  return app->state == EB_APP_RUNNING ? eb_board_transmit(&app->board, out, room) : 0;
}

bool eb_app_host_lost(struct eb_app* app) {
  const bool lost = app->lost;
  app->lost = false;
  return lost;
}
