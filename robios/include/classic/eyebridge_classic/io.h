/**
 * Latches, parallel port, A/D converter, infrared remote control. Part of eyebot.h; do not include
 * directly.
 */
#ifndef EYEBRIDGE_CLASSIC_IO_H
#define EYEBRIDGE_CLASSIC_IO_H

/**
 * Input latch 0 … 3: eight digital inputs. Latch 0 is the robot's digital lines 1 … 8; of the others
 * there is nothing here. 0 for a latch that is not there.
 */
BYTE OSReadInLatch(int latchnr);
/**
 * Output latch 0 … 3 := (what it was & mask) | value. Returns what it was. Latch 0 is the robot's
 * digital lines 9 … 16. 0 for a latch that is not there.
 */
BYTE OSWriteOutLatch(int latchnr, BYTE mask, BYTE value);
/** What was written to an output latch last. */
BYTE OSReadOutLatch(int latchnr);

/*
 * The parallel port. Nothing is connected to that of a simulated robot: data and control read back as
 * they were written, the status is 0. Real boards have none: 0, and the failure is logged.
 */
BYTE OSReadParData(void);
void OSWriteParData(BYTE value);
/** BUSY 4, ACK 3, PE 2, SLCT 1, ERROR 0. */
BYTE OSReadParSR(void);
/** SLCTIN 3, INT 2, AUTOFDXT 1, STROBE 0; other bits are lost. */
void OSWriteParCTRL(BYTE value);
BYTE OSReadParCTRL(void);

/** Analog channel 0 … 15, 10 bits (0 … 1023); -1 for one that is not there. */
int OSGetAD(int channel);
/** Sends the converter to sleep, 0 or 1: the next OSGetAD() wakes it up. 1 for another mode. */
int OSOffAD(int mode);

/** Listens to the remote control. 0, or 1 for an illegal type or mode, 2 when there is no receiver. */
int IRTVInitHDT(DeviceSemantics semantics);
/**
 * The same, with the properties of the signals, which are only checked: type RAW_CODE …
 * MANCHESTER_CODE, mode DEFAULT_MODE … REPCODE_MODE, 1 … 4 codes kept. Codes come decoded.
 */
int IRTVInit(int type, int length, int tog_mask, int inv_mask, int mode, int bufsize, int delay);
void IRTVTerm(void);
/** The code of the key that is pressed; here the next one that IRTVRead() gives. 0: none. */
int IRTVPressed(void);
/** The next code, or 0. Does not wait. */
int IRTVRead(void);
/** Waits for a code. */
int IRTVGet(void);
/** Forgets what has come. */
void IRTVFlush(void);
/** The signal of the last code: there are no signals here, all is 0. */
void IRTVGetRaw(int bits[2], int* count, int* duration, int* id, int* clock);
/** The code of a signal: -1, as there are none here. */
int IRTVDecodeRaw(const int bits[2], int count, int type);

#endif
