// A recorder is any value of a class with some of these members, and at least one of the first
// three.
//
// void event(const Event &, const Moment &)
// A run calls this member at every event.
//
// double next_time(), void sample(const Moment &)
// A run calls `sample` at the time that `next_time` returns. Each time must be later than the one
// before. Infinity asks for no more samples.
//
// bool done()
// A run calls this member after each call of `event` or `sample` of the recorder, and ends at
// that time if it returns true. For a recorder that has neither, a run calls it after every step.
//
// void check(const Scene &)
// A run calls this member before it begins. It throws std::invalid_argument to refuse the scene.
//
// The class must not be final. A recorder is passed as a variable, not as a temporary.
//
// An exception that a member throws ends the run and reaches the caller. The state of the
// simulation is then unspecified.
#pragma once

#include <concepts>
#include <functional>
#include <type_traits>
#include <vector>

namespace vibro_impact {

struct Event;
struct Scene;
class Moment;

namespace detail {

// A name is ambiguous in a class that inherits it from R and from RecorderNames: then R has a
// member of this name in some form.
struct RecorderNames {
  int event, next_time, sample, done, check;
};
template <class R>
struct WithRecorderNames : R, RecorderNames {};

template <class R>
concept takes_events = requires(R &recorder, const Event &event, const Moment &moment) {
  recorder.event(event, moment);
};
template <class R>
concept takes_samples = requires(R &recorder, const Moment &moment) {
  { recorder.next_time() } -> std::convertible_to<double>;
  recorder.sample(moment);
};
template <class R>
concept is_asked = requires(R &recorder) {
  { recorder.done() } -> std::convertible_to<bool>;
};
template <class R>
concept checks_scenes = requires(R &recorder, const Scene &scene) {
  recorder.check(scene);
};

// True unless R has a member with one of these names and another form, which a run would never
// call.
template <class R>
concept has_no_misfit = requires {
  requires takes_events<R> || requires {
    &WithRecorderNames<R>::event;
  };
  requires takes_samples<R> || requires {
    &WithRecorderNames<R>::next_time;
    &WithRecorderNames<R>::sample;
  };
  requires is_asked<R> || requires {
    &WithRecorderNames<R>::done;
  };
  requires checks_scenes<R> || requires {
    &WithRecorderNames<R>::check;
  };
};

// The members of a recorder as a run calls them. A function is empty if the recorder has no such
// member. The recorder must outlive its functions.
struct RecorderRef {
  std::function<void(const Event &, const Moment &)> event = {};
  std::function<double()> next_time = {};
  std::function<void(const Moment &)> sample = {};
  std::function<bool()> done = {};
  std::function<void(const Scene &)> check = {};
};

}  // namespace detail

template <class R>
concept Recorder = std::is_class_v<R> && !std::is_final_v<R> && detail::has_no_misfit<R> &&
                   (detail::takes_events<R> || detail::takes_samples<R> || detail::is_asked<R>);

namespace detail {

// Refuses a class that is no recorder with the reason.
template <class R>
consteval void require_recorder() {
  constexpr bool is_open_class = std::is_class_v<R> && !std::is_final_v<R>;
  static_assert(is_open_class, "a recorder is an object of a class that is not final");
  if constexpr (is_open_class) {
    static_assert(has_no_misfit<R>,
                  "a member event, next_time, sample, done or check of this recorder has another "
                  "form than recorder.hpp says");
    static_assert(takes_events<R> || takes_samples<R> || is_asked<R>,
                  "a recorder has event, next_time and sample, or done");
  }
}

template <class R>
RecorderRef recorder_ref(R &recorder) {
  require_recorder<R>();
  RecorderRef ref;
  if constexpr (takes_events<R>)
    ref.event = [&recorder](const Event &event, const Moment &moment) {
      recorder.event(event, moment);
    };
  if constexpr (takes_samples<R>) {
    ref.next_time = [&recorder] { return static_cast<double>(recorder.next_time()); };
    ref.sample = [&recorder](const Moment &moment) { recorder.sample(moment); };
  }
  if constexpr (is_asked<R>) ref.done = [&recorder] { return static_cast<bool>(recorder.done()); };
  if constexpr (checks_scenes<R>)
    ref.check = [&recorder](const Scene &scene) { recorder.check(scene); };
  return ref;
}

}  // namespace detail

// A group of recorders that is put together while the program runs. `Simulation::advance` takes a
// group in place of recorders. The recorders must outlive the run.
class RecorderGroup {
 public:
  template <class R>
  void add(R &recorder) {
    refs_.push_back(detail::recorder_ref(recorder));
  }
  const std::vector<detail::RecorderRef> &refs() const {
    return refs_;
  }

 private:
  std::vector<detail::RecorderRef> refs_;
};

}  // namespace vibro_impact
