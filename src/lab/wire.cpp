#include "lab/wire.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

namespace shadowlab::lab::wire {
namespace {

// "SLW" and the version: another version of the program is no partner.
constexpr std::uint32_t magic = 0x32574C53;
static_assert(std::endian::native == std::endian::little, "both ends run on one machine");

class Writer {
 public:
  /// `room`: bytes that it is likely to have.
  explicit Writer(Kind kind, std::size_t room = 0) {
    bytes_.reserve(room);
    put(magic);
    put(static_cast<std::uint32_t>(kind));
    put(std::uint64_t{0});
  }

  template <typename T>
  requires std::is_arithmetic_v<T>
  void put(T value) { put_bytes({reinterpret_cast<const std::uint8_t*>(&value), sizeof value}); }
  void put(const std::string& text) {
    put_size(text.size());
    put_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  void put_size(std::size_t size) { put(static_cast<std::uint64_t>(size)); }
  template <typename T>
  requires std::is_arithmetic_v<T>
  void put(const std::vector<T>& values) {
    put_size(values.size());
    put_bytes({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)});
  }
  template <typename T>
  void put(const std::optional<T>& value) {
    put(static_cast<std::uint8_t>(value.has_value()));
    if (value) put(*value);
  }

  Bytes finish() {
    const std::uint64_t length = bytes_.size() - header_size;
    std::memcpy(bytes_.data() + 8, &length, sizeof length);
    return std::move(bytes_);
  }

 private:
  void put_bytes(std::span<const std::uint8_t> bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }

  Bytes bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <typename T>
  requires std::is_arithmetic_v<T> T get() {
    T value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string text() {
    const auto bytes = take(count_of(1));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  template <typename T>
  std::vector<T> numbers() {
    const std::size_t count = count_of(sizeof(T));
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), take(count * sizeof(T)).data(), count * sizeof(T));
    return values;
  }
  bool flag() {
    const auto byte = get<std::uint8_t>();
    if (byte > 1) throw Garbled("a yes or no is neither");
    return byte == 1;
  }
  /// How many things follow, each of which takes `least` bytes or more.
  std::size_t count_of(std::size_t least) {
    const auto count = get<std::uint64_t>();
    if (count > rest_.size() / least) throw Garbled("a count is larger than what follows it");
    return static_cast<std::size_t>(count);
  }
  void expect_end() const {
    if (!rest_.empty()) throw Garbled("bytes are left over");
  }

 private:
  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > rest_.size()) throw Garbled("the message ends too soon");
    const auto taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  std::span<const std::uint8_t> rest_;
};

void put_point(Writer& to, const glm::dvec3& point) {
  for (int i = 0; i < 3; ++i) to.put(point[i]);
}

glm::dvec3 get_point(Reader& from) {
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) point[i] = from.get<double>();
  return point;
}

void put_shot(Writer& to, const Shot& shot) {
  to.put(shot.scene);
  to.put_size(shot.settings.size());
  for (const auto& [name, value] : shot.settings) {
    to.put(name);
    to.put(value);
  }
  to.put_size(shot.changes.size());
  for (const Change& change : shot.changes) {
    to.put_size(change.call);
    to.put(change.function);
    to.put_size(change.arguments.size());
    for (const std::string& argument : change.arguments) to.put(argument);
  }
  to.put(static_cast<std::uint8_t>(shot.camera.has_value()));
  if (!shot.camera) return;
  put_point(to, shot.camera->eye);
  put_point(to, shot.camera->target);
  put_point(to, shot.camera->up);
  to.put(shot.camera->fovy);
  to.put(shot.camera->near);
  to.put(shot.camera->far);
}

