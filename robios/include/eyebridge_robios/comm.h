/** SER, RADIO, AU: to the world outside. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_COMM_H
#define EYEBRIDGE_ROBIOS_COMM_H

/**
 * Opens serial interface 0 (the serial port) or 1..20 (USB devices) with 50..4000000 bits per
 * second, 8 data bits, no parity, 1 stop bit. The setting serial (--serial "1=/dev/ttyUSB0"), or
 * USB lines of an HDT file, say which device that is. handshake is NONE or RTSCTS, or their numbers
 * 0 and 1 (UNCERTAIN: no header gives them). 0, or 1 on failure, as below. Bytes come and go in
 * real time, whatever clock the robot has.
 */
int SERInit(int interface, int baud, int handshake);
/* NONE and RTSCTS mean something as the third argument of SERInit alone: both names stay free. */
#define SERInit(interface, baud, handshake) \
  (SERInit)((interface), (baud), EYEBRIDGE_SECOND(EYEBRIDGE_HANDSHAKE_##handshake, handshake, 0))
#define EYEBRIDGE_HANDSHAKE_NONE 0, 0
#define EYEBRIDGE_HANDSHAKE_RTSCTS 0, 1
#define EYEBRIDGE_SECOND(...) EYEBRIDGE_SECOND_OF(__VA_ARGS__, 0, 0)
#define EYEBRIDGE_SECOND_OF(first, second, ...) (second)
/** Sends one character. */
int SERSendChar(int interface, char ch);
/** Sends a text without its closing zero. SERSend(interface, bytes, size) works, too. */
int SERSend(int interface, const char* buf);
/** Sends size bytes, zeros, too. */
int EYEBRIDGESend(int interface, const char* buf, int size);
/** Waits for one character and returns it; 0 on failure. */
char SERReceiveChar(int interface);
/**
 * Takes what has come, at most size characters, without waiting (UNCERTAIN), and returns how many;
 * a zero follows where there is room. 0 when nothing has come, and on failure.
 */
int SERReceive(int interface, char* buf, int size);
/**
 * True when characters wait to be received. (UNCERTAIN: one header resynchronises an I/O board with
 * it, which our bridge to boards does itself.)
 */
bool SERCheck(int interface);
/** Forgets what has come. */
int SERFlush(int interface);
/** Closes the interface. */
int SERClose(int interface);

/** A beep of 0.1 s at 1 kHz; returns at once, as AUPlay(). In virtual time nothing is heard. */
int AUBeep(void);
/** Plays a sound file, WAV or MP3, in the background, by the player that the setting names. */
int AUPlay(const char* filename);
/** 1 when the last sound has ended (UNCERTAIN), or there was none; 0 while it plays. */
int AUDone(void);
/** Value of the microphone now, 0..4095; silence is 2048. -1 on failure. */
int AUMicrophone(void);

/**
 * Switches the radio on. Who can be reached says the setting radio: robots of this world, or other
 * processes (--radio udp:239.192.7.1:7007?id=2). 1 on failure, as below.
 */
int RADIOInit(void);
/** This robot's number, 1..255; 0 on failure. */
int RADIOGetID(void);
/**
 * Sends a text to the robot with this number, itself, too; at most 1024 bytes. Returns at once; to
 * a robot that is not there it is lost without an error.
 */
int RADIOSend(int id, const char* buf);
/**
 * Waits for a message. Its text, cut to size - 1 bytes and closed by a zero, goes to buf, the
 * sender to *id_no (unless that is null). Returns the number of bytes (one header says always 0);
 * -1 on failure. When in virtual time no other robot has its radio on for an hour the program ends
 * with a message, as with KEYGet().
 */
int RADIOReceive(int* id_no, char* buf, int size);
/**
 * 1 when a message waits, 0 when none does, -1 on failure. Never waits. The older RADIOCheck(&id)
 * works, too, and stores who sent the message that waits.
 */
int RADIOCheck(void);
/** The older form; id_no may be null. */
int EYEBRIDGERadioCheck(int* id_no);
/**
 * Fills IDlist with the numbers of the robots whose radio is on, this one too, ascending, and
 * returns how many these are: at most 255. 0 on failure.
 */
int RADIOStatus(int IDlist[]);
/** Switches the radio off; messages that nobody has received are forgotten. */
int RADIORelease(void);

/* SERSend() and RADIOCheck() in both forms that programs use. */
#ifdef __cplusplus
extern "C++" {
inline int RADIOCheck(int* id_no) { return EYEBRIDGERadioCheck(id_no); }
inline int SERSend(int interface, const char* buf, int size) {
  return EYEBRIDGESend(interface, buf, size);
}
inline int SERSend(int interface, const unsigned char* buf, int size) {
  return EYEBRIDGESend(interface, reinterpret_cast<const char*>(buf), size);
}
}
#else
#define RADIOCheck(...) EYEBRIDGERadioCheck((int*)(__VA_ARGS__ + 0))
#define SERSend(...) EYEBRIDGE_FOURTH(__VA_ARGS__, EYEBRIDGESend, SERSend, 0)(__VA_ARGS__)
#define EYEBRIDGE_FOURTH(a, b, c, d, ...) d
#endif

#endif
