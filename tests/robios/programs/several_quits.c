#define _ISOC11_SOURCE  // for quick_exit()
// Robots that end in ways that would end the process, and one that has children.
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <eyebot.h>

static void have_a_child(void) {
  const pid_t child = fork();
  if (child == 0) exit(7); /* the child's end, not a robot's */
  int status = 0;
  waitpid(child, &status, 0);
  printf("child %d\n", WEXITSTATUS(status));
}

int main(void) {
  const int id = OSMachineID();
  OSWait(100 * id);
  if (id == 1) _exit(4);
  if (id == 2) _Exit(5);
  if (id == 3) quick_exit(6);
  if (id == 4) have_a_child();
  OSWait(1000);
  printf("robot %d is left\n", id);
  return 0;
}
