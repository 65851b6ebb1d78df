/* Who the robot is, variables, latches, converters. */
#include "eyebot.h"
#include "tell.h"

int main() {
  printf("version %s, name %s\n", OSVersion(), OSMachineName());
  TELL("type", OSMachineType() == VEHICLE);
  TELL("speed", OSMachineSpeed());
  TELL("id", OSMachineID());
  TELL("put", OSPutVar(SAVEVAR1, 0x1234));
  TELL("too big", OSPutVar(SAVEVAR1, 70000));
  TELL("no variable", OSPutVar(5, 1));
  printf("get %x %x %x\n", OSGetVar(SAVEVAR1), OSGetVar(SAVEVAR1a), OSGetVar(SAVEVAR1b));
  TELL("no variable", OSGetVar(99));
  OSPutVar(SAVEVAR1b, 0xFF);
  printf("word %x\n", OSGetVar(SAVEVAR1));
  TELL("before", OSWriteOutLatch(0, 0xFB, 0x04));
  TELL("before", OSWriteOutLatch(0, 0xFF, 0x01));
  TELL("now", OSReadOutLatch(0));
  TELL("in", OSReadInLatch(0));
  TELL("no latch", OSReadInLatch(1));
  TELL("no latch", OSWriteOutLatch(4, 0, 0));
  OSWriteParData(0x5A);
  OSWriteParCTRL(0xFF);
  printf("port %x %x %x\n", OSReadParData(), OSReadParSR(), OSReadParCTRL());
  TELL("ad", OSGetAD(0) > 0 && OSGetAD(0) < 1024);
  TELL("no channel", OSGetAD(16));
  TELL("off", OSOffAD(1));
  TELL("bad off", OSOffAD(2));
  TELL("loader",
       OSDownload(NULL, NULL, 0, 0, 0) + OSExecute(NULL) + USRStart() + USRResident(NULL, 0));
  TELL("hdt", HDT_FindEntry(1, PSD_LEFT) == NULL);
  TELL("m6", OSLatchInit());
  TELL("bank", OSLatchBankSetup(IOBANK1, 1));
  TELL("write", OSLatchWrite(9, 1));
  TELL("read", OSLatchRead(9));
  TELL("no line", OSLatchRead(16));
  TELL("adc", OSGetADC(OSInitADC("ADC0")) == OSGetAD(0));
  TELL("no adc", OSInitADC("XYZ"));
  return 0;
}
