// What programs of the M6 call beyond classic RoBIOS. LCDPutImageRGB(), KEYGetXY(), dates and names
// are with their families.

#include "call.hpp"
#include "eyebot.h"

namespace {

using namespace eyebridge;
using robios::Session;
using robios::classic::call;
using robios::classic::doing;

constexpr int kClassicMap = 1;

/// For what is always there and needs nothing.
int there(const robios::Call& name) {
  return doing(name, 1, [](Session&) -> Result<void> { return {}; });
}

int missing(const robios::Call& name, const char* what) {
  return doing(name, 1, [&](Session&) -> Result<void> { return fail(Errc::Unsupported, what); });
}

}  // namespace

int LCDInit(void) { return there("LCDInit"); }
int LCDRelease(void) { return there("LCDRelease"); }
int LCDRefresh(void) { return there("LCDRefresh"); }
int LCDSetMode(int) { return there("LCDSetMode"); }
int LCDResetMode(int) { return there("LCDResetMode"); }
int LCDTextColor(int, int, int) { return there("LCDTextColor"); }
int KEYInit(void) { return there("KEYInit"); }
int KEYRelease(void) { return there("KEYRelease"); }
int KEYIdle(int) { return there("KEYIdle"); }

int LCDGetFBInfo(void*) { return missing("LCDGetFBInfo", "there is no frame buffer to look into"); }
int LCDList(void*) { return missing("LCDList", "there are no list menus"); }
int LCDSetList(void*) { return missing("LCDSetList", "there are no list menus"); }

void* LCDGetList(void) {
  return call("LCDGetList", static_cast<void*>(nullptr),
              [](Session&) -> Result<void*> { return nullptr; });
}

int KEYGetTM(void*) {
  return call("KEYGetTM", kClassicMap, [](Session&) -> Result<int> { return kClassicMap; });
}
int KEYSetTM(int mode) {
  return mode == kClassicMap ? there("KEYSetTM")
                             : missing("KEYSetTM", "there is no touch map but the four keys");
}
int KEYSetRegion(int, void*) { return missing("KEYSetRegion", "there are no touch regions"); }
int KEYGetRegion(int, void*) { return missing("KEYGetRegion", "there are no touch regions"); }
