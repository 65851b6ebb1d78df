/** CAM, IP: camera and image processing. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_VISION_H
#define EYEBRIDGE_ROBIOS_VISION_H

/* Size of camera frames, set by CAMInit(): pixels, pixels, pixels in all, bytes of a colour frame.
 */
extern int CAMWIDTH, CAMHEIGHT, CAMPIXELS, CAMSIZE;
extern int CAMMODE;
extern int CAM_INITIAL;
/* Size of the images that IP functions work on, set by CAMInit() and IPSetSize(). */
extern int IP_WIDTH, IP_HEIGHT, IP_PIXELS, IP_SIZE;

/**
 * Starts the camera in a mode (QQVGA, QVGA, VGA …) and sets CAMWIDTH and friends, the size for IP
 * functions and for LCDImage(). May be called again at any time. 0; 1 without a camera or with a
 * mode that it cannot do. (One manual says non-zero is success; programs and CAM_SUCCESS say 0.)
 */
int CAMInit(int resolution);
/** Stops the camera. 0. */
int CAMRelease(void);
/** Waits for the next colour frame: CAMSIZE bytes R, G, B. 1 when CAMInit() was not
 * called, after CAMRelease(), and for a null pointer. */
int CAMGet(BYTE* buf);
/** Waits for the next frame in grey: CAMPIXELS bytes. Fails as CAMGet(). */
int CAMGetGray(BYTE* buf);

/** Mode of the images that IP functions work on; QVGA at the start. 1 for an unknown mode. */
int IPSetSize(int resolution);
/**
 * Reads a PNM file (P1..P6) into an image of IP_WIDTH x IP_HEIGHT, top-left aligned: a smaller file
 * is filled up with 0, a larger one cut. Returns 3 for colour (3 bytes a pixel in img), 2 for grey,
 * 1 for black and white (both one byte a pixel; set bits of a bitmap become 1), whether text or
 * binary (the sources disagree on binary ones; this is the page's meaning), -1 on failure.
 */
int IPReadFile(const char* filename, BYTE* img);
/** Writes a colour image of the IP size as binary PPM. */
int IPWriteFile(const char* filename, BYTE* img);
/** Writes a grey image of the IP size as binary PGM. */
int IPWriteFileGray(const char* filename, BYTE* gray);
/** |4 centre - N - S - E - W|, at most 255. The outermost pixels of grayOut are not written. */
void IPLaplace(BYTE* grayIn, BYTE* grayOut);
/** (|Gx| + |Gy|) / 3, at most 255. First and last row 0; first and last column not written. */
void IPSobel(BYTE* grayIn, BYTE* grayOut);
/** Grey = integer mean of R, G and B. */
void IPCol2Gray(BYTE* imgIn, BYTE* grayOut);
/** R = G = B = grey. */
void IPGray2Col(BYTE* imgIn, BYTE* colOut);
/** Three planes, one byte a pixel, to one colour image. */
void IPRGB2Col(BYTE* r, BYTE* g, BYTE* b, BYTE* imgOut);
/** Hue, saturation and intensity planes; see IPPRGB2HSI(). */
void IPCol2HSI(BYTE* img, BYTE* h, BYTE* s, BYTE* i);
/** c1 where c2 is black (0,0,0), else c2. */
void IPOverlay(BYTE* c1, BYTE* c2, BYTE* cOut);
/** Colour image: g1 as grey where g2 is 0, else col. */
void IPOverlayGray(BYTE* g1, BYTE* g2, COLOR col, BYTE* cOut);
/** 0xRRGGBB. */
COLOR IPPRGB2Col(BYTE r, BYTE g, BYTE b);
/** The three bytes of 0xRRGGBB; null pointers are left out, here and below. */
void IPPCol2RGB(COLOR col, BYTE* r, BYTE* g, BYTE* b);
void IPPCol2HSI(COLOR c, BYTE* h, BYTE* s, BYTE* i);
/**
 * Hue 1..255, or 0 for grey: red 43, green 128, blue 213. Grey is what has 2 (max - min) <= max or
 * an intensity of at most 10.
 */
BYTE IPPRGB2Hue(BYTE r, BYTE g, BYTE b);
/** Hue as above; saturation 255 - 255 min / intensity (0 for black); intensity mean of R, G, B. */
void IPPRGB2HSI(BYTE r, BYTE g, BYTE b, BYTE* h, BYTE* s, BYTE* i);

#endif
