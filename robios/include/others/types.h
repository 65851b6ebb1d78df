/** EyeSim's header of this name, which its eyebot.h includes; so do programs. All of it is in
 * eyebot.h. */
#include <eyebot.h>
