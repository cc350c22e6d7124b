#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "lua/value.h"

namespace shadowlab::lua {
namespace {

/// Allocations of a state: how many there were, which one fails, how much is not yet freed.
struct Heap {
  long made = 0, failing = -1;
  std::size_t live = 0;

  static void* allocate(void* self, void* block, std::size_t old_size, std::size_t size) {
    Heap& heap = *static_cast<Heap*>(self);
    if (!block) old_size = 0;  // then it is the kind of object, not a size
    if (size == 0) {
      std::free(block);
      heap.live -= old_size;
      return nullptr;
    }
    // Lua takes for granted that a block can shrink.
    // It collects garbage and tries once more, so the second try has to fail too.
    const bool grows = size > old_size;
    if (grows) ++heap.made;
    if (grows && (heap.made == heap.failing || heap.made == heap.failing + 1)) return nullptr;
    void* moved = std::realloc(block, size);
    if (moved) heap.live += size - old_size;
    return moved;
  }
};

/// Calls every function of every module, right and wrong: each fails with a Lua error at worst.
constexpr const char* everything = R"lua(
  local kinds = {vec2 = vec2(3, 4), vec3 = vec3(1, 2, 2), vec4 = vec4(1, 2, 3, 4),
                 mat3 = mat3.rotate(30, 1, 2, 3), mat4 = mat4.perspective(50, 2, 1, 9),
                 quat = quat.axis_angle(50, 0, 1, 1)}
  local spare = {{}, {1}, {2, 3}, {1, {0, 4, 0}}, {{1, 2, 3}, {3, 2, 1}, {0, 1, 0}},
                 {1, 2, 3, 4, 5, 6}, {"x"}}
  for name, v in pairs(kinds) do
    local module = _G[name]
    for _, f in pairs(module) do
      for _, arguments in ipairs(spare) do
        pcall(f, v, table.unpack(arguments))
        pcall(f, table.unpack(arguments))
      end
      pcall(f, v, v, 0.5)
    end
    for _, arguments in ipairs(spare) do pcall(module, table.unpack(arguments)) end
    for _, u in pairs(kinds) do
      for _, w in ipairs{u, 2, "x"} do
        pcall(function() return v + w end)
        pcall(function() return w - v end)
        pcall(function() return v * w end)
        pcall(function() return w * v end)
        pcall(function() return v / w end)
      end
      assert((v == u) == rawequal(v, u))
    end
    local _ = -v, #v, tostring(v), pcall(function() return v.nothing end)
    pcall(function() v.x = 1 end)
    pcall(function() return v[1], v.x, v.zyx, module.nothing end)
  end
  return "done"
)lua";

/// Runs `everything` in a state of its own; returns whether it came to its end.
bool run_everything(Heap& heap) {
  lua_State* L = lua_newstate(Heap::allocate, &heap);
  if (!L) return false;
  const auto body = [](lua_State* state) {
    luaL_requiref(state, LUA_GNAME, luaopen_base, 1);
    luaL_requiref(state, LUA_TABLIBNAME, luaopen_table, 1);
    open_values(state);
    if (luaL_loadstring(state, everything) != LUA_OK) return lua_error(state);
    lua_call(state, 0, 1);
    return 1;
  };
  lua_pushcfunction(L, body);
  const bool done = lua_pcall(L, 0, 1, 0) == LUA_OK;
  EXPECT_TRUE(!done || std::string(lua_tostring(L, -1)) == "done");
  lua_close(L);
  return done;
}

TEST(ValueModules, survive_the_failure_of_any_one_allocation) {
  Heap whole;
  ASSERT_TRUE(run_everything(whole));
  ASSERT_EQ(whole.live, 0u);
  ASSERT_GT(whole.made, 1000);
  RecordProperty("allocations", static_cast<int>(whole.made));
  // Each early one, in which the modules are made; then about 300 all along the script.
  const long stride = whole.made / 300 + 1;
  for (long k = 1; k <= whole.made; k += k < 400 ? 1 : stride) {
    Heap heap;
    heap.failing = k;
    const bool done = run_everything(heap);
    // Nothing catches a failure while the state and its modules are made.
    EXPECT_TRUE(!done || k > 100) << "allocation " << k;
    ASSERT_EQ(heap.live, 0u) << "allocation " << k << " of " << whole.made;
  }
}

}  // namespace
}  // namespace shadowlab::lua
