#ifndef EB_PINS_H
#define EB_PINS_H

#include <stdint.h>

#define EB_MOTORS 4
#define EB_PSDS 6
#define EB_ANALOGS 9
#define EB_SERVOS 14
#define EB_PORTS 16
#define EB_DUTY_FULL 10000
#define EB_PSD_ABSENT 0xFFFFU

/* What the wires of a board carry. The port writes the first part before eb_board_process() and
 * carries out the second part after it. */
struct eb_pins {
  /* In. */
  uint16_t encoder[EB_MOTORS]; /* counters of the quadrature decoders; they wrap */
  uint16_t psd[EB_PSDS];       /* 12-bit ADC; EB_PSD_ABSENT: not connected */
  uint16_t analog[EB_ANALOGS]; /* 12-bit ADC; 0 is the supply, 8 the microphone */
  uint16_t supply_cv;          /* supply voltage, 10 mV */
  uint16_t digital_in;         /* bit n: level at port n, where something drives it */
  uint16_t digital_driven;     /* bit n: something outside drives port n; else it floats */
  uint8_t ir_key;              /* last key of the remote control, 0 = none */
  /* Out. */
  int16_t duty[EB_MOTORS];      /* -10000 ... 10000: 0.01 % of full duty; positive is forward */
  uint16_t servo_us[EB_SERVOS]; /* pulse width; 0 = no pulses yet */
  uint16_t digital_out;         /* bit n: level of port n, where it is an output */
  uint16_t digital_outputs;     /* bit n: port n is an output */
};

#endif
