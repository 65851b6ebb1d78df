/** Where RoBIOS kept the names of devices; here it is part of eyebot.h. */
#include "eyebot.h"
