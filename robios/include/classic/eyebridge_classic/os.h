/** The system, time, and serial lines. Part of eyebot.h; do not include directly. */
#ifndef EYEBRIDGE_CLASSIC_OS_H
#define EYEBRIDGE_CLASSIC_OS_H

/** "6.5". */
char* OSVersion(void);
/**
 * Shows message and number. With `deadend` the program ends with exit code 1 (the robot stops there
 * for good), else it waits for a key.
 */
int OSError(const char* msg, int number, BOOL deadend);
/** VEHICLE. (Demos of RoBIOS 6.3 take it for the version of the hardware.) */
int OSMachineType(void);
/** 25000000 hertz, of the 68332. */
int OSMachineSpeed(void);
/** The robot's name as its file has it; "EyeBot" where none does. */
char* OSMachineName(void);
/**
 * The robot's number, 1 … n; its digit ('1' …) with the setting id_as_ascii, for programs after the
 * paper on EyeSim, which compare it with characters.
 */
unsigned char OSMachineID(void);
/** An entry of the hardware description: for drivers only. NULL. */
void* HDT_FindEntry(TypeID typeid_, DeviceSemantics semantics);
/** Lets timers and preemption go on … */
int OSEnable(void);
/** … and holds them: what came due meanwhile is made up for once. */
int OSDisable(void);
/**
 * Variables that last longer than a program on the robot, here as long as the program: SAVEVAR1 … 4
 * are words, 0 … 65535, SAVEVAR1a, SAVEVAR1b … their bytes. -1 for another number.
 */
int OSGetVar(int num);
/** 1 for another number, and for a value that does not fit. */
int OSPutVar(int num, int value);

/* Of the boot loader, not for programs: Unsupported, all return 1. */
int OSDownload(char* name, int* bytes, int baud, int handshake, int interface);
int OSExecute(char* name);
int USRStart(void);
int USRResident(char* name, BOOL mode);

/** Sets the clock of OSGetTime(); 1 unless 0 <= hrs < 24, 0 <= mins < 60, 0 <= secs < 60. */
int OSSetTime(int hrs, int mins, int secs);
/**
 * Time of day and ticks, 0 … 99; NULL for what is not wanted. In virtual time the day begins with the
 * program.
 */
int OSGetTime(int* hrs, int* mins, int* secs, int* ticks);
/** Prints the time at the cursor: "12:34:56". */
int OSShowTime(void);
/** Ticks since the program's start; 32 bits, which wrap around after 248 days. */
int OSGetCount(void);
/** Waits `n` ticks; nothing for n <= 0. Tasks of other priorities go on under preemption. */
int OSWait(int n);
/**
 * Calls `function` every `scale` ticks until OSDetachTimer(). Returns a handle; 0 for scale < 1, for
 * NULL, and beyond 16 timers.
 */
TimerHandle OSAttachTimer(int scale, TimerFnc function);
/** 1 when it is removed, 0 for an invalid handle. */
int OSDetachTimer(TimerHandle handle);

/*
 * Serial lines: SERIAL1 … SERIAL3 are the interfaces 0 … 2 of the setting `serial`. All return 10 for
 * another interface and one that is not there.
 */

/** 8 for an illegal baud rate. */
int OSInitRS232(int baud, int handshake, int interface);
/** 3 when the byte could not be sent within a second. */
int OSSendCharRS232(char chr, int interface);
/** The same by pointer, as old programs do it. */
int OSSendRS232(char* chr, int interface);
/** Waits for a byte, at most a second: 0 stored, 1 none came, 2 the line is gone, or NULL. */
int OSRecvRS232(char* buf, int interface);
/** Forgets what has come. */
int OSFlushInRS232(int interface);
/** Nothing waits here to be sent: 0. */
int OSFlushOutRS232(int interface);
/** Bytes that wait; -254 (0xffffff02) when the line is gone, -246 (0xffffff0a): no interface. */
int OSCheckInRS232(int interface);
/** Bytes not sent yet: 0, or as OSCheckInRS232(). */
int OSCheckOutRS232(int interface);

#endif
