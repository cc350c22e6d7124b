// Descriptors, and messages that carry them from process to process: internal to this floor.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace shadowlab::lab {

/// Owns a descriptor of the system.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) {
      close();
      number_ = std::exchange(other.number_, -1);
    }
    return *this;
  }
  ~Descriptor() { close(); }

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close();
  int release() { return std::exchange(number_, -1); }

 private:
  int number_ = -1;
};

/// The two ends of something that goes from one process to another. No program that is started by
/// exec inherits them.
struct Ends {
  Descriptor ours, theirs;
};

/// Both ways, a stream of bytes. Throws MachineError where the system has no more to give.
Ends make_stream();
/// Both ways, whole messages of at most 4 KiB that may carry descriptors.
Ends make_messages();
/// From theirs to ours.
Ends make_pipe();

void make_nonblocking(int descriptor);

/// Writes all of it to a socket, however long the reader takes; false where nobody reads it any
/// more.
bool write_all(int socket, std::span<const std::uint8_t> bytes);
/// Reads exactly so many; false where they end before.
bool read_all(int descriptor, std::span<std::uint8_t> bytes);

/// One message, with copies of the descriptors; false where nobody takes it.
bool send_message(int socket, std::span<const std::uint8_t> bytes, std::span<const int> with = {});

struct Message {
  std::vector<std::uint8_t> bytes;
  std::vector<Descriptor> descriptors;
};
/// The next message, however long it takes to come; nothing when the other end is gone.
std::optional<Message> receive_message(int socket);

}  // namespace shadowlab::lab
