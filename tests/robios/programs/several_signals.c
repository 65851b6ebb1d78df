// Several robots that have handlers of signals of their own.
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <eyebot.h>

static int id;
static volatile int count;
static sigjmp_buf before;

static void on_user(int number) { count += number == SIGUSR1 ? id : 100; }
static void go_back(int number) {
  LCDPrintf("signal %d\n", number);  // others run meanwhile
  siglongjmp(before, 1);
}
static void give_up(int number, siginfo_t* info, void* context) {
  printf("%d gives up by %d at %p\n", id, number, context != NULL ? info->si_addr : NULL);
  OSWait(10);
  exit(20 + id);
}
static void come_back(int number) { printf("%d comes back by %d\n", id, number); }

int main(void) {
  id = OSMachineID();
  if (id < 4) signal(SIGUSR1, on_user);
  if (id == 2) signal(SIGUSR1, SIG_IGN);
  signal(SIGINT, come_back);  // and yet Ctrl-C ends the run
  OSWait(10);
  raise(SIGUSR1);
  kill(getpid(), SIGUSR1);
  OSWait(10);
  signal(SIGSEGV, go_back);
  for (volatile int i = 0; i < 3; ++i) {
    OSWait(10);
    if (sigsetjmp(before, 1) == 0) *(volatile int*)8 = 1;
  }
  printf("%d counted %d, and recovered\n", id, count);
  OSWait(10);
  struct sigaction action = {0};
  action.sa_flags = SA_SIGINFO;
  action.sa_sigaction = give_up;
  if (id == 1) sigaction(SIGSEGV, &action, NULL);
  OSWait(10);
  if (id == 1) *(volatile int*)8 = 1;
  return 0;
}
