/** Types and constants of classic RoBIOS. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_CLASSIC_TYPES_H
#define EYEBRIDGE_CLASSIC_TYPES_H

typedef unsigned char BYTE;
typedef int BOOL;
#ifndef TRUE
#define TRUE 1
#endif
#ifndef FALSE
#define FALSE 0
#endif

/* Images: a picture of 80 x 60 pixels with a border of one pixel, [row][column], top-left first. */
#define imagecolumns 82
#define imagerows 62
/** One grey byte a pixel, 0 black … 255 white. */
typedef BYTE image[imagerows][imagecolumns];
/** R, G, B a pixel. */
typedef BYTE colimage[imagerows][imagecolumns][3];

/**
 * Which device is meant: a number of eyebridge_classic/semantics.h or of the robot's file, or, in
 * programs of the M6, a name ("PSD_FRONT"). Wide enough for both, so that C programs may pass
 * either; numbers fit into an int.
 */
typedef long DeviceSemantics;
/** Category of an entry of the hardware description table. */
typedef int TypeID;

/* Handles are masks of one bit each: they can be added or OR-ed where a function says so. 0: none. */
typedef int PSDHandle;
typedef int ServoHandle;
typedef int MotorHandle;
typedef int QuadHandle;
typedef int BumpHandle;
typedef int IRHandle;
typedef int VWHandle;
typedef int TimerHandle;
typedef void (*TimerFnc)(void);
/* As the M6 spells them. */
typedef int SERVOHandle;
typedef int MOTORHandle;
typedef int QUADHandle;
typedef int CAMHandle;

typedef float meter;
typedef float radians;
typedef float meterPerSec;
typedef float radPerSec;

/** A pose: metres, radians. */
typedef struct {
  meter x;
  meter y;
  radians phi;
} PositionType;

/** A speed: metres and radians per second. */
typedef struct {
  meterPerSec v;
  radPerSec w;
} SpeedType;

/** A note: hertz, milliseconds. */
typedef struct {
  int freq;
  int len;
} tone;

/* Keys, left to right. The manuals give no numbers: those of the M6, so that they can be OR-ed. */
#define KEY1 1
#define KEY2 2
#define KEY3 4
#define KEY4 8
#define NOKEY 0
#define ANYKEY 0xFFFFFFFF

/** A line end, for LCDPutChar(). */
#define NL '\n'

/* Flags of LCDMode(); their numbers are our choice. */
#define SCROLLING 1
#define NONSCROLLING 0
#define CURSOR 2
#define NOCURSOR 0

/* Argument of CAMInit(); all mean the same. */
#define NORMAL 0
#define WIDE 1
#define TELE 2

/* What CAMInit() returns: a version, which is a colour camera's from COLCAM on, or a failure. */
#define COLCAM 16
#define INITERROR 200
#define NOCAM 255
/** Ticks between two attempts of CAMInit(). */
#define CAMWAIT 10

/* Frame rates of CAMSet(), each half as fast as the one before. */
#define FPS60 0
#define FPS30 1
#define FPS15 2
#define FPS7_5 3
#define FPS3_75 4
#define FPS1_875 5
#define FPS0_9375 6
#define FPS0_46875 7

#define AUTOBRIGHTNESS 1
#define NOAUTOBRIGHTNESS 0

/* Modes of OSMTInit() and results of OSMTStatus(). */
#define COOP 0
#define DEFAULT 0
#define PREEMPT 1
#define NOTASK 255

/* Priorities of tasks: higher goes first. */
#define IDLE_PRI 0
#define MIN_PRI 1
#define MAX_PRI 8

#define IDLE_STACKSIZE 128
#define SMALL_STACKSIZE 2048
#define DEFAULT_STACKSIZE 4096

/* States of a task (struct tcb). */
#define TASK_NEW 0
#define TASK_READY 1
#define TASK_SUSPEND 2
#define TASK_RUNNING 3

/* What OSMachineType() returns. */
#define VEHICLE 1
#define PLATFORM 2
#define WALKER 3

/* Serial interfaces, baud rates and handshakes of OSInitRS232(); their numbers are our choice. */
#define SERIAL1 1
#define SERIAL2 2
#define SERIAL3 3
#define SER4800 0
#define SER9600 1
#define SER19200 2
#define SER38400 3
#define SER57600 4
#define SER115200 5
#define NONE 0
#define RTSCTS 1

/* Words and their bytes (a is the upper one) of OSGetVar() and OSPutVar(). */
#define SAVEVAR1 1
#define SAVEVAR2 2
#define SAVEVAR3 3
#define SAVEVAR4 4
#define SAVEVAR1a 11
#define SAVEVAR1b 12
#define SAVEVAR2a 21
#define SAVEVAR2b 22
#define SAVEVAR3a 31
#define SAVEVAR3b 32
#define SAVEVAR4a 41
#define SAVEVAR4b 42

/** What a PSD reads where it sees nothing, millimetres. */
#define PSD_OUT_OF_RANGE 9999

/** Bytes of the longest radio message. The manuals do not agree; this is our choice. */
#define MAXMSGLEN 35
/** Receiver of RADIOSend(): all others. (The host computer is 0.) */
#define BROADCAST 255

/* Kinds of signals and modes of IRTVInit(). */
#define RAW_CODE 0
#define SPACE_CODE 1
#define PULSE_CODE 2
#define MANCHESTER_CODE 3
#define DEFAULT_MODE 0
#define SLOPPY_MODE 1
#define REPCODE_MODE 2

#endif
