/**
 * What programs of the EyeBot M6 (RoBIOS 0.6, 2008) call beyond classic RoBIOS. Part of eyebot.h; do
 * not include directly. Its functions take names where others take numbers: VWInit("VW_DRIVE", 1).
 */
#ifndef EYEBRIDGE_CLASSIC_M6_H
#define EYEBRIDGE_CLASSIC_M6_H

/* Screen and keys are there from the start: these do nothing. */
int LCDInit(void);
int LCDRelease(void);
int LCDRefresh(void);
int KEYInit(void);
int KEYRelease(void);
/** As LCDMode(); the flags of the M6 have no meaning here. 0. */
int LCDSetMode(int mode);
int LCDResetMode(int mode);
/** Black and white only: does nothing. */
int LCDTextColor(int fg, int bg, int mode);
/** A picture, R, G, B a pixel, dithered to black and white, at x, y; 1 for NULL or a size below 1. */
int LCDPutImageRGB(int x, int y, int xsize, int ysize, const void* data);
/** 1: there is no frame buffer to look into. */
int LCDGetFBInfo(void* info);
/** List menus: there are none. LCDGetList() gives NULL, the others 1. */
int LCDList(void* menu);
int LCDSetList(void* menu);
void* LCDGetList(void);

/** Waits for a touch and gives its place, pixels. 1 for NULL. */
int KEYGetXY(int* x, int* y);
/** 0. */
int KEYIdle(int idle);
/** Touch maps: there are none but the four keys. 1. */
int KEYSetTM(int mode);
/** 1, KEYTM_CLASSIC: four keys. */
int KEYGetTM(void* map);
int KEYSetRegion(int index, void* region);
int KEYGetRegion(int index, void* region);

/** As OSSetTime(); 1 for a date that does not exist. */
int OSSetDate(int day, int month, int year);
/** 1.1.2000 at first; NULL for what is not wanted. */
int OSGetDate(int* day, int* month, int* year);
/** Milliseconds, else as OSSleep(). */
void OSSleepms(int n);

/* Digital lines 0 … 15 in two banks of eight. 1 for what is not there. */
#define IOBANK0 0
#define IOBANK1 1
int OSLatchInit(void);
/** 0: inputs, 1: outputs. */
int OSLatchBankSetup(int banknum, int direction);
int OSLatchSetup(int latchnum, int direction);
/** 0 or 1; -1 for what is not there. */
int OSLatchRead(int latchnum);
int OSLatchWrite(int latchnum, int state);
int OSLatchCleanup(void);
/** Opens "ADC0" … and returns a handle; 0 when there is none. */
int OSInitADC(const char* name);
/** As OSGetAD(). */
int OSGetADC(int handle);
int OSADCRelease(int handle);

#ifndef __cplusplus
/** PSDRelease(handle) of the M6; closes all without a handle. */
int EYEBRIDGEPSDRelease(int given, PSDHandle handle);
#define PSDRelease(...) EYEBRIDGEPSDRelease(sizeof(#__VA_ARGS__) > 1, __VA_ARGS__ + 0)
#endif

#endif
