// Several robots that make processes, of which each ends in another way; no robot ends by that.
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <eyebot.h>

static int id;
static pid_t owner;

static void say_end(void) {
  if (getpid() != owner) _exit(30 + id);
}

int main(void) {
  id = OSMachineID();
  owner = getpid();
  OSWait(10);
  if (id == 1) atexit(say_end);
  const pid_t child = fork();
  if (child == 0) {
    if (id == 2) exit(8);
    if (id == 3) _exit(9);
    if (id == 4) *(volatile int*)8 = 1;
    if (id == 5) OSWait(10);
    return 7;
  }
  int status = 0;
  waitpid(child, &status, 0);
  OSWait(10);
  printf("%d had %d %d\n", id, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
         WIFEXITED(status) ? WEXITSTATUS(status) : 0);
  return 0;
}
