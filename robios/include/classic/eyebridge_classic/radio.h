/** Messages between robots. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_CLASSIC_RADIO_H
#define EYEBRIDGE_CLASSIC_RADIO_H

/** How the radio works. Kept, and given back; it has no effect here. */
typedef struct {
  int interface; /**< SERIAL1 … */
  int speed;      /**< SER4800 … */
  int id;         /**< Own number. */
  int remoteOn;
  int imageTransfer;
  int debug;
} RadioIOParameters;

/** Who is there. The manuals do not say what the original holds: this is our choice. */
typedef struct {
  int master;       /**< The robot with the lowest number. */
  int own;          /**< This robot. */
  int count;        /**< Of robots with their radio on, this one included, … */
  BYTE active[256]; /**< … which have 1 here. */
} RadioStatus;

int RADIOInit(void);
/** Stops the radio; what has come is forgotten. */
int RADIOTerm(void);
/**
 * Sends up to MAXMSGLEN bytes to a robot, or to all others (BROADCAST); returns at once. Messages may
 * get lost. 1 for NULL, for a message that is too long, and before RADIOInit(). The host computer, 0,
 * is not there: the message is lost.
 */
int RADIOSend(BYTE id, int byteCount, const void* buffer);
/** How many messages wait. */
int RADIOCheck(void);
/** Waits for the next message; NULL for what is not wanted. `buffer` has MAXMSGLEN bytes. */
int RADIORecv(BYTE* id, int* bytesReceived, void* buffer);
void RADIOGetIoctl(RadioIOParameters* radioParams);
void RADIOSetIoctl(RadioIOParameters* radioParams);
int RADIOGetStatus(RadioStatus* status);

#endif
