/** Camera and image processing. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_CLASSIC_VISION_H
#define EYEBRIDGE_CLASSIC_VISION_H

/**
 * Starts the camera, an EyeCam: NORMAL, WIDE and TELE are the same. Returns its version, 17, or NOCAM
 * when there is none. The frame rate is FPS7_5. In programs of the M6 `mode` is a camera's name, and
 * what is returned its handle.
 */
int CAMInit(long mode);
/** -1 when it is not initialised. (The M6 gives a handle, which C ignores.) */
int CAMRelease();
/**
 * Waits for the next frame, in grey. All these fail with 1, and write nothing, when the camera is not
 * initialised or lost, and for NULL.
 */
int CAMGetFrame(image* buf);
/**
 * Waits for the next frame, in colour. With `convert` it is an `image`, in grey, that is written:
 * CAMGetColFrame((colimage*)&grey, 1).
 */
int CAMGetColFrame(colimage* buf, int convert);
/** A grey frame in full resolution: CAMGet() says how much, here 82 x 62. */
int CAMGetFrameMono(BYTE* buf);
/**
 * A frame in full resolution, R, G, B a pixel; 82 x 62 here. The M6 gives a handle first:
 * CAMGetFrameRGB(camera, buf).
 */
int CAMGetFrameRGB(void* buf, ...);
/** As the sensor has it, a byte a pixel: rows R G R G … and G B G B … by turns. */
int CAMGetFrameBayer(BYTE* buf);
/**
 * `p1` is a frame rate, FPS15 or slower: others are not supported, and the result is 1. The others
 * are brightness and contrast of cameras before the EyeCam, and have no effect.
 */
int CAMSet(int p1, int p2, int p3);
/** Frame rate, full width and height; NULL for what is not wanted. */
int CAMGet(int* p1, int* p2, int* p3);
/** AUTOBRIGHTNESS or NOAUTOBRIGHTNESS; has no effect, the camera decides. 1 for another mode. */
int CAMMode(int mode);

/*
 * Images of 82 x 62; all fail with 1 for NULL and where source and destination are the same. The
 * border of a result means nothing.
 */

/** Edges: |4 centre - neighbours|, at most 255. */
int IPLaplace(image* src, image* dest);
/** Edges: (|Gx| + |Gy|) / 3 by the 3 x 3 masks 1 2 1, at most 255. */
int IPSobel(image* src, image* dest);
/** Black and white by a 2 x 2 pattern of thresholds: 51, 153 and 204, 102. */
int IPDither(image* src, image* dest);
/** |current - last|. */
int IPDiffer(image* current, image* last, image* dest);
/** The mean of red, green and blue. */
int IPColor2Grey(colimage* src, image* dest);

#endif
