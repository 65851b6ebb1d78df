/* What the launcher (launcher.c) and the library behind it have of each other. C and C++. */
#ifndef EYEBRIDGE_FLEET_LAUNCHER_H
#define EYEBRIDGE_FLEET_LAUNCHER_H

#ifdef __cplusplus
extern "C" {
#endif

/* What the launcher asks when a robot's program calls the C library. Null until robots run; each
   returns when the caller is no robot's. */
struct eyebridge_robot_calls {
  void (*leave)(int code);
  void (*abort)(void);
};

/* Runs the robots that the settings want. PROGRAM and its arguments follow the library in `argv`;
   without them the scenario names programs. Returns the exit code. Exported by the libraries. */
typedef int eyebridge_robots_main(int argc, char** argv, struct eyebridge_robot_calls* calls);
int EYEBRIDGERobotsMain(int argc, char** argv, struct eyebridge_robot_calls* calls);

#ifdef __cplusplus
}
#endif

#endif
