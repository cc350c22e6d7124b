#include "lab/reception.h"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>

namespace shadowlab::lab {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t block_size = std::size_t{1} << 18;

// As read(2) on a descriptor that does not block; nothing when there is nothing now.
std::optional<std::size_t> read_some(const Descriptor& from, std::span<std::uint8_t> block) {
  while (true) {
    const ssize_t got = ::read(from.number(), block.data(), block.size());
    if (got >= 0) return static_cast<std::size_t>(got);
    if (errno == EINTR) continue;
    if (errno == EAGAIN) return std::nullopt;
    return 0;  // a reset connection is one that has ended
  }
}

}  // namespace

void Reception::receive(Lines& lines, std::span<const std::uint8_t> order) {
  for (const Descriptor* each : {&lines.channel, &lines.out, &lines.err, &lines.word})
    make_nonblocking(each->number());
  unread_.clear();
  received_ = shots = 0;
  lost = false;
  const auto begin = Clock::now();
  while (!ended && !lost) {
    const std::chrono::duration<double> spent = Clock::now() - begin;
    const double left = isolation_.seconds + grace_seconds - spent.count();
    if (left <= 0) break;
    // A closed line has the number -1, which poll passes over.
    std::array<pollfd, 4> watched{
        pollfd{lines.channel.number(), POLLIN, 0}, pollfd{lines.out.number(), POLLIN, 0},
        pollfd{lines.err.number(), POLLIN, 0}, pollfd{lines.word.number(), POLLIN, 0}};
    if (!order.empty()) watched[0].events |= POLLOUT;
    if (::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(left * 1000))) < 0)
      continue;
    if (watched[0].revents & POLLOUT) {
      const ssize_t sent = ::send(lines.channel.number(), order.data(), order.size(), MSG_NOSIGNAL);
      order = sent > 0          ? order.subspan(static_cast<std::size_t>(sent))
              : errno == EAGAIN ? order
                                : std::span<const std::uint8_t>();
    }
    // The end is read first and looked at last: whatever was sent before it is here by then.
    if (watched[3].revents) read_end(lines.word);
    if (watched[0].revents || ended) read_channel(lines.channel);
    if (watched[1].revents || ended) read_words(lines.out, out);
    if (watched[2].revents || ended) read_words(lines.err, err);
    if (flooded || garbled) return;
  }
  unanswered = !ended && !lost;
}

void Reception::read_end(Descriptor& word) {
  Ended last{};
  const auto got = read_some(word, {reinterpret_cast<std::uint8_t*>(&last), sizeof last});
  if (!got) return;
  if (*got == sizeof last) ended = last;
  if (*got == 0) lost = true;
}

void Reception::read_words(Descriptor& from, std::string& words) {
  std::array<std::uint8_t, 4096> block{};
  while (from.is_open()) {
    const auto got = read_some(from, block);
    if (!got) return;
    if (*got == 0) return from.close();
    const std::size_t room = isolation_.words - words.size();
    words.append(reinterpret_cast<const char*>(block.data()), std::min(*got, room));
    if (*got > room) flooded = true;
    if (flooded) return;
  }
}

void Reception::read_channel(Descriptor& channel) {
  while (channel.is_open()) {
    const std::size_t before = unread_.size();
    unread_.resize(before + block_size);
    const auto got = read_some(channel, std::span(unread_).subspan(before));
    unread_.resize(before + got.value_or(0));
    if (!got) return;
    if (*got == 0) return channel.close();
    received_ += *got;
    if (received_ > isolation_.results) flooded = true;
    if (flooded) return;
    take_messages();
    if (garbled) return;
  }
}

void Reception::take_messages() {
  std::span<const std::uint8_t> rest(unread_);
  try {
    while (rest.size() >= wire::header_size) {
      const wire::Header header = wire::header_from(rest.first<wire::header_size>());
      if (header.length > isolation_.results) {
        flooded = true;
        return;
      }
      const auto length = static_cast<std::size_t>(header.length);
      if (rest.size() - wire::header_size < length) break;
      take(header, rest.subspan(wire::header_size, length));
      rest = rest.subspan(wire::header_size + length);
    }
  } catch (const wire::Garbled& problem) {
    garbled = problem.what();
    return;
  }
  unread_.erase(unread_.begin(), unread_.end() - static_cast<std::ptrdiff_t>(rest.size()));
}

void Reception::take(wire::Header header, std::span<const std::uint8_t> body) {
  if (done) throw wire::Garbled("something follows the end");
  if (header.kind == wire::Kind::done) {
    if (shots != job_.shots.size()) throw wire::Garbled("a drawing is missing");
    if (!body.empty()) throw wire::Garbled("the end has a content");
    done = true;
    return;
  }
  if (header.kind != wire::Kind::drawing) throw wire::Garbled("it is no drawing");
  wire::ShotDrawing drawn = wire::drawing_from(body, job_);
  if (drawn.shot != shots) throw wire::Garbled("the drawings are not in their order");
  ++shots;
  if (shots <= handed_over) return;
  ++handed_over;
  if (drawn.drawing.error && !first_error) first_error = drawn.drawing.error;
  each_(drawn.shot, std::move(drawn.drawing));
}

}  // namespace shadowlab::lab
