#include "measure/machine.h"

#include <sys/utsname.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "core/version.h"

namespace shadowlab::measure {
namespace {

// What follows "NAME :" or "NAME=" in a file of such lines, without quotes.
std::string line_of(const char* file, const std::string& name) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(name)) continue;
    const auto begin = line.find_first_not_of(" \t:=\"", name.size());
    const auto end = line.find_last_not_of(" \t\"");
    if (begin != std::string::npos && end >= begin) return line.substr(begin, end - begin + 1);
  }
  return "unknown";
}

std::string system_name() {
  utsname name{};
  const std::string kernel =
      ::uname(&name) == 0 ? std::string(name.sysname) + " " + name.release : "unknown";
  return line_of("/etc/os-release", "PRETTY_NAME") + ", " + kernel;
}

std::string moment() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  char text[32] = "";
  if (::gmtime_r(&now, &utc)) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

}  // namespace

Json machine_of(const gl::Graphics& graphics) {
  const context::Context& context = graphics.context();
  const char* driver_threads = std::getenv("LP_NUM_THREADS");
  double load = 0;
  ::getloadavg(&load, 1);
  return {{"processor", line_of("/proc/cpuinfo", "model name")},
          {"cores", std::thread::hardware_concurrency()},
          {"memory_bytes", static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                               static_cast<std::uint64_t>(::sysconf(_SC_PAGE_SIZE))},
          {"system", system_name()},
          {"context", context.name},
          {"driver", context.version},
          {"renderer", context.renderer},
          {"driver_threads", driver_threads ? driver_threads : "the driver's default"},
          {"load", load},
          {"shadowlab", version()},
          {"when", moment()}};
}

}  // namespace shadowlab::measure
