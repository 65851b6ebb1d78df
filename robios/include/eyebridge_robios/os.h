/** OS: system, time and timers. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_OS_H
#define EYEBRIDGE_ROBIOS_OS_H

/**
 * Runs a shell command to its end and returns its output, which stays valid until the next call of
 * the same thread; null on failure. (UNCERTAIN: one manual runs it in the background; write "… &"
 * for that.) Older programs call OSExecute(command, output), which copies the output to a buffer of
 * 1024 bytes with its closing zero, cut to that, and returns 0, or 1 on failure: both forms work,
 * in C by the number of arguments, in C++ by overloading.
 */
char* OSExecute(const char* command);
/** The older form. */
int EYEBRIDGEExecute(const char* command, char* output);
#ifdef __cplusplus
extern "C++" inline int OSExecute(const char* command, char* output) {
  return EYEBRIDGEExecute(command, output);
}
#else
#define OSExecute(...) EYEBRIDGE_THIRD(__VA_ARGS__, EYEBRIDGEExecute, OSExecute, 0)(__VA_ARGS__)
#define EYEBRIDGE_THIRD(a, b, c, ...) c
#endif
/** Copies the version of RoBIOS to buf, at most 100 bytes with the closing zero. */
int OSVersion(char* buf);
/**
 * Copies the version of the I/O board, as it says itself, to buf, at most 100 bytes; 1 when there
 * is no board (in simulation, as in EyeSim) or it does not answer, and buf is empty then.
 */
int OSVersionIO(char* buf);
/**
 * Processor speed in Hz (one manual says MHz; the published constant is in Hz): MACHINE_SPEED on
 * every computer, so that programs behave alike.
 */
int OSMachineSpeed(void);
/** VEHICLE, PLATFORM or WALKER. */
int OSMachineType(void);
/** Copies the machine's name, MACHINE_NAME, to buf, at most 100 bytes with the closing zero. */
int OSMachineName(char* buf);
/** Number of this robot. */
int OSMachineID(void);

/**
 * Waits n milliseconds on the robot's clock; timers go on. Below 0 counts as 0. So do sleep(),
 * usleep() and nanosleep() once the program has called RoBIOS.
 */
int OSWait(int n);
/**
 * Calls fct every `scale` milliseconds on the robot's clock until OSDetachTimer(). The function may
 * call RoBIOS. In real time it has a thread of its own; in virtual time it is called between two
 * calls of the program, in whose thread it must not wait for a mutex; when the program has only
 * computed for a second (in an empty loop, say) it is called without that, in another thread.
 * Returns a handle, 0 on failure (null function, scale below 1). There may be any number of timers.
 */
TIMER OSAttachTimer(int scale, void (*fct)(void));
/** Ends a timer. 1 for an unknown handle. */
int OSDetachTimer(TIMER t);
/**
 * Time of day: hours, minutes, seconds and thousandths of a second (one header says 1/100 s; every
 * program counts in 1/1000 s). Virtual time starts at midnight. Null pointers are left out.
 */
int OSGetTime(int* hrs, int* mins, int* secs, int* ticks);
/**
 * Sets the time of day that OSGetTime() tells this program. 1 for what is no time of day. (Of an
 * older header; later ones do not have it.)
 */
int OSSetTime(int hrs, int mins, int secs);
/**
 * Milliseconds since the program started (one header says 1/100 s). After 24.8 days it goes on from
 * -2147483648, so that differences of two counts stay right.
 */
int OSGetCount(void);

#endif
