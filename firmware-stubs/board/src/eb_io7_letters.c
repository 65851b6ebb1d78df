#include "eb_io7.h"
#include "opcodes.h"

#define MOTOR \
  { IO7_MOTOR_FIRST, IO7_MOTOR_LAST, 1 }
#define SERVO \
  { IO7_SERVO_FIRST, IO7_SERVO_LAST, 1 }
#define GAIN \
  { IO7_GAIN_FIRST, IO7_GAIN_LAST, 1 }
#define LIMIT \
  { IO7_SERVO_LIMIT_FIRST, IO7_SERVO_LIMIT_LAST, 1 }
#define PORT \
  { IO7_PORT_FIRST, IO7_PORT_LAST, 1 }
#define BIT \
  { 0, 1, 1 }
#define MODE \
  { 0, 127, 0 }
#define WORD \
  { IO7_WORD_FIRST, IO7_WORD_LAST, 2 }
#define NONE    \
  {             \
    { 0, 0, 0 } \
  }

static const struct eb_letter letters[] = {
    {IO7_HELP, 0, NONE, "this list"},
    {IO7_OUTPUT, 1, {BIT}, "output mode: verbose 0..1"},
    {IO7_DEMO, 0, NONE, "demo: DRIVES"},
    {IO7_MOTOR, 2, {MOTOR, {IO7_DUTY_FIRST, IO7_DUTY_LAST, 1}}, "motor 1..4, percent -100..100"},
    {IO7_MOTOR_SPEED,
     2,
     {MOTOR, {IO7_TICKS_FIRST, IO7_TICKS_LAST, 1}},
     "controlled motor 1..4, ticks per 1/100 s -128..127"},
    {IO7_PID, 4, {MOTOR, GAIN, GAIN, GAIN}, "PID of motor 1..4: p i d 0..255"},
    {IO7_SERVO,
     2,
     {SERVO, {IO7_SERVO_POSITION_FIRST, IO7_SERVO_POSITION_LAST, 1}},
     "servo 1..14, position 0..255"},
    {IO7_SERVO_LIMITS, 3, {SERVO, LIMIT, LIMIT}, "limits of servo 1..14: lower upper, ms/100"},
    {IO7_PSD, 1, {{IO7_PSD_FIRST, IO7_PSD_LAST, 1}}, "PSD 1..6"},
    {IO7_ENCODER, 1, {{IO7_ENCODER_FIRST, IO7_ENCODER_LAST, 1}}, "encoder 1..4"},
    {IO7_VERSION, 0, NONE, "version"},
    {IO7_VOLTAGE, 0, NONE, "supply, V/100"},
    {IO7_DIGITAL_IN, 1, {PORT}, "digital in 0..15"},
    {IO7_DIGITAL_IN_ALL, 0, NONE, "all digital in"},
    {IO7_DIGITAL_OUT, 2, {PORT, BIT}, "digital out 0..15, bit"},
    {IO7_PORT_CONFIG, 2, {PORT, MODE}, "port 0..15: i in, o out, I pull-up, J pull-down"},
    {IO7_ANALOG, 1, {{IO7_ANALOG_FIRST, IO7_ANALOG_LAST, 1}}, "analog 0..8"},
    {IO7_VW_SET_SPEED, 2, {WORD, WORD}, "speed mm/s deg/s"},
    {IO7_VW_GET_SPEED, 0, NONE, "get speed"},
    {IO7_VW_GET_POSE, 0, NONE, "get pose: x y phi"},
    {IO7_VW_SET_POSE, 3, {WORD, WORD, WORD}, "set pose: mm mm deg"},
    {IO7_VW_STRAIGHT, 2, {WORD, WORD}, "straight: mm/s mm"},
    {IO7_VW_TURN, 2, {WORD, WORD}, "turn: deg/s deg"},
    {IO7_VW_CURVE, 3, {WORD, WORD, WORD}, "curve: mm deg mm/s"},
    {IO7_VW_REMAINING, 0, NONE, "remaining mm"},
    {IO7_VW_DONE, 0, NONE, "move done -1..1"},
    {0, 0, NONE, ""}};

const struct eb_letter* eb_letters(void) { return letters; }

const struct eb_letter* eb_find_letter(char letter) {
  const struct eb_letter* row;
  for (row = letters; row->letter != 0; ++row) {
    if (row->letter == letter) return row;
  }
  return 0;
}
