/**
 * For C++ programs of the M6: names where others take numbers. Part of eyebot.h. (C passes them as
 * they are: see DeviceSemantics.)
 */
#ifndef EYEBRIDGE_CLASSIC_M6_OVERLOADS_H
#define EYEBRIDGE_CLASSIC_M6_OVERLOADS_H

#define EYEBRIDGE_BY_NAME(type, function)                             \
  static inline type function(const char* name) {                     \
    return function(reinterpret_cast<DeviceSemantics>(name));         \
  }                                                                   \
  static inline type function(int number) { return function(DeviceSemantics{number}); }
EYEBRIDGE_BY_NAME(PSDHandle, PSDInit)
EYEBRIDGE_BY_NAME(ServoHandle, SERVOInit)
EYEBRIDGE_BY_NAME(MotorHandle, MOTORInit)
EYEBRIDGE_BY_NAME(QuadHandle, QUADInit)
EYEBRIDGE_BY_NAME(BumpHandle, BUMPInit)
EYEBRIDGE_BY_NAME(IRHandle, IRInit)
EYEBRIDGE_BY_NAME(int, COMPASSInit)
EYEBRIDGE_BY_NAME(int, IRTVInitHDT)
EYEBRIDGE_BY_NAME(CAMHandle, CAMInit)
#undef EYEBRIDGE_BY_NAME

static inline VWHandle VWInit(int number, int timescale) {
  return VWInit(DeviceSemantics{number}, timescale);
}
static inline VWHandle VWInit(const char* name, int timescale) {
  return VWInit(reinterpret_cast<DeviceSemantics>(name), timescale);
}
extern "C" int EYEBRIDGEPSDRelease(int given, PSDHandle handle);
static inline int PSDRelease(PSDHandle handle) { return EYEBRIDGEPSDRelease(1, handle); }
static inline int CAMRelease(CAMHandle) { return CAMRelease(); }
static inline int CAMGetFrameRGB(CAMHandle, void* buf) { return CAMGetFrameRGB(buf); }

#endif
