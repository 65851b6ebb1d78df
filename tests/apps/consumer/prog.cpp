#include <vector>

#include "eyebot++.h"
using namespace std;

int main() {
  vector<int> ranges = {PSDGet(PSD_FRONT), PSDGet(PSD_LEFT)};
  sort(ranges.begin(), ranges.end());
  printf("sorted %d\n", ranges[0] <= ranges[1]);
}
