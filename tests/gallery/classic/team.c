/* radio, serial line, A/D, latches: what the robot is */
#include "eyebot.h"

int main ()
{ BYTE me, from, msg[20];
  int len, err, i, hrs, mins, secs, ticks;

  me = OSMachineID();
  LCDPrintf("Robot %d\n%s\n",me,OSVersion());
  printf("radio %d\n",RADIOInit());
  strcpy((char*)msg,"kick");
  err = RADIOSend(me,5,msg);
  for (i=0; i<50 && !RADIOCheck(); i++) OSWait(2);
  if (RADIOCheck())
  { RADIORecv(&from,&len,msg);
    LCDPrintf("%d: %s\n",from,msg);
    printf("message %s of %d bytes from %d\n",msg,len,from);
  }
  else printf("no message, send said %d\n",err);
  RADIOTerm();
  printf("type %d\n",OSMachineType() == VEHICLE);
  OSWriteOutLatch(0,0xFB,0x04);
  printf("latch %d\n",OSReadOutLatch(0) & 0x04);
  printf("AD %s\n",OSGetAD(0) >= 0 ? "works" : "fails");
  OSSetTime(12,30,0);
  OSWait(150);
  OSGetTime(&hrs,&mins,&secs,&ticks);
  printf("%02d:%02d:%02d\n",hrs,mins,secs);
  LCDMenu("","","","END");
  KEYWait(KEY4);
  return 0;
}
