// Files that are watched for what an editor does to them.
//
// They are looked at: a look is a stat of some dozens of files, it sees an editor that writes by
// rename, a network's folder and a file that was not there before alike, and tests say when it
// happens. A file counts as changed when its contents are others, and once it is whole: the system
// says so (live/notices.h), or it has rested from one look to the next. So half of a file that is
// being written is seldom read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>

#include "live/notices.h"

namespace shadowlab::live {

class Watcher {
 public:
  /// This file too, against what it is now; nothing changes where it is watched already.
  void watch(const std::filesystem::path& file);
  /// Of the files that are watched, these alone from now on.
  void keep(const std::set<std::filesystem::path>& files);

  /// Whether any has changed since it was last told of, and is whole. At the fourth look a file
  /// that does not rest counts too.
  bool changed();

 private:
  struct Stamp {
    bool exists = false;
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t modified = 0;  ///< ns
    bool operator==(const Stamp&) const = default;
  };
  struct File {
    Stamp told;            ///< as it was when `changed` last told of it
    std::size_t contents;  ///< their hash, then
    Stamp seen;            ///< at the last look
    int restless = 0;      ///< looks at which it was another each time
  };
  static Stamp look(const std::filesystem::path& file);
  static std::size_t hash_of(const std::filesystem::path& file, const Stamp& stamp);
  static bool may_change_unseen(const Stamp& stamp);

  std::map<std::filesystem::path, File> files_;
  Notices notices_;
};

}  // namespace shadowlab::live
