/** RoBIOS-7 for C++ programs: the same as eyebot.h, under the name that C++ programs include. */
#ifndef EYEBOT_PLUSPLUS_H
#define EYEBOT_PLUSPLUS_H

#include "eyebot.h"

#endif
