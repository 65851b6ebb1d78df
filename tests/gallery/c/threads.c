// one thread drives, one watches the wall, one shows; main just leaves
#include "eyebot.h"
#include <pthread.h>

pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
int dist, x, y, phi;

void *drive(void *arg)
{ int i;
  for (i = 0; i < 4; i++)
  { pthread_mutex_lock(&lock);
    VWStraight(200, 100);
    pthread_mutex_unlock(&lock);
    VWWait();
    VWTurn(90, 60);
    VWWait();
  }
  printf("driven\n");
  return NULL;
}

void *watch(void *arg)
{ int i;
  for (i = 0; i < 100; i++)
  { pthread_mutex_lock(&lock);
    dist = PSDGet(PSD_FRONT);
    VWGetPosition(&x, &y, &phi);
    pthread_mutex_unlock(&lock);
    usleep(20000);
  }
  return NULL;
}

void *show(void *id)
{ int i;
  for (i = 0; i < 50; i++)
  { pthread_mutex_lock(&lock);
    LCDSetPrintf((int)(long)id, 0, "front %4d, at %4d %4d %4d", dist, x, y, phi);
    pthread_mutex_unlock(&lock);
    OSWait(100);
  }
  LCDSetPrintf((int)(long)id, 0, "the show is over                  ");
  printf("shown %d times\n", i);
  return NULL;
}

int main()
{ pthread_t t1, t2, t3;
  XInitThreads();
  LCDMenu("", "", "", "END");
  pthread_create(&t1, NULL, drive, NULL);
  pthread_create(&t2, NULL, watch, NULL);
  pthread_create(&t3, NULL, show, (void *)5);
  pthread_exit(0);
}
