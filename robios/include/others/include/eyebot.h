/** Demos include "include/eyebot.h". */
#include <eyebot.h>
