/* Distances from a known pose: PSDs, lidar order, wrong ids. */
#include "eyebot.h"
#include "eyebridge.h"

int main() {
  int scan[360], part[5], sim[360], i, same = 1;

  SIMSetRobot(0, 500, 1000, 0, 0); /* west wall 495, east 1495, north and south 995 away */
  printf("psd %d %d %d %d\n", PSDGet(PSD_FRONT), PSDGet(PSD_LEFT), PSDGet(PSD_RIGHT),
         PSDGetRaw(PSD_FRONT));
  i = PSDGet(42);
  printf("no such psd %d: %s\n", i, EYEBRIDGELastError());
  LIDARGet(scan);
  printf("lidar %d %d %d %d\n", scan[0], scan[90], scan[180], scan[270]);
  LIDARSet(180, 0, 5);
  LIDARGet(part);
  printf("part %d %d %d\n", part[0], part[2], part[4]);
  SIMLaserScan(sim);
  for (i = 0; i < 360; i++) same = same && sim[i] == scan[(180 - i + 360) % 360];
  LIDARGet(part);
  printf("laser scan %d, resolution %d, still %d\n", same, LIDAR_RESOLUTION, part[2]);
  printf("bad lidar %d %d\n", LIDARSet(0, 0, 10), LIDARSet(90, 0, 0));
  return 0;
}
