// What the compiled run sees of a recorder (record.hpp): function pointers.
#pragma once

#include "record.hpp"

namespace vibro_impact {

// A recorder as a run sees it; null where it has no such member. Refers to the recorder.
struct RecorderRef {
  void *recorder = nullptr;
  void (*event)(void *, const Event &, const Moment &) = nullptr;
  double (*next_time)(const void *) = nullptr;
  void (*sample)(void *, const Moment &) = nullptr;
};

template <class Recorder>
RecorderRef recorder_ref(Recorder &recorder) {
  constexpr bool takes_events = requires(Recorder & r, const Event &e, const Moment &m) {
    r.event(e, m);
  };
  constexpr bool takes_samples = requires(Recorder & r, const Moment &m) {
    double{r.next_time()}, r.sample(m);
  };
  static_assert(takes_events || takes_samples, "a recorder takes events, samples or both");
  RecorderRef ref{&recorder};
  if constexpr (takes_events)
    ref.event = [](void *r, const Event &event, const Moment &moment) {
      static_cast<Recorder *>(r)->event(event, moment);
    };
  if constexpr (takes_samples) {
    ref.next_time = [](const void *r) { return static_cast<const Recorder *>(r)->next_time(); };
    ref.sample = [](void *r, const Moment &moment) { static_cast<Recorder *>(r)->sample(moment); };
  }
  return ref;
}

}  // namespace vibro_impact
