// Robots that read the words of their program.
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>

#include <eyebot.h>

int main(int argc, char** argv) {
  static const struct option kOptions[] = {{"speed", required_argument, NULL, 's'}, {0}};
  int speed = 0, loud = 0;
  for (int option; (option = getopt_long(argc, argv, "ls:", kOptions, NULL)) != -1;) {
    if (option == 's') speed = atoi(optarg);
    if (option == 'l') loud = 1;
    OSWait(10 * OSMachineID()); /* the others read theirs meanwhile */
  }
  printf("%d: %d %d %s\n", OSMachineID(), speed, loud, optind < argc ? argv[optind] : "none");
  return 0;
}
