/** What EyeBridge offers beyond RoBIOS, for programs of both generations. */
#include "../eyebridge.h"
