/** Where RoBIOS kept the infrared remote control; here it is part of eyebot.h. */
#include "eyebot.h"
