/* a light lover without light: fear and love of walls. Ends still driving. */
#include "eyebot.h"
int x=0,y=0;
int speed = 150;
int LEFT, RIGHT;
#define push(a) printf a
int step(int t)
{ int l=PSDGet(PSD_LEFT),r=PSDGet(PSD_RIGHT),f=PSDGet(PSD_FRONT);
  if(l>600) l=600; if(r>600) r=600; if (f > 600) f = 600;
  LEFT=speed*f/600+(600-l)/5-(600-f)/6;
  RIGHT=speed*f/600+(600-r)/5;
  if (t%100==0) push(("%d: %d %d\n",t,LEFT,RIGHT));
  MOTORDrive(1,LEFT/8); MOTORDrive(2,RIGHT/8);
  return t+1;
}
int main()
{ int t=0;
  while(t<1000) { t=step(t); OSWait(15); }
  LCDPrintf("and on it goes");
}
