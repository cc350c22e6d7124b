// What each pass of a frame did: its state, one pixel's history, and the buffers after one of them.
//
// It looks between a recipe's calls and at its draws, and reads alone; so a frame that is looked at
// has the pixels of one that is not.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gl/attachments.h"
#include "gl/graphics.h"
#include "gl/state_snapshot.h"
#include "recipe/recipe.h"

namespace shadowlab::live {

/// A pass by its name and which of that name it is, counting from 0: so that it is found again in
/// another version of the recipe.
struct PassName {
  std::string name;
  int occurrence = 0;
  bool operator==(const PassName&) const = default;
};

struct PassReport {
  PassName name;
  double milliseconds = 0;
  gl::Work work;
  /// At its last draw, or at its end where it drew nothing; of the pass whose buffers are kept and
  /// of the one before it.
  std::optional<gl::StateSnapshot> state;
  std::optional<gl::MainFrame::Pixel> pixel;
};

/// Which of a pass's buffers is looked at: the main frame's, or an attachment of another
/// framebuffer by its place among Buffers::attachments.
struct LookedAt {
  enum class Buffer { color, depth, stencil, attachment };
  Buffer buffer = Buffer::color;
  std::size_t attachment = 0;
  bool operator==(const LookedAt&) const = default;
};

/// The main frame's buffers, and those of other framebuffers that a pass drew to. Of what is in
/// them the one that is looked at is kept, and the others are empty: reading takes time.
struct Buffers {
  image::Image color;
  image::FloatImage depth;
  std::vector<std::uint8_t> stencil;
  std::vector<gl::AttachmentContents> attachments;
};

class Inspector : private gl::DrawObserver {
 public:
  struct Wanted {
    std::optional<PassName> pass;     ///< whose buffer is kept; the frame's end unless given
    std::optional<LookedAt> buffer;   ///< which; none unless given
    std::optional<glm::ivec2> pixel;  ///< from the left and the top, inside the picture
  };

  explicit Inspector(gl::Graphics& graphics) : graphics_(graphics) {}
  ~Inspector() override { stop(); }
  Inspector(const Inspector&) = delete;
  Inspector& operator=(const Inspector&) = delete;

  /// Looks at the frames of `recipe` from now on; called for each version.
  void attach(recipe::Recipe& recipe);

  /// The next frame is looked at for this.
  void begin(Wanted wanted);
  /// The frame is over, and is the one that is shown.
  void finish(const recipe::Recipe& recipe);
  /// It is over, and failed: what was seen before stands.
  void stop();

  /// Of the last frame that was finished.
  const std::vector<PassReport>& passes() const { return passes_; }
  /// Whether the wanted pass was in another place than in the frame before, and its state was not
  /// seen: it will be in the next.
  bool missed_state() const;
  /// The pixel before the first pass: as it was when the frame began.
  const std::optional<gl::MainFrame::Pixel>& pixel_before() const { return before_; }
  const Buffers& buffers() const { return buffers_; }
  /// The index of the pass that the buffers are of; nothing for the frame's end.
  std::optional<std::size_t> kept_pass() const { return kept_; }

 private:
  void before_draw(const std::function<void()>& draw) override;
  bool wants_state() const;
  void pass_ended(const recipe::Recipe& recipe, std::size_t index);
  void keep_buffers();

  gl::Graphics& graphics_;
  Wanted wanted_;
  bool looking_ = false;
  std::optional<std::size_t> expected_;  ///< where the wanted pass was in the frame before
  // Of the frame under way.
  std::vector<PassReport> seen_;
  std::optional<gl::MainFrame::Pixel> seen_before_;
  std::optional<gl::StateSnapshot> drawn_;  ///< at the last draw of the pass under way
  std::vector<GLuint> framebuffers_;        ///< that its draws went to, beside the main frame
  std::optional<std::size_t> seen_kept_;
  Buffers seen_buffers_;
  // Of the last one that was finished.
  std::vector<PassReport> passes_;
  std::optional<gl::MainFrame::Pixel> before_;
  std::optional<std::size_t> kept_;
  Buffers buffers_;
};

/// The names of a frame's passes, each with its occurrence.
std::vector<PassName> names_of(std::span<const recipe::PassTime> passes);

}  // namespace shadowlab::live
