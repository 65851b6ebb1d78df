/** Servos, motors, encoders, driving. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_CLASSIC_MOTION_H
#define EYEBRIDGE_CLASSIC_MOTION_H

/** Opens a servo; 0 when there is none, or it is open already. */
ServoHandle SERVOInit(DeviceSemantics semantics);
/**
 * Closes the servos of the mask. 0x11110000 when none of its bits is an open one, else a mask of
 * those that are, when not all are; in both cases none is closed.
 */
int SERVORelease(ServoHandle handle);
/** Turns the servos of the mask to 0 … 255, 128 is the middle. -1 for a wrong handle or angle. */
int SERVOSet(ServoHandle handle, int angle);

/** Opens a motor; 0 as SERVOInit(), and when it belongs to an open VW drive. */
MotorHandle MOTORInit(DeviceSemantics semantics);
/** Stops and closes those of the mask: 0, or as SERVORelease(). */
int MOTORRelease(MotorHandle handle);
/** Drives those of the mask at -100 … 100 % (beyond: as these). -1 for a wrong handle. */
int MOTORDrive(MotorHandle handle, int speed);

/** Opens an encoder; 0 as MOTORInit(), and beyond 8. */
QuadHandle QUADInit(DeviceSemantics semantics);
/** Closes those of the mask: 0, or -1 for a wrong handle. */
int QUADRelease(QuadHandle handle);
/** Sets those of the mask to 0; -1 for a wrong handle. QUADODORead() does not notice. */
int QUADReset(QuadHandle handle);
/** Ticks; 0 for a wrong handle, too. */
int QUADRead(QuadHandle handle);
/** The motor of an encoder: MOTOR_LEFT of QUAD_LEFT … 0 for no encoder. */
DeviceSemantics QUADGetMotor(DeviceSemantics semantics);
/** Metres driven since the last reset, backwards counted off; 0 for a wrong handle, too. */
float QUADODORead(QuadHandle handle);
/** Begins to count anew for those of the mask; -1 for a wrong handle. */
int QUADODOReset(QuadHandle handle);

/*
 * The v-omega drive. A new command replaces the running one. Speeds of movements are taken by
 * magnitude; those beyond the robot's are its fastest. -1 for a wrong handle, a drive that does not
 * answer and numbers that are not finite.
 */

/**
 * Opens the drive, of which there is one, and with it its two motors and encoders; the robot's
 * position is 0, 0, 0. `Timescale`, the period of its control in ticks, must be 1 or more. 0 when
 * there is none, or it, one of its motors or encoders is open already.
 */
VWHandle VWInit(DeviceSemantics semantics, int Timescale);
/** Stops the robot and closes the drive. */
int VWRelease(VWHandle handle);
/** Drives at metres and radians per second until the next command. */
int VWSetSpeed(VWHandle handle, meterPerSec v, radPerSec w);
/** Speed as measured. */
int VWGetSpeed(VWHandle handle, SpeedType* vw);
int VWSetPosition(VWHandle handle, meter x, meter y, radians phi);
/** Position by odometry; phi is in (-pi, pi]. */
int VWGetPosition(VWHandle handle, PositionType* pos);
/**
 * Starts the control of the wheels. It is always on here, and gains have no effect, but must be
 * finite, not negative, and Tv and Tw more than 0.
 */
int VWStartControl(VWHandle handle, float Vv, float Tv, float Vw, float Tw);
/** Stops it: has no effect here. */
int VWStopControl(VWHandle handle);
/** `delta` metres, backwards when negative. Returns at once. */
int VWDriveStraight(VWHandle handle, meter delta, meterPerSec v);
/** `delta` radians on the spot. Returns at once. */
int VWDriveTurn(VWHandle handle, radians delta, radPerSec w);
/** An arc `delta_l` metres long, on which the heading changes by `delta_phi`. Returns at once. */
int VWDriveCurve(VWHandle handle, meter delta_l, radians delta_phi, meterPerSec v);
/** Metres to go, of a turn on the spot radians; 0 when it is done, and for a wrong handle. */
float VWDriveRemain(VWHandle handle);
/** 1 when the movement is over: done, or given up behind an obstacle; 0 while it is not. */
int VWDriveDone(VWHandle handle);
/** Waits until the movement is over. */
int VWDriveWait(VWHandle handle);
/** 1 while an obstacle holds the robot, else 0. */
int VWStalled(VWHandle handle);

#endif
