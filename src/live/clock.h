// The time that recipes are given: it runs, slowly or not at all.
#pragma once

namespace shadowlab::live {

class Clock {
 public:
  double time() const { return time_; }  ///< seconds
  bool paused() const { return paused_; }
  double speed() const { return speed_; }

  void advance(double seconds) {
    if (!paused_) time_ += seconds * speed_;
  }
  void toggle_pause() { paused_ = !paused_; }
  /// One frame of a film at 60 a second, while it is paused.
  void step(int frames) { time_ = time_ + frames / 60.0 < 0 ? 0 : time_ + frames / 60.0; }
  void toggle_slow_motion() { speed_ = speed_ == 1 ? 0.1 : 1; }
  void restart() { time_ = 0; }

 private:
  double time_ = 0;
  double speed_ = 1;
  bool paused_ = false;
};

}  // namespace shadowlab::live
