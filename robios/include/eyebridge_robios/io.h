/** DIGITAL, ANALOG, IRTV: lines, inputs, remote control. Part of eyebot.h; do not include directly.
 */
#ifndef EYEBRIDGE_ROBIOS_IO_H
#define EYEBRIDGE_ROBIOS_IO_H

/**
 * Makes line 1..16 an input 'i', an output 'o', an input with pull-up 'I' or with pull-down 'J'. At
 * the start 1..8 are inputs with pull-up and 9..16 outputs at 0. 1 for other lines and letters.
 * In simulation lines 1, 2 … are the robot's bumpers and then its infrared switches.
 */
int DIGITALSetup(int io, char direction);
/** Level of a line, 0 or 1; an output reads as what was written. -1 on failure. */
int DIGITALRead(int io);
/** Levels of all lines: bit 0 is line 1, the highest bit line 16. -1 on failure. */
int DIGITALReadAll(void);
/** Sets an output to 0 or (for any other state) 1. A line that is no output keeps it for later. */
int DIGITALWrite(int io, int state);

/**
 * Value of the converter, 0..4095: channel 0 is the supply (one header begins at 1), 1..7 are free,
 * 8 is the microphone. In simulation 0 follows the setting supply_voltage, 1..7 read 0 and 8 is
 * silent (2048). -1 on failure.
 */
int ANALOGRead(int channel);
/** Supply voltage in 1/100 V. -1 on failure. */
int ANALOGVoltage(void);
/**
 * Begins to record samples of a channel, one a millisecond, beside the program. 1 for other
 * channels than ANALOGRead() takes, and other numbers than 1..10000000. A board that cannot be read
 * so fast is read as fast as it can.
 */
int ANALOGRecord(int channel, int iterations);
/**
 * Waits until the recording has ended (UNCERTAIN: the manual does not say what happens before),
 * copies its samples to the buffer, one byte each, the upper 8 of 12 bits (UNCERTAIN, too), and
 * returns how many: at most the iterations of ANALOGRecord(). 0 when there is none, and on failure.
 */
int ANALOGTransfer(BYTE* buffer);

/* Codes of the remote control. They come from the key script (--keys "IRTV_5@2s") and from robots
 * that have a receiver. IRTV_RIGHT is not 'R', on purpose. */
#define IRTV_0 '0'
#define IRTV_1 '1'
#define IRTV_2 '2'
#define IRTV_3 '3'
#define IRTV_4 '4'
#define IRTV_5 '5'
#define IRTV_6 '6'
#define IRTV_7 '7'
#define IRTV_8 '8'
#define IRTV_9 '9'
#define IRTV_RED 'R'
#define IRTV_GREEN 'G'
#define IRTV_YELLOW 'Y'
#define IRTV_BLUE 'B'
#define IRTV_LEFT 'L'
#define IRTV_RIGHT '>'
#define IRTV_UP 'U'
#define IRTV_DOWN 'D'
#define IRTV_OK 'O'
#define IRTV_POWER 'P'

/**
 * Waits for a key of the remote control and returns its code; one that no call has reported yet
 * counts. When none can ever come the program ends with a message, as with KEYGet(). 0 on failure.
 */
int IRTVGet(void);
/** The oldest code that no call has reported yet; 0 when there is none. */
int IRTVRead(void);
/** Forgets the codes that no call has reported. */
int IRTVFlush(void);
/** 1: codes are received. */
int IRTVGetStatus(void);

#endif
