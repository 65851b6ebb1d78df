/* What calls return to a program whose robot nobody knows the place of. */
#include "eyebot.h"

static BYTE image[QQVGA_SIZE];

int main(void) {
  printf("psd %d\n", PSDGet(PSD_FRONT));
  printf("motor %d\n", MOTORDrive(1, 50));
  printf("stop %d\n", VWSetSpeed(0, 0));
  printf("wait %d\n", VWWait());
  CAMInit(QQVGA);
  printf("frame %d\n", CAMGet(image));
  return 0;
}
