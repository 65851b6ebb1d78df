/** Where RoBIOS kept the names of devices (RoBIOS 1 and 2); here it is part of eyebot.h. */
#include "eyebot.h"
