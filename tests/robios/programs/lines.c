/* DIGITAL, ANALOG, AUMicrophone: what there is, what there is not. */
#include "eyebot.h"

int main() {
  BYTE samples[100];
  int i, n, same = 1, before;

  printf("start %04X\n", (unsigned)DIGITALReadAll());
  printf("write %d", DIGITALWrite(9, 1));
  printf(" %d", DIGITALRead(9));
  printf(" %d\n", DIGITALRead(10));
  printf("any state %d", DIGITALWrite(9, 7));
  printf(" %d\n", DIGITALRead(9));
  for (i = 0; i < 4; i++) {
    printf("%c %d", "JIoi"[i], DIGITALSetup(8, "JIoi"[i]));
    printf(" %d\n", DIGITALRead(8));
  }
  printf("bad %d %d %d %d %d\n", DIGITALSetup(0, 'i'), DIGITALSetup(1, 'x'), DIGITALRead(17),
         DIGITALWrite(-1, 0), DIGITALSetup(1, '\0'));
  printf("analog %d %d %d %d\n", ANALOGRead(0), ANALOGRead(1), ANALOGRead(8), ANALOGVoltage());
  printf("bad analog %d %d\n", ANALOGRead(-1), ANALOGRead(9));
  printf("microphone %d\n", AUMicrophone());
  before = OSGetCount();
  printf("record %d\n", ANALOGRecord(8, 100));
  n = ANALOGTransfer(samples);
  for (i = 0; i < n; i++) same = same && samples[i] == 128;
  printf("samples %d %d, waited %d\n", n, same, OSGetCount() - before >= 100);
  printf("once %d\n", ANALOGTransfer(samples));
  printf("bad record %d %d %d %d\n", ANALOGRecord(9, 5), ANALOGRecord(1, 0), ANALOGRecord(1, -3),
         ANALOGTransfer(NULL));
  ANALOGRecord(8, 100);
  ANALOGRecord(8, 7); /* another one replaces it */
  OSWait(50);
  printf("second %d\n", ANALOGTransfer(samples));
  return 0;
}
