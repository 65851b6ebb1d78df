// Several robots that use the streams of C++.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <string>

#include <eyebot++.h>

namespace {

// One after the other: of lines that are written at the same time each would be in pieces.
void await_turn(int id) {
  char word[8];
  int sender = 0;
  if (id > 1) RADIOReceive(&sender, word, sizeof word);
}
void pass_turn(int id) {
  int present[256];
  bool is_there = id == 6;  // the last one
  while (!is_there) {
    const int count = RADIOStatus(present);
    is_there = std::find(present, present + count, id + 1) != present + count;
    if (!is_there) OSWait(10);
  }
  if (id < 6) RADIOSend(id + 1, "next");
}

}  // namespace

int main() {
  std::wclog << L"loading\n";  // of stderr, from now on, wide characters alone
  std::ios::sync_with_stdio(false);
  const int id = OSMachineID();
  if (id == 2) std::cout << std::hex;  // the others go on in decimals
  RADIOInit();
  await_turn(id);
  std::cout << "robot " << id << " counts to " << 10 * id << std::endl;
  std::wcerr << L"robot " << id << L" errs\n";
  std::wclog << L"robot " << id << L" logs\n";
  std::cout.iword(std::ios_base::xalloc()) = id;  // from the fifth robot on there is no room for it
  std::string word;
  if (!(std::cin >> word)) std::cout << "robot " << id << " reads nothing\n" << std::flush;
  pass_turn(id);
  return 0;
}
