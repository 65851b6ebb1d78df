// Several robots that use the streams of C++.
#include <iomanip>
#include <iostream>
#include <string>

#include <eyebot++.h>

int main() {
  const int id = OSMachineID();
  if (id == 2) std::cout << std::hex;  // the others go on in decimals
  OSWait(10 * id);
  std::cout << "robot " << id << " counts to " << 10 * id << std::endl;
  std::cerr << "robot " << id << " errs\n";
  std::wclog << L"robot " << id << L" logs\n";
  std::string word;
  if (!(std::cin >> word)) std::cout << "robot " << id << " reads nothing\n";
  return 0;
}