Shot get_shot(Reader& from) {
  Shot shot;
  if (from.flag()) shot.scene = from.text();
  const std::size_t settings = from.count_of(16);
  for (std::size_t i = 0; i < settings; ++i) {
    std::string name = from.text();
    shot.settings.emplace_back(std::move(name), from.text());
  }
  const std::size_t changes = from.count_of(24);
  for (std::size_t i = 0; i < changes; ++i) {
    Change change;
    change.call = from.get<std::uint64_t>();
    change.function = from.text();
    const std::size_t arguments = from.count_of(8);
    for (std::size_t k = 0; k < arguments; ++k) change.arguments.push_back(from.text());
    shot.changes.push_back(std::move(change));
  }
  if (!from.flag()) return shot;
  scene::Camera camera;
  camera.eye = get_point(from);
  camera.target = get_point(from);
  camera.up = get_point(from);
  camera.fovy = from.get<double>();
  camera.near = from.get<double>();
  camera.far = from.get<double>();
  shot.camera = camera;
  return shot;
}

void put_kept(Writer& to, const Kept& kept) {
  for (const bool one : {kept.color, kept.depth, kept.stencil})
    to.put(static_cast<std::uint8_t>(one));
}

Kept get_kept(Reader& from) {
  Kept kept;
  for (bool* one : {&kept.color, &kept.depth, &kept.stencil}) *one = from.flag();
  return kept;
}

std::size_t bytes_of(const Buffers& buffers) {
  return buffers.color.rgba.size() + buffers.depth.values.size() * sizeof(float) +
         buffers.stencil.size();
}

void put_buffers(Writer& to, const Buffers& buffers) {
  to.put(buffers.pass);
  to.put(buffers.color.rgba);
  to.put(buffers.depth.values);
  to.put(buffers.stencil);
}

// What people will read: a terminal or a page must not take any of it for orders.
std::string plain(std::string text) {
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < ' ' && c != '\n' && c != '\t') || byte == 0x7f) c = '?';
  }
  return text;
}

Buffers get_buffers(Reader& from, const Job& job, const Kept& kept) {
  Buffers buffers;
  buffers.pass = plain(from.text());
  buffers.color.rgba = from.numbers<std::uint8_t>();
  buffers.depth.values = from.numbers<float>();
  buffers.stencil = from.numbers<std::uint8_t>();
  const auto pixels = static_cast<std::size_t>(job.width) * static_cast<std::size_t>(job.height);
  const auto fits = [&](bool asked, std::size_t size, std::size_t channels) {
    return size == 0 || (asked && size == pixels * channels);
  };
  if (!fits(kept.color, buffers.color.rgba.size(), 4) ||
      !fits(kept.depth, buffers.depth.values.size(), 1) ||
      !fits(kept.stencil, buffers.stencil.size(), 1))
    throw Garbled("a picture has another size than was asked for");
  if (!std::ranges::all_of(buffers.depth.values, [](float d) { return d >= 0 && d <= 1; }))
    throw Garbled("a depth is not between 0 and 1");
  if (!buffers.color.rgba.empty()) {
    buffers.color.width = job.width;
    buffers.color.height = job.height;
  }
  if (!buffers.depth.values.empty()) {
    buffers.depth.width = job.width;
    buffers.depth.height = job.height;
  }
  return buffers;
}

// A call's pass may lie past the passes that are kept: it was one too many, or it never ended.
Call get_call(Reader& from) {
  Call call;
  call.function = plain(from.text());
  const std::size_t arguments = from.count_of(8);
  for (std::size_t i = 0; i < arguments; ++i) call.arguments.push_back(plain(from.text()));
  call.pass = from.get<std::int32_t>();
  if (call.pass < -1) throw Garbled("a call belongs to no pass that could be");
  call.comment = plain(from.text());
  return call;
}

}  // namespace

Header header_from(std::span<const std::uint8_t, header_size> bytes) {
  Reader from(bytes);
  if (from.get<std::uint32_t>() != magic)
    throw Garbled("it is no message, or one of another version");
  const auto kind = from.get<std::uint32_t>();
  if (kind < static_cast<std::uint32_t>(Kind::job) || kind > static_cast<std::uint32_t>(Kind::done))
    throw Garbled("it is a message of an unknown kind");
  return {static_cast<Kind>(kind), from.get<std::uint64_t>()};
}

