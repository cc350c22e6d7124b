// What comes from the process that draws a submission is held against what was asked of it.
#include "lab/wire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

namespace shadowlab::lab::wire {
namespace {

std::span<const std::uint8_t> body_of(const Bytes& message) {
  const Header header = header_from(std::span(message).first<header_size>());
  EXPECT_EQ(header.length, message.size() - header_size);
  return std::span(message).subspan(header_size);
}

Job a_job() {
  Job job{.recipe = "a recipe.lua", .width = 3, .height = 2, .passes = everything, .calls = true};
  job.shots.push_back({.scene = "table", .settings = {{"light", "1,2,3"}, {"name", ""}}});
  job.shots.push_back({.camera = scene::Camera{.eye = {1, 2, 3}, .fovy = 30}});
  job.limits.memory = 12345;
  job.limits.seconds = 1.5;
  return job;
}

Buffers buffers_of(const char* pass) {
  Buffers buffers;
  buffers.pass = pass;
  buffers.color = image::Image(3, 2, {1, 2, 3, 4});
  buffers.depth = {3, 2, {0, 0.25f, 0.5f, 0.75f, 1, 1}};
  buffers.stencil = {0, 1, 2, 3, 4, 255};
  return buffers;
}

Drawing a_drawing() {
  Drawing drawing;
  drawing.error = "a recipe.lua:3: no";
  drawing.frame = buffers_of("");
  drawing.passes = {buffers_of("one")};
  drawing.calls = {{"glStencilFunc", {"GL_ALWAYS", "1", "0xFF"}, 0}, {"glFinish", {}, -1}};
  drawing.printed = "a line\nanother\n";
  drawing.milliseconds = 4.5;
  return drawing;
}

TEST(Wire, a_job_arrives_as_it_was_sent) {
  const Job job = job_from(body_of(message_of(a_job())));
  EXPECT_EQ(job.recipe, "a recipe.lua");
  EXPECT_EQ(job.width, 3);
  EXPECT_EQ(job.height, 2);
  EXPECT_EQ(job.frame, everything);
  EXPECT_EQ(job.passes, everything);
  EXPECT_TRUE(job.calls);
  ASSERT_EQ(job.shots.size(), 2u);
  EXPECT_EQ(job.shots[0].scene, "table");
  EXPECT_EQ(job.shots[0].settings, a_job().shots[0].settings);
  EXPECT_FALSE(job.shots[0].camera);
  EXPECT_FALSE(job.shots[1].scene);
  ASSERT_TRUE(job.shots[1].camera);
  EXPECT_EQ(job.shots[1].camera->eye, glm::dvec3(1, 2, 3));
  EXPECT_EQ(job.shots[1].camera->fovy, 30);
  EXPECT_EQ(job.limits.memory, 12345u);
  EXPECT_EQ(job.limits.seconds, 1.5);
  EXPECT_EQ(job.limits.instructions, lua::uncounted);
}

TEST(Wire, a_drawing_arrives_as_it_was_sent) {
  const Drawing sent = a_drawing();
  const auto [shot, got] = drawing_from(body_of(message_of(1, sent)), a_job());
  EXPECT_EQ(shot, 1u);
  EXPECT_EQ(got.error, sent.error);
  EXPECT_TRUE(got.frame.color == sent.frame.color);
  EXPECT_EQ(got.frame.depth.values, sent.frame.depth.values);
  EXPECT_EQ(got.frame.depth.height, 2);
  EXPECT_EQ(got.frame.stencil, sent.frame.stencil);
  ASSERT_EQ(got.passes.size(), 1u);
  EXPECT_EQ(got.passes[0].pass, "one");
  ASSERT_EQ(got.calls.size(), 2u);
  EXPECT_EQ(got.calls[0].arguments, sent.calls[0].arguments);
  EXPECT_EQ(got.calls[1].pass, -1);
  EXPECT_EQ(got.printed, sent.printed);
  EXPECT_EQ(got.milliseconds, 4.5);
}

TEST(Wire, a_message_that_is_cut_short_anywhere_or_has_a_byte_too_many_is_garbled) {
  const Bytes message = message_of(0, a_drawing());
  const auto body = body_of(message);
  for (std::size_t length = 0; length < body.size(); ++length)
    EXPECT_THROW(drawing_from(body.first(length), a_job()), Garbled) << length;
  Bytes longer(body.begin(), body.end());
  longer.push_back(0);
  EXPECT_THROW(drawing_from(longer, a_job()), Garbled);
}

// Every eight bytes in turn become the largest count, and one that overflows when multiplied.
TEST(Wire, no_count_makes_more_than_the_bytes_that_came) {
  const Bytes message = message_of(0, a_drawing());
  for (const std::uint64_t count :
       {~std::uint64_t{0}, std::uint64_t{1} << 62, std::uint64_t{1} << 40}) {
    for (std::size_t i = header_size; i + 8 <= message.size(); ++i) {
      Bytes changed = message;
      std::memcpy(changed.data() + i, &count, 8);
      try {
        const auto got = drawing_from(body_of(changed), a_job());
        EXPECT_LE(got.drawing.calls.size(), 2u);  // it fell into pixels or texts
      } catch (const Garbled&) {
      }
    }
  }
}

TEST(Wire, a_drawing_that_was_not_asked_for_is_garbled) {
  using Change = std::function<void(Drawing&)>;
  for (const Change& change : std::initializer_list<Change>{
           [](Drawing& d) {
             d.frame.color = image::Image(2, 3);
             d.frame.stencil.pop_back();
           },
           [](Drawing& d) { d.frame.color = image::Image(30, 2); },
           [](Drawing& d) { d.passes[0].stencil.push_back(0); },
           [](Drawing& d) { d.frame.depth.values[0] = std::numeric_limits<float>::quiet_NaN(); },
           [](Drawing& d) { d.frame.depth.values[0] = -1; },
           [](Drawing& d) { d.milliseconds = -1; }, [](Drawing& d) { d.milliseconds = INFINITY; },
           [](Drawing& d) { d.calls[0].pass = -2; },
           [](Drawing& d) { d.calls.resize(most_calls + 1); },
           [](Drawing& d) { d.passes.resize(most_passes + 1); }}) {
    Drawing drawing = a_drawing();
    change(drawing);
    EXPECT_THROW(drawing_from(body_of(message_of(0, drawing)), a_job()), Garbled);
  }
  EXPECT_THROW(drawing_from(body_of(message_of(2, a_drawing())), a_job()), Garbled);
  for (const auto& ask_less : std::initializer_list<std::function<void(Job&)>>{
           [](Job& job) { job.passes = {}; }, [](Job& job) { job.passes.stencil = false; },
           [](Job& job) { job.frame.color = false; }, [](Job& job) { job.frame.depth = false; },
           [](Job& job) { job.calls = false; }}) {
    Job job = a_job();
    ask_less(job);
    EXPECT_THROW(drawing_from(body_of(message_of(0, a_drawing())), job), Garbled);
  }
}

TEST(Wire, texts_bring_no_orders_for_a_terminal) {
  Drawing drawing = a_drawing();
  drawing.error = std::string("\x1b[2Jcleared\0", 12);
  EXPECT_EQ(drawing_from(body_of(message_of(0, drawing)), a_job()).drawing.error, "?[2Jcleared?");
}

TEST(Wire, another_version_or_kind_is_no_message) {
  Bytes message = done_message();
  const auto head = [&] { return header_from(std::span(message).first<header_size>()); };
  EXPECT_EQ(head().kind, Kind::done);
  EXPECT_EQ(head().length, 0u);
  message[4] = 9;
  EXPECT_THROW(head(), Garbled);
  message = done_message();
  ++message[3];
  EXPECT_THROW(head(), Garbled);
}

}  // namespace
}  // namespace shadowlab::lab::wire
