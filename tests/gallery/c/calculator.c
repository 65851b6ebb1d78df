/* reads numbers from stdin if there are any, else uses its own; getchar/scanf at the end of input */
#include "eyebot.h"

int main()
{
  int a = 0, b = 0, n, c;
  printf("two numbers please: ");
  n = scanf("%d %d", &a, &b);
  if (n != 2) { a = 17; b = 4; printf("(nobody answers, I take %d and %d)\n", a, b); }
  LCDPrintf("%d + %d = %d\n", a, b, a + b);
  LCDPrintf("%d * %d = %d\n", a, b, a * b);
  LCDPrintf("%d / %d = %.3f\n", a, b, (float)a / b);
  LCDPrintf("%s\n", b == 0 ? "infinite" : "fine");
  LCDPrintf("100%% sure, hex %X, octal %o, char %c, long %ld\n", a, b, 'q', 1234567890L);
  LCDPrintf("a very long line that goes on and on and on until it has reached the right side of the display and then some more");
  c = getchar();
  printf("then came %d\n", c);
  OSWait(100);
  goto end;
  printf("never\n");
end:
  LCDMenu("A", "B\nb", "", "a label that is much too long for the key");
  KEYWait(ANYKEY);
  return 3;
}
