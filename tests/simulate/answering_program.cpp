// A simulator that stays, for ProgramTest: 0.1 + wi_x + 10 wo_y + 100 wo_z for each pair.
#include <cstdio>
#include <iostream>
#include <string>

int main() {
  std::string line;
  std::getline(std::cin, line);  // the header
  while (std::getline(std::cin, line)) {
    double w[6];
    if (line.empty()) {
      std::cout << std::endl;
    } else if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf", w, w + 1, w + 2, w + 3, w + 4, w + 5) == 6) {
      char value[40];
      std::snprintf(value, sizeof value, "%.17g\n", 0.1 + w[0] + 10 * w[4] + 100 * w[5]);
      std::cout << value;
    } else {
      std::cerr << "not six numbers: " << line << "\n";
      return 1;
    }
  }
}
