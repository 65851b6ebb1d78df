/** SIM: the simulated world. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_SIM_H
#define EYEBRIDGE_ROBIOS_SIM_H

/*
 * True poses in the world: mm from its lower-left corner, phi in degrees, 0 along x,
 * counter-clockwise, both when set and when read. Ids count from 1 in the order of the simulation
 * file; id 0 is the caller's own robot. z is how far the underside of a submarine is above the
 * floor, in mm; values outside the water are clamped to the floor or the surface. For all other
 * robots and objects z reads as 0 and is ignored when set. All fail with 1 on a real robot (older
 * headers return void) and for an unknown id; reading then gives zeros. Null pointers are left out.
 */

/** Pose of a robot. */
int SIMGetRobot(int id, int* x, int* y, int* z, int* phi);
/** Puts a robot to a pose. */
int SIMSetRobot(int id, int x, int y, int z, int phi);
/** Pose of an object: a ball, a can, a box, a polygon. */
int SIMGetObject(int id, int* x, int* y, int* z, int* phi);
/** Puts an object to a pose. */
int SIMSetObject(int id, int x, int y, int z, int phi);
/** Number of robots in the world. */
int SIMGetRobotCount(void);
/** Number of objects in the world. */
int SIMGetObjectCount(void);
/**
 * Fills scan[0 … 359] with distances in mm, all round: scan[0] is the front, scan[i] the ray i
 * degrees counter-clockwise (unlike LIDARGet()). Of 2017; not in any published header.
 */
int SIMLaserScan(int* scan);

#endif
