// OSExecute and SERSend in both forms, from C++.
#include "eyebot++.h"

int main() {
  char text[1024];
  const char* output = OSExecute("echo one");
  printf("%s", output);
  const int done = OSExecute("echo two", text);
  printf("%d %s", done, text);
  const unsigned char bytes[3] = {1, 0, 2};
  printf("closed %d %d %d %d\n", SERSend(0, "text"), SERSend(0, "text", 4), SERSend(0, bytes, 3),
         SERInit(0, 9600, NONE));
  int sender = 0;
  printf("radio off %d %d\n", RADIOCheck(), RADIOCheck(&sender));
  return 0;
}
