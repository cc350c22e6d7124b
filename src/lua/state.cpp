#include "lua/state.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <new>
#include <utility>

#include "core/error.h"
#include "lua/guard.h"
#include "lua/sandbox_alarm.h"
#include "lua/sandbox_libraries.h"
#include "lua/sandbox_raise.h"

namespace shadowlab::lua {
namespace {

constexpr std::size_t longest_sentence = 1000;

// Lua gives at most this much of a chunk's name in its messages (LUA_IDSIZE, less "@" and the end).
constexpr std::size_t longest_short_name = LUA_IDSIZE - 1;

int panic(lua_State*) { throw MachineError("there is no memory left to run the recipe"); }

int text_of_error(lua_State* L) {
  if (lua_isnil(L, 1))
    lua_pushliteral(L, "error was called without a message");
  else if (lua_isstring(L, 1) || luaL_getmetafield(L, 1, "__tostring") != LUA_TNIL)
    push_text(L, 1);
  else
    lua_pushfstring(L, "error was called with a %s instead of a message", luaL_typename(L, 1));
  return 1;
}

int run_body(lua_State* L) {
  const auto& body = *static_cast<const std::function<void(lua_State*)>*>(lua_touserdata(L, 1));
  lua_settop(L, 0);
  body(L);
  return 0;
}

// The name as Lua's messages give it: the last characters of a long one.
std::string short_name(const std::string& name) {
  if (name.size() <= longest_short_name) return name;
  return "..." + name.substr(name.size() - (longest_short_name - 3));
}

// The length of "FILE:LINE: " at the start of `message`, if `file` and a line are there.
std::size_t position_length(std::string_view message, std::string_view file) {
  if (!message.starts_with(file)) return 0;
  std::size_t i = file.size();
  if (i >= message.size() || message[i++] != ':') return 0;
  const std::size_t digits = i;
  while (i < message.size() && message[i] >= '0' && message[i] <= '9') ++i;
  if (i == digits || message.substr(i, 2) != ": ") return 0;
  return i + 2;
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  if (text.size() <= longest_sentence) return text;
  std::size_t end = longest_sentence - 3;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole UTF-8
  return text.substr(0, end) + "...";
}

std::string size_text(std::size_t bytes) {
  const std::size_t mebibyte = std::size_t{1} << 20;
  return bytes % mebibyte == 0 ? fmt::format("{} MiB", bytes / mebibyte)
                               : fmt::format("{} bytes", bytes);
}

std::optional<std::string> read_text(const std::filesystem::path& path, std::size_t limit,
                                     std::string& text) {
  namespace fs = std::filesystem;
  const std::string name = path.string();
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) return name + ": there is no such file";
  if (fs::is_directory(status)) return name + ": this is a folder, not a script";
  if (!fs::is_regular_file(status)) return name + ": this is not a plain file";
  std::ifstream file(path, std::ios::binary);
  if (!file) return name + ": the file cannot be read; look at its permissions";
  // In blocks: a script is small, and the limit is not.
  std::array<char, 1 << 14> block;
  while (file && text.size() <= limit) {
    file.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) return name + ": the file cannot be read";
  if (text.size() > limit)
    return fmt::format("{}: the file is larger than {}, too large for a script", name,
                       size_text(limit));
  return std::nullopt;
}

}  // namespace

State& State::of(lua_State* L) { return **static_cast<State**>(lua_getextraspace(L)); }

State::State(const Limits& limits, PrintSink print)
    : limits_(limits),
      print_(std::move(print)),
      budget_(limits.instructions, limits.seconds),
      heap_(limits.memory, budget_) {
  lua_ = lua_newstate(Heap::allocate, &heap_);
  if (!lua_) throw MachineError("there is no memory to start Lua");
  heap_.serve(lua_);
  *static_cast<State**>(lua_getextraspace(lua_)) = this;
  lua_atpanic(lua_, panic);
  lua_pushcfunction(lua_, guarded<open_libraries>);
  if (lua_pcall(lua_, 0, 0, 0) != LUA_OK) {
    lua_close(lua_);
    throw MachineError("there is not enough memory for Lua's libraries");
  }
  budget_.restart(lua_);
}

State::~State() { lua_close(lua_); }

std::optional<std::string> State::try_load_file(lua_State* L, const std::filesystem::path& path) {
  note_file(path);
  std::string text;
  if (auto problem = read_text(path, limits_.source, text)) return problem;
  return try_load_text(L, text, path.string());
}

