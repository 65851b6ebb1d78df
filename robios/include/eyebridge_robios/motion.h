/** SERVO, MOTOR, VW: what moves the robot. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_ROBIOS_MOTION_H
#define EYEBRIDGE_ROBIOS_MOTION_H

/**
 * Sets servo 1..14 to a position 0..255, 128 in the middle (0 is a position in simulation, power
 * off on a robot). Servo 1 pans and 2 tilts the camera; a simulated robot has only these two, and
 * those that kick or steer. 1 for a servo that the robot does not have and for positions outside.
 */
int SERVOSet(int servo, int angle);
/** As SERVOSet(), past the robot's table. */
int SERVOSetRaw(int servo, int angle);
/**
 * Pulse lengths of positions 0 and 255, in 1/100 ms: 0 <= low < high <= 255, else 1. Nothing
 * changes in simulation, as in EyeSim.
 */
int SERVORange(int servo, int low, int high);

/**
 * Drives motor 1..4 with -100..100 percent, more counts as 100; 1 is left and 2 right on a
 * differential robot (others: docs/drives.md). 1 for a motor it does not have, here and below.
 */
int MOTORDrive(int motor, int speed);
/** As MOTORDrive(), past the robot's table. */
int MOTORDriveRaw(int motor, int speed);
/** Parameters of the speed controller, 0..255 each; 4, 1, 1 unless set. */
int MOTORPID(int motor, int p, int i, int d);
/** Switches the speed controller of a motor off. */
int MOTORPIDOff(int motor);
/**
 * Drives a motor at a controlled speed in encoder ticks per 1/100 second, -128..127 (the sources
 * disagree on the unit; this is the I/O board's). 1 for values outside.
 */
int MOTORSpeed(int motor, int ticks);

/*
 * V-omega driving. All but VWWait() return at once; a new command replaces the one under way. The
 * signs of distances and angles give the direction, of speeds only the magnitude counts (except
 * VWSetSpeed). Speed 0 moves nothing and counts as done.
 */

/**
 * Drives with mm/s (forward positive) and deg/s (left positive) until the next command. EyeSim's
 * robots take a new speed at once, these by 1 m/s and 573 deg/s a second unless their .robi file
 * says `accel`.
 */
int VWSetSpeed(int linSpeed, int angSpeed);
/** Measured speeds, mm/s and deg/s. Null pointers are left out, here and below. */
int VWGetSpeed(int* linSpeed, int* angSpeed);
/** Declares the present pose to be x, y in mm, phi in degrees; the robot does not move. */
int VWSetPosition(int x, int y, int phi);
/** Pose by odometry: mm, mm, degrees in -180..180. */
int VWGetPosition(int* x, int* y, int* phi);
/** Drives dist mm straight on; backwards when dist is negative. */
int VWStraight(int dist, int lin_speed);
/** Turns on the spot by angle degrees, left when positive; may exceed 360. */
int VWTurn(int angle, int ang_speed);
/**
 * Drives an arc of dist mm while turning by angle degrees. Backwards when dist is negative; the
 * heading then changes by -angle, as in EyeSim. dist 0 moves nothing.
 */
int VWCurve(int dist, int angle, int lin_speed);
/** Drives an arc to the point dx ahead and dy to the left, mm. 1 unless dx >= |dy|, and nothing
 * changes then. */
int VWDrive(int dx, int dy, int lin_speed);
/** Distance still to go, in mm; 0 for turns and when nothing is under way. */
int VWRemain(void);
/** 1 when the command is finished or there is none, 0 while driving, -1 on failure. */
int VWDone(void);
/** Waits until the command is finished; at once if there is none. 1 when the robot is stuck. */
int VWWait(void);
/** Motors that are stuck: 0 none, 1 left, 2 right, 3 both. */
int VWStalled(void);
/**
 * Switches v-omega control on, the robot standing, with gains of the v and w controllers: 70, 30,
 * 70, 10 are typical, 0..255 are accepted, else 1. It is on already when a program starts.
 * Simulated robots and our host-side controller regulate by themselves, and no board is known to
 * take gains: they change nothing.
 */
int VWControl(int Vv, int Tv, int Vw, int Tw);
/** Switches v-omega control off: the wheels stop, until the next MOTOR or VW command. */
int VWControlOff(void);

/* Old names of VWRemain(), VWDone() and VWWait(). */
int VWDriveRemain(void);
int VWDriveDone(void);
int VWDriveWait(void);

#endif
