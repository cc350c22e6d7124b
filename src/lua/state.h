// A sandboxed Lua state: what a recipe runs in.
//
//   State state({}, [](std::string_view line) { std::cout << line; });
//   state.search_in({"scripts"});
//   state.load_file("scripts/a.lua");
//   state.call(0, 1);                       // throws InputError: "scripts/a.lua:12: ..."
//
// What it does not do: it is no boundary against bugs of Lua itself. A hostile script belongs in a
// process of its own besides.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <lua.hpp>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "lua/sandbox_budget.h"
#include "lua/sandbox_heap.h"

namespace shadowlab::lua {

/// What a script may use up. Time and instructions are counted from the last `restart_budget`.
struct Limits {
  std::size_t memory = std::size_t{512} << 20;  ///< bytes alive: Lua's, and what bindings reserve
  std::uint64_t instructions = uncounted;       ///< counting them costs half of Lua's speed
  double seconds = 120;
  std::size_t printed = std::size_t{1} << 20;  ///< bytes, over the life of the state
  std::size_t source = std::size_t{1} << 20;   ///< bytes of one file
};

/// Receives what the script prints, a line with its newline at a time.
using PrintSink = std::function<void(std::string_view)>;
/// Says where the script is beyond file and line: `in pass "2. the shadow"`, or nothing.
using Place = std::function<std::string()>;

/// One Lua state with the safe libraries, the search for modules, the memory cap and the budget.
/// Stays where it was made: Lua keeps its address.
class State {
 public:
  State(const Limits& limits, PrintSink print);
  ~State();
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  lua_State* raw() const { return lua_; }
  /// The State that `L`, its main thread or one of its coroutines, belongs to.
  static State& of(lua_State* L);

  const Limits& limits() const { return limits_; }

  /// Leaves the file's chunk on the stack as a function. Text only; errors name the path as given.
  /// Throws InputError for a file that is missing, unreadable, too large, compiled or not Lua.
  void load_file(const std::filesystem::path& path);
  /// The same for a text; `name` takes the place of the path in errors.
  void load_text(std::string_view text, const std::string& name);

  /// Calls the function below `arguments` arguments on the main thread's stack and leaves `results`
  /// results (or LUA_MULTRET). Any error of Lua becomes an InputError of one sentence that begins
  /// "file:line:", then the place, at most 1,000 characters of it. Native code that runs inside the
  /// script calls back with lua_call instead, so that the error keeps its first position.
  void call(int arguments, int results);

  /// Runs `body` as a script is run, protected and budgeted, with an empty stack: for what of a
  /// script's own may run within (metamethods of its tables), and for a lack of memory.
  void run(const std::function<void(lua_State*)>& body);

  /// Sets what adds the place to errors; called while the failing function is still running.
  void set_place(Place place) { place_ = std::move(place); }

  /// Asked every 20 ms while the script runs, whether it is to end: "the recipe was stopped".
  void stop_when(std::function<bool()> stop) { budget_.stop_when(std::move(stop)); }

  /// A fresh time and instruction budget, as each frame gets. Not while the script runs.
  void restart_budget() { budget_.restart(lua_); }
  /// Counts long native work, in instructions of Lua (about 2 ns each). Throws InputError when the
  /// budget is exhausted.
  void check_budget(std::uint64_t cost);
  bool exhausted() const { return budget_.exhausted(); }

  /// Counts memory that a binding holds for the script outside Lua. Throws InputError past the cap.
  void reserve(std::size_t bytes);
  void release(std::size_t bytes) noexcept { heap_.give(bytes); }

  /// The folders in which `require "a.b"` looks for a/b.lua, first to last.
  void search_in(std::vector<std::filesystem::path> folders) { folders_ = std::move(folders); }
  const std::vector<std::filesystem::path>& search_folders() const { return folders_; }
  /// Told of each file that the script is made of, before it is read, and of each that would be in
  /// its place if it were there: when one of them changes, the script may.
  void on_file(std::function<void(const std::filesystem::path&)> listener) {
    file_listener_ = std::move(listener);
  }
  void note_file(const std::filesystem::path& file) const {
    if (file_listener_) file_listener_(file);
  }
  /// How many calls of coroutine.close are inside each other.
  int& closing() { return closing_; }
  /// The modules whose code is running because of `require`, outermost first.
  std::vector<std::string>& modules_under_way() { return under_way_; }

  /// Prints as the script does: through the sink, up to the cap.
  void print(std::string_view line);

  /// The generator behind math.random; starts from the same seed in every state.
  std::mt19937_64& random() { return random_; }
  Budget& budget() { return budget_; }
  /// For tests: the bytes alive, and failing allocations on purpose.
  Heap& heap() { return heap_; }

  /// Pushes the chunk onto `L` and gives nothing, or gives the sentence that says why not.
  std::optional<std::string> try_load_file(lua_State* L, const std::filesystem::path& path);
  std::optional<std::string> try_load_text(lua_State* L, std::string_view text,
                                           const std::string& name);

 private:
  static int note_error(lua_State* L);
  std::string sentence_of_error(int status);
  std::string with_full_names(std::string message) const;

  Limits limits_;
  PrintSink print_;
  Place place_;
  Budget budget_;
  Heap heap_;
  std::mt19937_64 random_;
  std::vector<std::filesystem::path> folders_;
  std::function<void(const std::filesystem::path&)> file_listener_;
  std::vector<std::string> under_way_;
  std::vector<std::string> chunk_names_;
  std::string failed_at_;     // "FILE:LINE: " of the error on its way out
  std::string failed_place_;  // what place_ said then
  std::size_t printed_ = 0;
  int closing_ = 0;
  lua_State* lua_ = nullptr;
};

/// Pushes the text of the value at `index` as tostring gives it: never an address. May run
/// __tostring. Use it instead of luaL_tolstring.
std::string_view push_text(lua_State* L, int index);

/// Reading a name that the table at `index` lacks becomes an error that names the near ones:
/// "MODULE.nmae does not exist; did you mean MODULE.name?". The table must have no metatable yet.
void refuse_unknown_names(lua_State* L, int index, const char* module);

/// Hides the metatable at `index` from getmetatable and setmetatable. Every metatable of ours is
/// locked.
void lock_metatable(lua_State* L, int index);

}  // namespace shadowlab::lua
