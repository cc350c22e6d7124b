// Coroutines that share the state's budget and cannot outlive it.
#include "lua/guard.h"
#include "lua/sandbox_libraries.h"
#include "lua/sandbox_raise.h"
#include "lua/state.h"

namespace shadowlab::lua {
namespace {

constexpr std::uint64_t cost_of_switch = 50;  // in instructions
// coroutine.close runs __close functions; Lua 5.4.4 does not count that against the depth of C
// calls.
constexpr int deepest_close = 8;

// The body of every coroutine: stack: function, arguments. The protected call turns Lua's hooks on
// again after an error that the hook raised; without it, closing the dead coroutine would run
// __close functions that no hook can stop.
int finish_body(lua_State* L, int status, lua_KContext) {
  if (status == LUA_OK || status == LUA_YIELD) return lua_gettop(L);
  return lua_error(L);
}

int body(lua_State* L) {
  const int status = lua_pcallk(L, lua_gettop(L) - 1, LUA_MULTRET, 0, 0, finish_body);
  return finish_body(L, status, 0);
}

lua_State* coroutine_at(lua_State* L, int index) {
  lua_State* co = lua_tothread(L, index);
  luaL_argexpected(L, co, index, "coroutine");
  return co;
}

int create(lua_State* L) {
  luaL_checktype(L, 1, LUA_TFUNCTION);
  State& state = State::of(L);
  // Its count is its own, so up to an interval of its instructions goes unseen.
  state.check_budget(static_cast<std::uint64_t>(state.budget().interval()));
  lua_State* co = lua_newthread(L);
  lua_pushcfunction(co, guarded<body>);
  lua_pushvalue(L, 1);
  lua_xmove(L, co, 1);
  return 1;
}

// The thread whose code runs now is the one whose hook the budget must arm.
class Switch {
 public:
  Switch(Budget& budget, lua_State* from, lua_State* to) : budget_(budget), from_(from) {
    budget_.set_running(to);
    budget_.arm(to);
  }
  ~Switch() {
    budget_.set_running(from_);
    budget_.arm(from_);
  }
  Switch(const Switch&) = delete;
  Switch& operator=(const Switch&) = delete;

 private:
  Budget& budget_;
  lua_State* from_;
};

bool is_fresh(lua_State* co) {
  lua_Debug frame;
  return lua_status(co) == LUA_OK && !lua_getstack(co, 0, &frame) && lua_gettop(co) > 0;
}

int fail(lua_State* L, const char* message) {
  lua_pushstring(L, message);
  return -1;
}

// Resumes `co` with the `arguments` values on top of L's stack, and leaves there its results, whose
// number it returns, or its error, and returns -1.
int resume_with(lua_State* L, lua_State* co, int arguments) {
  State& state = State::of(L);
  state.check_budget(cost_of_switch);
  if (!lua_checkstack(co, arguments)) return fail(L, "too many arguments to resume");
  const int pushed = is_fresh(co) ? arguments + 1 : arguments;  // the function below them
  lua_xmove(L, co, arguments);
  int results = 0;
  int status = LUA_OK;
  {
    const Switch to_co(state.budget(), L, co);
    status = lua_resume(co, L, pushed, &results);
  }
  if (state.exhausted()) raise_exhausted(L);
  if (status != LUA_OK && status != LUA_YIELD) {
    lua_xmove(co, L, 1);
    return -1;
  }
  if (!lua_checkstack(L, results + 1)) {
    lua_pop(co, results);
    return fail(L, "too many results to resume");
  }
  lua_xmove(co, L, results);
  return results;
}

int resume(lua_State* L) {
  lua_State* co = coroutine_at(L, 1);
  const int results = resume_with(L, co, lua_gettop(L) - 1);
  lua_pushboolean(L, results >= 0);
  const int returned = results >= 0 ? results + 1 : 2;
  lua_insert(L, -returned);
  return returned;
}

int resume_wrapped(lua_State* L) {
  lua_State* co = coroutine_at(L, lua_upvalueindex(1));
  const int results = resume_with(L, co, lua_gettop(L));
  return results >= 0 ? results : lua_error(L);
}

int wrap(lua_State* L) {
  create(L);
  lua_pushcclosure(L, guarded<resume_wrapped>, 1);
  return 1;
}

int close(lua_State* L) {
  State& state = State::of(L);
  lua_State* co = coroutine_at(L, 1);
  lua_Debug frame;
  const int before = lua_status(co);
  if (co == L || (before == LUA_OK && lua_getstack(co, 0, &frame)))
    return luaL_error(L, "coroutine.close: a coroutine that runs cannot be closed");
  state.check_budget(cost_of_switch);
  if (state.closing() >= deepest_close)
    return luaL_error(L, "coroutine.close: too many coroutines close each other");
  int status = LUA_OK;
  ++state.closing();
  {
    const Switch to_co(state.budget(), L, co);
    status = lua_resetthread(co);
  }
  --state.closing();
  if (state.exhausted()) raise_exhausted(L);
  lua_pushboolean(L, status == LUA_OK);
  if (status == LUA_OK) return 1;
  lua_xmove(co, L, 1);
  return 2;
}

constexpr luaL_Reg own_functions[] = {
    {"close", guarded<close>}, {"create", guarded<create>}, {"resume", guarded<resume>},
    {"wrap", guarded<wrap>},   {nullptr, nullptr},
};

}  // namespace

void add_coroutine(lua_State* L) {
  lua_pushcfunction(L, luaopen_coroutine);
  lua_call(L, 0, 1);
  luaL_setfuncs(L, own_functions, 0);
  refuse_unknown_names(L, -1, "coroutine");
  lua_setglobal(L, "coroutine");
}

}  // namespace shadowlab::lua
