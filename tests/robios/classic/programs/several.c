/* What each of several robots has for itself: handles, latches, variables, texts, timers; and what it hears of the
   others. */
#include <string.h>

#include "eyebot.h"

int ticked = 0;
void tick() { ticked = 1; }

int main() {
  int id = OSMachineID(), day, month, year, timers = 0, len, i, heard = 0, motors;
  BYTE from, buf[MAXMSGLEN];
  RadioIOParameters io;

  /* Those of odd numbers drive by motors, the others by VW: nobody can do both. */
  motors = id % 2 ? MOTORInit(MOTOR_LEFT) | MOTORInit(MOTOR_RIGHT) : VWInit(VW_DRIVE, 1);
  if (id % 2) MOTORDrive(motors, 20 + id);
  else VWSetSpeed(motors, 0.02 * id, 0);
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

  RADIOSend(BROADCAST, 1, &id);
  for (i = 0; i < 100; i++) {
    OSWait(1);
    while (RADIOCheck() > 0) {
      RADIORecv(&from, &len, buf);
      heard += from == buf[0] ? from : 1000;
    }
  }
  OSGetDate(&day, &month, &year);
  printf("%d: drives %d psd %d, latch %d port %d var %d date %d.%d.%d name %c, timers %d ticked %d, radio %d heard %d\n",
         id, motors, PSDInit(PSD_FRONT), OSReadOutLatch(0), OSReadParData(), OSGetVar(SAVEVAR2), day, month, year,
         OSMachineName()[0], timers, ticked, io.id, heard);
  return 0;
}
