// Programs of before 2018 number the sensors themselves.
#include <eyebot.h>
#define PSD_LEFT 1
#define PSD_FRONT 2

int redefined_front(void);
int redefined_front(void) { return PSD_FRONT * 10 + PSD_LEFT; }
