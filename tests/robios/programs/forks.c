/* fork(): the child is not the robot's program; what it does and suffers leaves the parent alone. */
#include <sys/wait.h>

#include "eyebot.h"

static int end_of(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

int main() {
  pid_t child;

  VWStraight(100, 100);
  VWWait();
  fflush(stdout);
  if ((child = fork()) == 0) exit(3);
  printf("child %d\n", end_of(child));
  fflush(stdout);
  if ((child = fork()) == 0) {
    VWStraight(100, 100);
    exit(0);
  }
  printf("driving child %d\n", end_of(child));
  fflush(stdout);
  if ((child = fork()) == 0) {
    for (;;) pause();
  }
  kill(child, SIGTERM);
  printf("killed child %d\n", end_of(child));
  printf("shell %d\n", system("exit 4") >> 8);
  printf("output %s", OSExecute("echo hello"));
  VWStraight(100, 100);
  printf("drive %d\n", VWWait());
  return 0;
}
