// Read behind first.cpp, as one with it.
#include <string>
#include <vector>

std::size_t sizes(std::vector<std::string> all) {  // performance-unnecessary-value-param
  std::size_t sum = 0;
  for (const auto one : all) sum += one.size();  // performance-for-range-copy
  return sum;
}
