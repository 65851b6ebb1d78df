/* What each of several robots has for itself: handles, latches, variables, texts, timers. By radio
   it tells the others whom it has heard, until all N (the argument) have heard all. */
#include <stdlib.h>

#include "eyebot.h"

int ticked = 0;
void tick() { ticked = 1; }

int main(int argc, char** argv) {
  int id = OSMachineID(), robots = atoi(argv[1]), day, month, year, timers = 0, len, i, content = 0,
      motors;
  int all = (1 << robots) - 1;
  BYTE from, buf[MAXMSGLEN], mine[2];
  RadioIOParameters io;

  /* Those of odd numbers drive by motors, the others by VW: nobody can do both. */
  motors = id % 2 ? MOTORInit(MOTOR_LEFT) | MOTORInit(MOTOR_RIGHT) : VWInit(VW_DRIVE, 1);
  if (id % 2)
    MOTORDrive(motors, 20 + id);
  else
    VWSetSpeed(motors, 0.02 * id, 0);
  OSWriteOutLatch(0, 0, id);
  OSWriteParData(10 * id);
  OSPutVar(SAVEVAR2, 100 + id);
  OSSetDate(id, id, 1990 + id);
  OSMachineName()[0] = 'A' + id;
  RADIOInit();
  RADIOGetIoctl(&io);
  if (id == 2) OSAttachTimer(1, tick);
  while (OSAttachTimer(1000, tick) != 0) timers++;
  OSWait(50);

  mine[0] = id;
  mine[1] = 1 << (id - 1);
  for (i = 0; i < 1000 && content != all; i++) {
    if (mine[1] == all) content |= 1 << (id - 1);
    RADIOSend(BROADCAST, 2, mine);
    OSWait(5);
    while (RADIOCheck() > 0) {
      RADIORecv(&from, &len, buf);
      if (from != buf[0] || len != 2) printf("%d: not what %d sent\n", id, from);
      mine[1] |= 1 << (from - 1);
      if (buf[1] == all) content |= 1 << (from - 1);
    }
  }
  OSGetDate(&day, &month, &year);
  printf(
      "%d: drives %d psd %d, latch %d port %d var %d date %d.%d.%d name %c, timers %d ticked %d, "
      "radio %d heard %d\n",
      id, motors, PSDInit(PSD_FRONT), OSReadOutLatch(0), OSReadParData(), OSGetVar(SAVEVAR2), day,
      month, year, OSMachineName()[0], timers, ticked, io.id, mine[1]);
  return 0;
}
