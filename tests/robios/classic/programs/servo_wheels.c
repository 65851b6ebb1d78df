/* Wheels on servos, as programs of classic RoBIOS have them. */
#include "eyebot.h"
#include "tell.h"

int main() {
  ServoHandle left = SERVOInit(SERVO12), right = SERVOInit(SERVO13);
  QuadHandle wheel;

  TELL("wheels", left != 0 && right != 0);
  if (!left || !right) return 1;
  wheel = QUADInit(QUAD_LEFT);
  SERVOSet(left | right, 255);
  OSWait(200);
  SERVOSet(left | right, 127);
  OSWait(10);
  TELL("turned", QUADRead(wheel));
  OSWait(10);
  TELL("stands at", QUADRead(wheel));
  SERVOSet(left, 1);
  SERVOSet(right, 255);
  OSWait(50);
  TELL("back at", QUADRead(wheel));
  return 0;
}
