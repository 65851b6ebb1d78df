/* Who the robot is, variables, latches, converters. */
#include "eyebot.h"

int main()
{ printf("version %s, machine %d %d %s %d\n", OSVersion(), OSMachineType(), OSMachineSpeed(),
         OSMachineName(), OSMachineID());
  printf("put %d %d %d\n", OSPutVar(SAVEVAR1, 0x1234), OSPutVar(SAVEVAR1, 70000), OSPutVar(5, 1));
  printf("get %x %x %x %d\n", OSGetVar(SAVEVAR1), OSGetVar(SAVEVAR1a), OSGetVar(SAVEVAR1b),
         OSGetVar(99));
  OSPutVar(SAVEVAR1b, 0xFF);
  printf("byte %x\n", OSGetVar(SAVEVAR1));
  printf("latch %x %x %x\n", OSWriteOutLatch(0, 0xFB, 0x04), OSWriteOutLatch(0, 0xFF, 0x01),
         OSReadOutLatch(0));
  printf("in %x, none %x %x\n", OSReadInLatch(0), OSReadInLatch(1), OSWriteOutLatch(4, 0, 0));
  OSWriteParData(0x5A);
  OSWriteParCTRL(0xFF);
  printf("port %x %x %x\n", OSReadParData(), OSReadParSR(), OSReadParCTRL());
  printf("ad %d %d, off %d %d\n", OSGetAD(0) > 0 && OSGetAD(0) < 1024, OSGetAD(16), OSOffAD(1),
         OSOffAD(2));
  printf("loader %d %d %d %d, hdt %d\n", OSDownload(NULL, NULL, 0, 0, 0), OSExecute(NULL),
         USRStart(), USRResident(NULL, 0), HDT_FindEntry(1, PSD_LEFT) == NULL);
  printf("m6 %d %d %d %d %d\n", OSLatchInit(), OSLatchBankSetup(IOBANK1, 1), OSLatchWrite(9, 1),
         OSLatchRead(9), OSLatchRead(16));
  printf("adc %d %d %d\n", OSGetADC(OSInitADC("ADC0")) > 0, OSInitADC("XYZ"), OSADCRelease(1));
  return 0;
}
