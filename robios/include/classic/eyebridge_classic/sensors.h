/**
 * Distance sensors, bumpers, infrared switches, compass. Part of eyebot.h; do not include directly.
 */
#ifndef EYEBRIDGE_CLASSIC_SENSORS_H
#define EYEBRIDGE_CLASSIC_SENSORS_H

/** Opens a distance sensor; 0 when there is none, or it is open already, and beyond 8. */
PSDHandle PSDInit(DeviceSemantics semantics);
/** Stops and closes all. (The M6 closes the one that is given: in C a macro of m6.h tells.) */
int(PSDRelease)(void);
/**
 * Measures with the sensors of the mask: once, or again and again every 60 ms (`cycle`), to which
 * more sensors can be added. 0, or 1 while a single measurement is under way, -1 for a wrong handle.
 */
int PSDStart(PSDHandle bitmask, BOOL cycle);
/** Ends what PSDStart() began, after the running measurement. */
int PSDStop(void);
/** TRUE when the first measurement after PSDStart() is done. */
BOOL PSDCheck(void);
/**
 * Distance in millimetres, PSD_OUT_OF_RANGE when nothing is within reach; of a sensor that was not
 * started a new one (our choice: programs for simulators start none). Handle 0: the tick at which
 * the last measurement began. -1 for a wrong handle or a sensor that does not answer.
 */
int PSDGet(PSDHandle handle);
/** The same before conversion to millimetres. */
int PSDGetRaw(PSDHandle handle);

/** Opens a bumper; 0 as PSDInit(), and beyond 16. */
BumpHandle BUMPInit(DeviceSemantics semantics);
/** Closes those of the mask: 0, or as SERVORelease(). */
int BUMPRelease(BumpHandle handle);
/**
 * 0: it was hit since it was asked last; `timestamp`, unless NULL, is when, in microseconds (their
 * unit is not documented; 32 bits). -1: it was not, or a wrong handle; then `timestamp` is 0.
 */
int BUMPCheck(BumpHandle handle, int* timestamp);

/** Opens an infrared switch; 0 as PSDInit(), and beyond 16. */
IRHandle IRInit(DeviceSemantics semantics);
/** Closes those of the mask: 0, or as SERVORelease(). */
int IRRelease(IRHandle handle);
/** 1: something is near (our choice: it depends on the wiring), 0: nothing; -1 wrong handle. */
int IRRead(IRHandle handle);

/** Opens the compass: 0, or 1 when there is none. */
int COMPASSInit(DeviceSemantics semantics);
/** Measures once, or again and again (`cycle`), 100 ms each. 1 when it does so already. */
int COMPASSStart(BOOL cycle);
/** 1 when there is a result, else 0. */
int COMPASSCheck(void);
/** Waits for the end of the running measurement and stops. */
int COMPASSStop(void);
int COMPASSRelease(void);
/**
 * 0 … 359 degrees clockwise from north, which is the world's +y axis (our choice); -1 when there is
 * no result yet.
 */
int COMPASSGet(void);
/** 0 forgets a calibration, 1 calibrates: has no effect here. 1 for another mode. */
int COMPASSCalibrate(int mode);

#endif
