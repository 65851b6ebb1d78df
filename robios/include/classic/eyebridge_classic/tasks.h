/**
 * Multitasking and semaphores. Part of eyebot.h; do not include directly.
 *
 * One task runs at a time. OSMTInit() makes main() a task of the lowest priority, IDLE_PRI: it runs
 * when no other task is ready. COOP: tasks change only in OSReschedule(), OSYield(), OSSleep(),
 * OSSemP(), OSRun(), OSSuspend() of itself, OSKill() and OSExit(). PREEMPT: between OSPermit() and
 * OSForbid() also after 1/100 s, at the task's next call of RoBIOS; and a task that waits, for time, a
 * key, the end of a drive, gives way meanwhile. The ready task of highest priority is next, those of
 * the same priority by turns; one that was ready for a second without its turn gets one 1/100 s (the
 * ageing of the original is not documented; this is our choice). main() counts as MIN_PRI after it has
 * waited, until it gives way. In virtual time all this is the same in every run.
 *
 * When all tasks wait for each other for ever, the program ends with exit code 1 and says so. Where a
 * task is meant, 0 is the caller. 1 for what is no task, or one that has ended.
 */
#ifndef EYEBRIDGE_CLASSIC_TASKS_H
#define EYEBRIDGE_CLASSIC_TASKS_H

struct tcb;

/** Who waits at a semaphore. */
struct tcbq {
  struct tcb* next; /**< Not used here. */
  int pristat;      /**< Not used here. */
  int pridyn;       /**< Not used here. */
  int threads;      /**< How many tasks wait. */
};

/** A semaphore. Set it by OSSemInit(). */
struct sem {
  struct tcbq waitq;
  int count; /**< What OSSemP() can take without waiting. */
};

/** A task. Programs only hold pointers to it; read what you like. */
struct tcb {
  struct tcb* next;    /**< Not used here. */
  struct tcb* prev;    /**< Not used here. */
  struct sem* semq;    /**< The semaphore that it waits at, or 0. */
  BYTE* stkbeg;        /**< Not used here. */
  BYTE* stkend;        /**< Not used here. */
  int stksiz;          /**< As OSSpawn() said; the stack here has 8 MB. */
  BYTE* stackbase;     /**< Not used here. */
  int pri;             /**< MIN_PRI … MAX_PRI; IDLE_PRI of main(). */
  int stat;            /**< TASK_NEW … TASK_RUNNING. */
  const char* name;    /**< As OSSpawn() said. */
  int uid;
};

/** Starts multitasking, COOP or PREEMPT. 1 when that was done already, and for another mode. */
int OSMTInit(BYTE mode);
/** PREEMPT, COOP or NOTASK. */
int OSMTStatus(void);
/**
 * Makes a task, which waits for OSReady(). 0 before OSMTInit(), for NULL, and for a priority outside
 * MIN_PRI … MAX_PRI. `name` is copied. A task that reaches the end of its code ends as by OSKill(0).
 */
struct tcb* OSSpawn(const char* name, void (*code)(void), int stksiz, int pri, int uid);
/** Makes it ready: new, suspended or sleeping; one that waits at a semaphore goes on waiting. */
int OSReady(struct tcb* thread);
/** Takes it off the processor until OSReady(). */
int OSSuspend(struct tcb* thread);
/** Gives way to the ready tasks of the same priority and above. */
int OSReschedule(void);
/** The same. (The manual calls it "suspend and reschedule"; who would wake it up?) */
int OSYield(void);
/** OSReady() and OSReschedule(). */
int OSRun(struct tcb* thread);
/** The number that OSSpawn() was given; 0 of main(). -1 for what is no task. */
int OSGetUID(struct tcb* thread);
/** Ends it. The end of main() ends the program, with exit code 0. */
int OSKill(struct tcb* thread);
/** Ends the caller and shows its name and `code`; in main() the program, with this exit code. */
int OSExit(int code);
/** Shows `msg` and ends the program with exit code 1: the robot stops there for good. */
int OSPanic(const char* msg);
/** Sleeps `n` ticks while other tasks run; OSWait() where there is no multitasking. */
int OSSleep(int n);
/** Forbids preemption. */
int OSForbid(void);
/** Permits preemption and gives way. 1 in COOP mode. */
int OSPermit(void);
/** Of the M6: waits until a task has ended. */
int OSJoin(struct tcb* thread);
/** Sets a semaphore that nobody waits at to `val` >= 0, else 1. */
int OSSemInit(struct sem* sem, int val);
/** Takes one, and waits as long as there is none. 1 for NULL. */
int OSSemP(struct sem* sem);
/** Gives one, to the task that has waited longest if one does. 1 for NULL. */
int OSSemV(struct sem* sem);

#endif
