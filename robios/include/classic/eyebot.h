/**
 * Classic RoBIOS (EyeBot Mk1 to Mk5, RoBIOS 1 to 6, and what programs of the EyeBot M6 need), for C
 * and C++.
 *
 * Unless a function says otherwise: it returns 0 on success and non-zero on failure, may be called
 * from any thread, and returns at once; times are ticks of 1/100 s, driving is in metres and radians
 * (counter-clockwise positive), distances that sensors measure are millimetres. The reason of the
 * last failure: EYEBRIDGELastError() in eyebridge.h. Where the manuals leave something open, the
 * comment says "our choice".
 */
#ifdef EYEBOT_H
#error "eyebot.h of RoBIOS-7 and of classic RoBIOS in one source: use one, by eyebridge-cc or eyebridge-cc --classic"
#endif
#ifndef EYEBOT_CLASSIC_H
#define EYEBOT_CLASSIC_H

/*
 * Only these two: the names of math.h and string.h (y1, index) are those of many a program's own
 * variables, and C programs that need the functions include them or get along without.
 */
#include <stdio.h>
#include <stdlib.h>

#include "eyebridge_classic/types.h"

#include "eyebridge_classic/semantics.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

#include "eyebridge_classic/audio.h"
#include "eyebridge_classic/io.h"
#include "eyebridge_classic/lcd.h"
#include "eyebridge_classic/m6.h"
#include "eyebridge_classic/motion.h"
#include "eyebridge_classic/os.h"
#include "eyebridge_classic/radio.h"
#include "eyebridge_classic/sensors.h"
#include "eyebridge_classic/tasks.h"
#include "eyebridge_classic/vision.h"

#pragma GCC visibility pop
#ifdef __cplusplus
}
#include "eyebridge_classic/m6_overloads.h"
#endif

#endif
