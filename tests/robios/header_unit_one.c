// One of two C99 sources of a program; the variables live in the library, here played by this file.
#include <eyebridge.h>

#include <eyebot.h>

int CAMWIDTH = 17;
int CAMHEIGHT, CAMPIXELS, CAMSIZE, CAMMODE, CAM_INITIAL;
int IP_WIDTH, IP_HEIGHT, IP_PIXELS, IP_SIZE;
int LCD_INITIAL, LIDAR_RESOLUTION;
int IM_TYPE, IM_LEFT, IM_TOP, IM_WIDTH, IM_LENGTH;

int width_seen_in_unit_one(void);
int width_seen_in_unit_one(void) { return CAMWIDTH; }