Bytes message_of(const Job& job) {
  Writer to(Kind::job);
  to.put(job.recipe.string());
  to.put(static_cast<std::int32_t>(job.width));
  to.put(static_cast<std::int32_t>(job.height));
  to.put_size(job.shots.size());
  for (const Shot& shot : job.shots) put_shot(to, shot);
  put_kept(to, job.frame);
  put_kept(to, job.passes);
  to.put(static_cast<std::uint8_t>(job.calls));
  to.put(static_cast<std::uint64_t>(job.limits.memory));
  to.put(job.limits.instructions);
  to.put(job.limits.seconds);
  to.put(static_cast<std::uint64_t>(job.limits.printed));
  to.put(static_cast<std::uint64_t>(job.limits.source));
  return to.finish();
}

Job job_from(std::span<const std::uint8_t> bytes) {
  Reader from(bytes);
  Job job;
  job.recipe = from.text();
  job.width = from.get<std::int32_t>();
  job.height = from.get<std::int32_t>();
  if (job.width < 1 || job.height < 1 || job.width > 16384 || job.height > 16384)
    throw Garbled("a picture's size is out of range");
  const std::size_t shots = from.count_of(10);
  for (std::size_t i = 0; i < shots; ++i) job.shots.push_back(get_shot(from));
  job.frame = get_kept(from);
  job.passes = get_kept(from);
  job.calls = from.flag();
  job.limits.memory = from.get<std::uint64_t>();
  job.limits.instructions = from.get<std::uint64_t>();
  job.limits.seconds = from.get<double>();
  job.limits.printed = from.get<std::uint64_t>();
  job.limits.source = from.get<std::uint64_t>();
  from.expect_end();
  return job;
}

Bytes message_of(std::size_t shot, const Drawing& drawing) {
  std::size_t pixels = bytes_of(drawing.frame);
  for (const Buffers& pass : drawing.passes) pixels += bytes_of(pass);
  Writer to(Kind::drawing, pixels + (std::size_t{1} << 16));
  to.put_size(shot);
  to.put(drawing.error);
  put_buffers(to, drawing.frame);
  to.put_size(drawing.passes.size());
  for (const Buffers& pass : drawing.passes) put_buffers(to, pass);
  to.put_size(drawing.calls.size());
  for (const Call& call : drawing.calls) {
    to.put(call.function);
    to.put_size(call.arguments.size());
    for (const std::string& argument : call.arguments) to.put(argument);
    to.put(static_cast<std::int32_t>(call.pass));
    to.put(call.comment);
  }
  to.put(drawing.printed);
  to.put(drawing.milliseconds);
  return to.finish();
}

ShotDrawing drawing_from(std::span<const std::uint8_t> bytes, const Job& job) {
  Reader from(bytes);
  const auto shot = from.get<std::uint64_t>();
  if (shot >= job.shots.size()) throw Garbled("it is a drawing that nobody asked for");
  ShotDrawing result{static_cast<std::size_t>(shot), {}};
  Drawing& drawing = result.drawing;
  if (from.flag()) drawing.error = plain(from.text());
  drawing.frame = get_buffers(from, job, job.frame);
  const std::size_t passes = from.count_of(32);
  if (passes > (job.passes.any() ? most_passes : 0))
    throw Garbled("it has passes that nobody asked for");
  for (std::size_t i = 0; i < passes; ++i)
    drawing.passes.push_back(get_buffers(from, job, job.passes));
  const std::size_t calls = from.count_of(20);
  if (calls > (job.calls ? most_calls : 0)) throw Garbled("it has more calls than were asked for");
  for (std::size_t i = 0; i < calls; ++i) drawing.calls.push_back(get_call(from));
  drawing.printed = plain(from.text());
  drawing.milliseconds = from.get<double>();
  if (!std::isfinite(drawing.milliseconds) || drawing.milliseconds < 0)
    throw Garbled("a time is no time");
  from.expect_end();
  return result;
}

Bytes done_message() { return Writer(Kind::done).finish(); }

}  // namespace shadowlab::lab::wire
