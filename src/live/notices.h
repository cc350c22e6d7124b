// What the system says of the files in folders: which were written and closed, or put in place.
//
// A file of which it is said is whole. It is not said of everything: not of what another machine
// writes into a network's folder, nor of what a link leads to; and not at all where the system has
// no inotify.
#pragma once

#include <filesystem>
#include <map>
#include <set>

namespace shadowlab::live {

class Notices {
 public:
  Notices();
  ~Notices();
  Notices(const Notices&) = delete;
  Notices& operator=(const Notices&) = delete;

  /// Listens to the folder that the file is in, or would be in.
  void listen_to(const std::filesystem::path& file);
  /// The files in those folders that were completed since the last call; by the names that
  /// `listen_to` had the folders by.
  std::set<std::filesystem::path> completed();

 private:
  int queue_;                                               ///< -1 where there is none
  std::map<int, std::set<std::filesystem::path>> folders_;  ///< by inotify's number; names of one
};

}  // namespace shadowlab::live
