/* All PSDs of an S4 in the middle of the room, then devices that it lacks. */
#include "eyebot.h"

int main(int argc, char** argv) {
  int i;

  (void)argv;
  /* More mistakes than one call reports. */
  if (argc > 1) {
    for (i = 0; i < 10; i++) SERVOSet(1, 300 + i);
    SERVOSet(12, 200);
  }
  for (i = 1; i <= 8; i++) printf("PSD %d = %d\n", i, PSDGet(i));
  printf("across %d\n", PSDGet(PSD_LEFT) + PSDGet(PSD_RIGHT));
  for (i = 0; i < 3; i++) {
    PSDGet(9);
    SERVOSet(12, 200);
    MOTORDrive(3, 50);
    ENCODERRead(3);
  }
  printf("went on\n");
  return 0;
}
