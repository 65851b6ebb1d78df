#ifndef IMGTOOLS_H
#define IMGTOOLS_H
#include "eyebot.h"

typedef struct { int x, y, n; } Blob;

extern int threshold;
Blob find_colour(BYTE *img, int hue);
void cross(int x, int y, COLOR c);
#endif
