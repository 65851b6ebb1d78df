/* Null pointers where something has to be read or written: a failure, no crash. */
#include "eyebot.h"

int main() {
  int failures = 0;

  CAMInit(QQVGA);
  failures += CAMGet(NULL) == 1;
  failures += CAMGetGray(NULL) == 1;
  failures += LIDARGet(NULL) == 1;
  failures += SIMLaserScan(NULL) == 1;
  failures += OSVersion(NULL) == 1;
  failures += OSVersionIO(NULL) == 1;
  failures += OSMachineName(NULL) == 1;
  failures += OSExecute(NULL) == NULL;
  failures += LCDPrintf(NULL) == 1;
  failures += LCDSetPrintf(0, 0, NULL) == 1;
  failures += LCDGetPos(NULL, NULL) == 1;
  failures += LCDGetSize(NULL, NULL) == 1;
  failures += LCDImage(NULL) == 1;
  failures += LCDImageGray(NULL) == 1;
  failures += LCDImageBinary(NULL) == 1;
  failures += KEYGetXY(NULL, NULL) == 1;
  failures += KEYReadXY(NULL, NULL) == 1;
  failures += OSAttachTimer(10, NULL) == 0;
  failures += IPReadFile(NULL, NULL) == -1;
  failures += IPWriteFile(NULL, NULL) == 1;
  failures += IPWriteFileGray(NULL, NULL) == 1;
  printf("failed %d of 21\n", failures);
  failures = LCDMenu(NULL, NULL, NULL, NULL) + LCDMenuI(1, NULL, RED, BLUE) +
             VWGetSpeed(NULL, NULL) + VWGetPosition(NULL, NULL, NULL) +
             SIMGetRobot(1, NULL, NULL, NULL, NULL) + OSGetTime(NULL, NULL, NULL, NULL);
  printf("left out %d\n", failures);
  return 0;
}
