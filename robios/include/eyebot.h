/**
 * RoBIOS-7 for C programs; C++ programs may include this file or eyebot++.h, in any order.
 *
 * Unless a function says otherwise: it returns 0 on success and non-zero on failure, may be called
 * from any thread, returns at once, lengths are millimetres, angles degrees (counter-clockwise
 * positive) and times milliseconds. The reason of the last failure: EYEBRIDGELastError() in
 * eyebridge.h.
 */
#ifdef EYEBOT_CLASSIC_H
#error "eyebot.h of RoBIOS-7 and of classic RoBIOS in one source: use one, by eyebridge-cc or eyebridge-cc --classic"
#endif
#ifndef EYEBOT_H
#define EYEBOT_H

#ifdef __cplusplus
extern "C++" { /* programs that wrap this file in extern "C" themselves keep working */
#endif

/* Programs use these without including them, as the published header brings them in. */
#include <errno.h>
#include <math.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#ifdef __cplusplus
}
#endif

#include "eyebridge_robios/types.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#include "eyebridge_robios/comm.h"
#include "eyebridge_robios/io.h"
#include "eyebridge_robios/lcd.h"
#include "eyebridge_robios/motion.h"
#include "eyebridge_robios/os.h"
#include "eyebridge_robios/sensors.h"
#include "eyebridge_robios/sim.h"
#include "eyebridge_robios/vision.h"

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
