// Several robots that use the streams of C++.
#include <iomanip>
#include <iostream>
#include <string>

#include <eyebot++.h>

int main() {
  std::wclog << L"loading\n";  // of stderr, from now on, wide characters alone
  std::ios::sync_with_stdio(false);
  const int id = OSMachineID();
  if (id == 2) std::cout << std::hex;  // the others go on in decimals
  OSWait(10 * id);
  std::cout << "robot " << id << " counts to " << 10 * id << std::endl;
  std::wcerr << L"robot " << id << L" errs\n";
  std::wclog << L"robot " << id << L" logs\n";
  std::cout.iword(std::ios_base::xalloc()) = id;  // from the fifth robot on there is no room for it
  std::string word;
  if (!(std::cin >> word)) std::cout << "robot " << id << " reads nothing\n";
  return 0;
}
