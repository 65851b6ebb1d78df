/* OSExecute in both forms; OSVersion, OSMachine. */
#include "eyebot.h"

int main() {
  char text[1024];
  char* output = OSExecute("echo one");
  int done;

  printf("%s", output);
  done = OSExecute("echo two", text);
  printf("%d %s", done, text);
  done = OSExecute("yes 1234567 | head -n 1000", text);
  printf("cut %d %d\n", done, (int)strlen(text));
  printf("null %d %d %d\n", OSExecute(NULL) == NULL, OSExecute(NULL, text),
         OSExecute("true", NULL));
  done = OSVersion(text);
  printf("version %d %s", done, text);
  done = OSVersionIO(text);
  printf(", io %d '%s'\n", done, text);
  printf("machine %d %d %d", OSMachineSpeed(), OSMachineType(), OSMachineID());
  done = OSMachineName(text);
  printf(" %d %s\n", done, text);
  return 0;
}
