/** What EyeBridge offers to programs beyond RoBIOS-7. C and C++; independent of eyebot.h. */
#ifndef EYEBRIDGE_H
#define EYEBRIDGE_H

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/**
 * Why the last RoBIOS call of this program that failed did so: one line of text, without line end.
 * "" when none has failed. The text stays valid until the calling thread asks again. Any thread.
 */
const char* EYEBRIDGELastError(void);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
