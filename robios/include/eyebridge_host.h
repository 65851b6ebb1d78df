/**
 * For interpreters that run robot programs, as Python's module `eye` does: what the library has to
 * know of them. C and C++; independent of eyebot.h. Robot programs need nothing of it.
 */
#ifndef EYEBRIDGE_HOST_H
#define EYEBRIDGE_HOST_H

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/**
 * Tells of the interpreter, before the first RoBIOS call. `program` is the file of the robot
 * program, beside which eyebridge.toml is looked for; null or "" when it has none.
 *
 * interrupted(): Ctrl-C came, and the process had a handler for it when the session began. 1: that
 * handler shall have it, in the main thread; 0: the library stops the motors, writes the results
 * and ends the process. ending(): the run ends, the motors are stopped, and the process ends
 * without the interpreter's own end: the moment to write what is still buffered. Both are called
 * from any thread, may be null, and are not called any more once EYEBRIDGEHostEnd() has returned.
 */
void EYEBRIDGEHostBegin(const char* program, int (*interrupted)(void), void (*ending)(void));

/**
 * After EYEBRIDGEHostBegin(), before the program does anything: `argv` are `argc` words, the file
 * of the robot program and its arguments. Where the settings want several robots, this process
 * becomes the one that starts the program for each of them, by the first python3 in PATH, which
 * begins with the folder of the file `interpreter` then. Returns where they want one.
 */
void EYEBRIDGEHostStart(int argc, const char* const* argv, const char* interpreter);

/**
 * The interpreter ends: stops the motors, writes the results, and returns when no timer's function
 * runs any more. Does nothing when no RoBIOS call was ever made; never returns when a signal or a
 * time limit is ending the process.
 */
void EYEBRIDGEHostEnd(void);

/**
 * Waits on the robot's clock, as OSWait() does, and returns 1; returns 0 at once when the robot
 * lives in wall time, where the interpreter waits as it is used to.
 */
int EYEBRIDGEHostWait(long long nanoseconds);

/**
 * Nanoseconds since the start on the robot's clock, at the cost of OSGetCount(); -1 when the robot
 * lives in wall time.
 */
long long EYEBRIDGEHostNow(void);

/**
 * The interpreter is about to start a thread of the program: what the following take, or null where
 * the robot lives in wall time. In virtual time threads take turns, and time waits for this one.
 * Begins the robot's life there, as a call would. The caller keeps its turn, whatever it waits for,
 * until EYEBRIDGEHostThreadStarted().
 */
void* EYEBRIDGEHostThreadExpected(void);

/**
 * What that thread calls first; returns when it is its turn. Null is nothing.
 */
void EYEBRIDGEHostThreadStarts(void* expected);

/**
 * It could not be started. Null is nothing.
 */
void EYEBRIDGEHostThreadFailed(void* expected);

/**
 * What the one that made it calls last, also when that failed. Null is nothing.
 */
void EYEBRIDGEHostThreadStarted(void* expected);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
