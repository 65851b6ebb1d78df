#include <algorithm>
#include <string>

#include <eyebot++.h>
#include <eyebot.h>

int cpp_header_first() {
  using namespace std;
  return max(QQVGA_X, QQVGA_Y) + static_cast<int>(string("ab").size()) + abs(-1);
}
