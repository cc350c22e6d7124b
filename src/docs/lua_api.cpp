// lua_api: what a recipe can call, as docs/lua-api.md, or with --stub as docs/shadowlab.lua for
// editors.
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

#include "docs/printers.h"

int main(int argc, char** argv) {
  const std::string_view form = argc > 1 ? argv[1] : "";
  if (argc > 2 || (!form.empty() && form != "--stub")) {
    std::fputs("usage: lua_api [--stub]\n", stderr);
    return 2;
  }
  try {
    const std::string text = form.empty() ? shadowlab::docs::reference() : shadowlab::docs::stub();
    std::fwrite(text.data(), 1, text.size(), stdout);
    return std::fflush(stdout) == 0 ? 0 : 2;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "lua_api: %s\n", problem.what());
    return 1;
  }
}