std::optional<std::string> State::try_load_text(lua_State* L, std::string_view text,
                                                const std::string& name) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  // "#!/usr/bin/env ..." goes, its newline stays: lines keep their numbers.
  if (text.starts_with('#')) text.remove_prefix(std::min(text.find('\n'), text.size()));
  if (text.starts_with('\x1b'))
    return name + ": this is compiled Lua; give the text of the script instead";
  if (text.size() > limits_.source)
    return fmt::format("{}: the text is larger than {}, too large for a script", name,
                       size_text(limits_.source));
  budget_.spend(4 * text.size());
  if (!lua_checkstack(L, 4)) return name + ": the stack of Lua is full";
  if (std::ranges::find(chunk_names_, name) == chunk_names_.end()) chunk_names_.push_back(name);
  const std::string chunk = "@" + name;
  const int status = luaL_loadbufferx(L, text.data(), text.size(), chunk.c_str(), "t");
  if (status == LUA_OK) return std::nullopt;
  std::string problem = status == LUA_ERRMEM
                            ? fmt::format("{}: the script needs more than {} of memory", name,
                                          size_text(limits_.memory))
                            : with_full_names(lua_tostring(L, -1));
  lua_pop(L, 1);
  return one_line(std::move(problem));
}

void State::load_file(const std::filesystem::path& path) {
  if (const auto problem = try_load_file(lua_, path)) throw InputError(*problem);
}

void State::load_text(std::string_view text, const std::string& name) {
  if (const auto problem = try_load_text(lua_, text, name)) throw InputError(*problem);
}

void State::call(int arguments, int results) {
  if (!lua_checkstack(lua_, LUA_MINSTACK)) throw InputError("the stack of Lua is full");
  const int function = lua_gettop(lua_) - arguments;
  lua_pushcfunction(lua_, note_error);
  lua_insert(lua_, function);
  budget_.set_running(lua_);
  const Alarm alarm(budget_);
  budget_.arm(lua_);
  const int status = lua_pcall(lua_, arguments, results, function);
  lua_remove(lua_, function);
  if (status != LUA_OK) throw InputError(sentence_of_error(status));
}

void State::run(const std::function<void(lua_State*)>& body) {
  lua_pushcfunction(lua_, guarded<run_body>);
  lua_pushlightuserdata(lua_, const_cast<std::function<void(lua_State*)>*>(&body));
  call(1, 0);
}

// The message handler of `call`: it runs where the error is, before anything is unwound, and inside
// the hook if that raised it; so it must not run a line of the script.
int State::note_error(lua_State* L) {
  State& self = of(L);
  try {
    self.failed_at_ = position_of(L);
    if (self.place_) self.failed_place_ = self.place_();
  } catch (const std::exception&) {  // out of memory: the error goes on without its place
  }
  return 1;
}

std::string State::sentence_of_error(int status) {
  std::string message;
  if (status == LUA_ERRERR) {
    message = "stack overflow";
  } else if (status == LUA_ERRMEM) {
    failed_at_ = heap_.refused_at();
    message = "not enough memory";
  } else if (status == LUA_ERRRUN && !exhausted()) {
    lua_pushcfunction(lua_, guarded<text_of_error>);
    lua_pushvalue(lua_, -2);
    if (lua_pcall(lua_, 1, 1, 0) == LUA_OK) {
      std::size_t length = 0;
      const char* text = lua_tolstring(lua_, -1, &length);
      // What is cut away is not worth copying; the names at its beginning may still grow.
      message.assign(text, std::min(length, 4 * longest_sentence));
    } else {
      message = "the error's own __tostring failed";
    }
    lua_pop(lua_, 1);
  }
  lua_pop(lua_, 1);
  if (exhausted()) message = budget_.sentence();

  message = with_full_names(std::move(message));
  std::string position = with_full_names(std::exchange(failed_at_, {}));
  for (const std::string& name : chunk_names_)
    if (const std::size_t length = position_length(message, name)) {
      position = message.substr(0, length);
      message.erase(0, length);
      break;
    }
  if (message.starts_with("stack overflow") || message.starts_with("C stack overflow"))
    message = "functions call each other too deeply (stack overflow); does a recursion never end?";
  if (message == "not enough memory")
    message = "the recipe needs more than " + size_text(limits_.memory) + " of memory";
  const std::string place = std::exchange(failed_place_, {});
  return one_line(position + (place.empty() ? "" : place + ": ") + message);
}

// Lua's messages shorten a long path to its end: the full one takes its place again.
std::string State::with_full_names(std::string message) const {
  if (!message.starts_with("...")) return message;
  for (const std::string& name : chunk_names_) {
    const std::string shortened = short_name(name);
    if (name.size() > longest_short_name && position_length(message, shortened))
      return name + message.substr(shortened.size());
  }
  return message;
}

void State::check_budget(std::uint64_t cost) {
  budget_.spend(cost);
  if (exhausted()) throw InputError(budget_.sentence());
}

void State::reserve(std::size_t bytes) {
  if (heap_.take(bytes)) return;
  throw InputError("the recipe needs more than " + size_text(limits_.memory) + " of memory");
}

void State::print(std::string_view line) {
  if (printed_ > limits_.printed) return;
  const std::size_t room = limits_.printed - printed_;
  printed_ += line.size();
  if (line.size() <= room) {
    print_(line);
    return;
  }
  printed_ = limits_.printed + 1;
  print_(fmt::format("... the recipe printed more than {}; the rest is not shown\n",
                     size_text(limits_.printed)));
}

}  // namespace shadowlab::lua
