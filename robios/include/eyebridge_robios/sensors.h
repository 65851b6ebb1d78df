/** PSD, LIDAR, ENCODER: distance sensors and encoders. Part of eyebot.h; do not include directly.
 */
#ifndef EYEBRIDGE_ROBIOS_SENSORS_H
#define EYEBRIDGE_ROBIOS_SENSORS_H

/**
 * Distance in mm; psd is PSD_FRONT … or any number of the robot file (with the setting psd_numbers
 * 2015, 1 and 2 exchanged). Nothing within reach gives
 * the sensor's largest value, 9999 unless the robot file says otherwise. -1 for a sensor that the
 * robot does not have or has lost (EyeSim gives 0, which a near wall gives too); the reason is in
 * EYEBRIDGELastError().
 */
int PSDGet(int psd);
/** Raw value of the sensor. In simulation the same as PSDGet(). */
int PSDGetRaw(int psd);

/**
 * Number of values that LIDARGet() fills in: those of the robot file, 360 unless it says otherwise,
 * until LIDARSet(). Known once the program has called any function of this library.
 */
extern int LIDAR_RESOLUTION;
/**
 * Fills distance[0 … points-1], in mm, 9999 where nothing is hit. A full scan starts straight
 * behind and goes clockwise seen from above: of 360 values, 90 is left, 180 front, 270 right. A
 * part scan goes from its left end to its right end. Fails on a null pointer.
 */
int LIDARGet(int distance[]);
/**
 * Range 1..360 degrees centred on the front, tilt in degrees (positive down), number of points
 * (1..36000; a single one looks ahead). 1 for values outside; the shape then stays.
 */
int LIDARSet(int range, int tilt, int points);

/** Ticks of encoder 1..4 since the last reset; forward positive. 1 on failure (ambiguous). */
int ENCODERRead(int quad);
/** Sets an encoder to 0. */
int ENCODERReset(int quad);

#endif
