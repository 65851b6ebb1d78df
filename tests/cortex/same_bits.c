/* The firmware's control loop and dead reckoning in 20 s of chance commands, for five seeds; prints
 * a hash of every period's pose and duties. A program for any computer, and for a Cortex-M3 without
 * an operating system: whole numbers and floats only, so that all of them have to print the same.
 */
#include <stdint.h>

#include "eb_board.h"
#include "eb_drive.h"

#if defined(__arm__) && !defined(__linux__)
/* Semihosting (Arm IHI 0058): the emulator prints, and ends. */
static void semihosting(int operation, const void* parameter) {
  register int r0 __asm__("r0") = operation;
  register const void* r1 __asm__("r1") = parameter;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}
static void print(const char* text) { semihosting(4, text); }

extern uint8_t eb_stack_top[], eb_bss_start[], eb_bss_end[];
int main(void);
void eb_reset(void);
void eb_reset(void) {
  for (uint8_t* byte = eb_bss_start; byte != eb_bss_end; ++byte) *byte = 0;
  main();
  semihosting(0x18, (const void*)0x20026);
  for (;;) {
  }
}
__attribute__((section(".vectors"), used)) static const struct {
  uint8_t* stack_top;
  void (*reset)(void);
} vectors = {eb_stack_top, eb_reset};
#else
#include <stdio.h>
static void print(const char* text) { fputs(text, stdout); }
#endif

#define PERIODS 2000
#define COMMAND_PERIODS 80

static uint32_t chance;
static uint32_t draw(uint32_t count) {
  chance = chance * 1664525U + 1013904223U;
  return (chance >> 8U) % count;
}
/* -1 ... 1, in steps that a float has. */
static float draw_part(void) { return (float)((int32_t)draw(257) - 128) / 128.0F; }

static uint64_t hash;
static void add(uint64_t value) {
  int i;
  for (i = 0; i < 8; ++i) hash = (hash ^ (value >> (8 * i) & 0xFFU)) * 0x100000001B3U;
}

/* Motors that follow their duty with a lag, in 1/65536 of a tick. */
struct wheel {
  int32_t speed, rest;
};
static void turn(struct wheel* wheel, int16_t duty, uint16_t* encoder) {
  wheel->speed += ((int32_t)duty * 110 / 10000 * 65536 - wheel->speed) / 4;
  wheel->rest += wheel->speed;
  *encoder = (uint16_t)(*encoder + (uint16_t)(wheel->rest / 65536));
  wheel->rest %= 65536;
}

static void command(struct eb_drive* drive) {
  /* One after the other: the order of arguments is the compiler's choice. */
  const uint32_t kind = draw(4);
  const float one = draw_part();
  const float other = draw_part();
  switch (kind) {
    case 0:
      eb_drive_speed(drive, 0.5F * one, 3.0F * other);
      break;
    case 1:
      eb_drive_move(drive, 0.3F * one, 0.0F, 0.3F);
      break;
    case 2:
      eb_drive_move(drive, 0.0F, 2.0F * other, 1.5F);
      break;
    default:
      eb_drive_move(drive, 0.2F * one, other, 0.2F);
      break;
  }
}

static void run(uint32_t seed) {
  static struct eb_board board;
  struct eb_config config;
  struct wheel wheels[2] = {{0, 0}, {0, 0}};
  int i;
  eb_config_default(&config);
  config.silence_us = 0;
  config.drive.motor_lag = 0.04F;
  eb_board_init(&board, &config, 0);
  chance = seed;
  hash = 0xCBF29CE484222325U;
  for (i = 0; i < PERIODS; ++i) {
    if (i % COMMAND_PERIODS == 0) command(&board.drive);
    eb_board_process(&board, 10000);
    turn(&wheels[0], board.pins.duty[0], &board.pins.encoder[0]);
    turn(&wheels[1], board.pins.duty[1], &board.pins.encoder[1]);
    add((uint64_t)board.drive.x_q16);
    add((uint64_t)board.drive.y_q16);
    add(board.drive.heading);
    add((uint16_t)board.pins.duty[0] | (uint64_t)(uint16_t)board.pins.duty[1] << 16U);
  }
}

int main(void) {
  uint32_t seed;
  for (seed = 1; seed <= 5; ++seed) {
    char line[] = "firmware: moves and odometry, seed 0\t0000000000000000\n";
    int i;
    run(seed);
    line[35] = (char)('0' + seed);
    for (i = 0; i < 16; ++i) line[37 + i] = "0123456789abcdef"[hash >> (60 - 4 * i) & 0xFU];
    print(line);
  }
  return 0;
}
