// An image helper brings eyebot.h, the program eyebot++.h: both in one source.
#include <map>
#include <string>
#include <vector>

#include <eyebot++.h>
#include <eyebot.h>

static_assert(KEY4 == 8);

int c_header_first() {
  using namespace std;  // as all the C++ programs do
  const vector<int> distance_list{QVGA_X};
  const map<string, int> nodes{{"a", QVGA_Y}};
  return distance_list.front() + nodes.at("a");
}
