/** The ROM's own demos include "include/eyebot.h". */
#include "../eyebot.h"
