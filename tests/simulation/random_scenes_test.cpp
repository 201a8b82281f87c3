// Properties that must hold in every scene, tried on random ones. Every flight ends where a witness
// takes it, passes no stop on the way, and no hold force pulls; every event is one that the events
// before it allow. The run is the same to the last bit while it is sampled, in two parts and in a
// mirror.
//
// With an argument, `random_scenes_test N [first seed [distribution]]` tries N scenes of each
// distribution, or of that one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "reference/truth/scene_reader.hpp"
#include "tests/support/contact_scenes.hpp"
#include "tests/support/events.hpp"
#include "tests/support/long_flight_scenes.hpp"
#include "tests/support/scene_properties.hpp"

namespace {

using namespace vibro_impact;
using namespace vibro_impact::testing;

#ifdef FEWER_SCENES  // with sanitizers, which are far slower
constexpr unsigned scenes = 60;
#else
constexpr unsigned scenes = 300;
#endif

struct Distribution {
  const char *name;
  Trial (*draw)(unsigned seed);
  long long most_steps;
  double share;    // of the motion, that a flight may be off from a witness
  unsigned tried;  // scenes in every run of the tests
  std::string (*own)(const Run &) = nullptr;  // a property of these scenes alone
};

void PrintTo(const Distribution &distribution, std::ostream *out) {
  *out << distribution.name;
}

// Ordinary, extreme, graded and degenerate chains, the same with all forces but for the graded
// ones, and scenes far from the paper's in one respect each. On links up to 1e12, the state from
// which a flight starts has rounded displacements, whose elastic energy is 1e-8 of the motion.
constexpr Distribution distributions[] = {
    {"ordinary", run_of<random_scene, 1'000'000'000>, 50000, 2e-13, scenes},
    {"extreme", run_of<extreme_scene, 3000>, 10000, 1e-11, scenes},
    {"graded", run_of<graded_scene, 1000>, 2000, 1e-12, scenes},
    {"degenerate", run_of<degenerate_scene, 200>, 4000, 2e-13, scenes},
    {"ordinary forced", run_of<with_all_forces<random_scene>, 1'000'000'000>, 50000, 2e-13,
     scenes / 3},
    {"extreme forced", run_of<with_all_forces<extreme_scene>, 3000>, 10000, 1e-11, scenes / 3},
    {"degenerate forced", run_of<with_all_forces<degenerate_scene>, 200>, 4000, 2e-13, scenes / 3},
    {"stiff release", stiff_release, 20000, 1e-8, scenes / 6},
    {"long chain", long_chain_at_rest, 40000, 2e-13, scenes / 6, broken_by_many_calls},
    {"decayed chatter", decayed_chatter, 2000, 2e-13, scenes / 6},
    {"falling", falling_masses, 20000, 2e-13, scenes / 6},
    {"at equilibrium", chain_at_equilibrium, 20000, 2e-13, scenes / 6},
    {"any links", any_links, 400000, 1e-8, scenes / 6},
    {"any frequency", any_frequency, 20000, 2e-13, scenes / 6},
    {"hit after a release", hit_after_a_release, 2000, 2e-13, scenes / 20, broken_by_digits},
    {"slow forcing", slow_forcing, 20000, 2e-13, scenes / 6},
    {"narrow slot", narrow_slot, 20000, 2e-13, scenes / 6},
    {"free chain", free_chain, 20000, 2e-13, scenes / 6},
    {"rigid pair", rigid_pair, 20000, 2e-13, scenes / 6},
    {"short hop", short_hop, 20000, 1e-8, scenes / 6},
    {"elastic", elastic_chain, 300000, 2e-13, scenes / 6, broken_by_energy},
    {"touching forces", touching_forces, 20000, 2e-13, scenes / 6, broken_by_touches},
    {"dipping forces", dipping_forces, 40000, 2e-13, scenes / 6, broken_by_dips},
    {"touching below zero", touching_below_zero, 20000, 2e-13, scenes / 6, broken_by_a_touch},
    {"weak links", weak_links, 20000, 2e-13, scenes / 10, broken_by_series},
    {"fast modes", fast_modes, 20000, 2e-13, scenes, broken_by_a_release}};

Distribution distribution_named(const std::string &name) {
  for (const Distribution &distribution : distributions)
    if (distribution.name == name) return distribution;
  throw std::invalid_argument(name + ": is no distribution of scenes");
}

// The row of known_scenes.csv for this scene.
std::string row_of(const Distribution &distribution, unsigned seed, const Trial &trial) {
  const auto &[scene, until, units, completes] = trial;
  std::string row = fmt::format("{},{},{},{},{},{},{:d}", distribution.name, seed, until,
                                units.length, units.time, units.force, completes);
  for (const auto &[name, words] : fields_in_words(scene)) row += ",\"" + words + '"';
  return row + ',';
}

// How many of the scenes break a property.
int try_scenes(const Distribution &distribution, unsigned first, unsigned count) {
  int failed = 0, given_up = 0;
  for (unsigned seed = first; seed < first + count; ++seed) {
    const Trial trial = distribution.draw(seed);
    const Verdict verdict =
        try_scene(trial, distribution.most_steps, distribution.share, seed, distribution.own);
    given_up += verdict.gave_up;
    if (verdict.broken.empty()) continue;
    ++failed;
    fmt::print("{} seed {}: {}\n{}\n", distribution.name, seed, verdict.broken,
               row_of(distribution, seed, trial));
    std::fflush(stdout);
  }
  fmt::print("{} {} scenes, {} broke a property, {} ended at the limit of steps\n", count,
             distribution.name, failed, given_up);
  return failed;
}

class EveryProperty : public ::testing::TestWithParam<Distribution> {};

TEST_P(EveryProperty, IsKept) {
  EXPECT_EQ(try_scenes(GetParam(), 1, GetParam().tried), 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryProperty, ::testing::ValuesIn(distributions),
                         [](const auto &distribution) {
                           std::string name = distribution.param.name;
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

// If several masses chatter at once, runs that may take limits stick and release at the times of
// runs that resolve every impact, to the tolerance of a limit. Measured over 4,000 scenes: 4.7e-15.
TEST(ChatteringScenes, HoldTheirMassesWhenAllImpactsDo) {
  for (unsigned seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    expect_holds_of_all_impacts(chattering_scene(seed), 15.0, 1e-13);
  }
}

// Scenes in which a longer search has found faults of the engine, and some that were thought of,
// with a note. A search prints the rows.
TEST(RandomScenes, KeepEveryPropertyWhereALongSearchFailed) {
  const std::string table = SOURCE_DIR "/tests/simulation/known_scenes.csv";
  const truth::Rows rows = truth::read_rows(table);
  for (const truth::Row &row : rows) {
    const Trial trial{truth::scene_in(row),
                      row.number("until"),
                      {row.number("length"), row.number("time"), row.number("force")},
                      row.number("completes") != 0.0};
    const Distribution distribution = distribution_named(row.cell("distribution"));
    EXPECT_EQ(try_scene(trial, distribution.most_steps, distribution.share,
                        static_cast<unsigned>(row.number("seed")), distribution.own)
                  .broken,
              "")
        << row.place();
  }
  EXPECT_GE(rows.size(), 92u);
}

// In units of length and time up to 1e10 times ours or 1e-10, and of mass up to 1e8 or 1e-8, every
// number of the engine is scaled by a power of two (of the mass the root is taken), so that the run
// is the same to the last bit. A tolerance that is a length, a time or a force would show. Every
// fourth unit of length, and every fourth one of mass, has a square that is no double. Three
// quarters of those lengths are next to the largest double. In the two largest ones, a motion may
// leave the range of double precision, and the run is then given up.
TEST(RandomScenes, AreTheSameInOtherUnits) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    Draw draw{std::mt19937(seed)};
    const auto power_of_two = [&draw](int limit, int multiple) {
      const int span = static_cast<int>(draw.below(static_cast<unsigned>(2 * limit + 1)));
      return std::ldexp(1.0, multiple * (span - limit));
    };
    double length = power_of_two(33, 1), time = power_of_two(33, 1), mass = power_of_two(13, 2);
    if (seed % 4 == 0) mass = draw.one_of({0x1p-540, 0x1p540});
    if (seed % 4 == 1) {
      mass = time = 1.0;
      length = draw.one_of({0x1p-540, 0x1p1005, 0x1p1017, 0x1p1021});
    }
    const double stiffness = mass / (time * time);
    const Scene scene = with_all_forces<random_scene>(seed);
    const Scene other = in_units(scene, mass, stiffness, length, time);
    const double until = run_length(scene, 1000.0);
    EventRecorder ours, theirs;
    const Outcome our_end = simulate(scene, until, ours),
                  their_end = simulate(other, until * time, theirs);
    if (length > 0x1p1005 && their_end.ending == Ending::given_up) continue;
    EXPECT_EQ(our_end.ending, their_end.ending) << seed;
    for (std::size_t i = 0; i < scene.mass.size(); ++i)
      EXPECT_EQ(our_end.state.velocity[i], their_end.state.velocity[i] / (length / time)) << seed;
    for (Event &event : theirs.events) {
      event.time /= time;
      event.instant.phase /= time;
      event.velocity_before /= length / time;
      event.velocity_after /= length / time;
      event.taken.impulse /= mass * (length / time);
      event.taken.energy /= mass * (length / time) * (length / time);
    }
    if (seed % 4 == 1)  // the energy of an impact is no double, either
      for (std::vector<Event> *events : {&ours.events, &theirs.events})
        for (Event &event : *events) event.taken.energy = 0.0;
    EXPECT_TRUE(ours.events == theirs.events) << seed;
  }
}

// A free mass that a force drives onto a stop. The product of its mass and its length leaves the
// range of double precision, and no number of the motion does.
TEST(FreeMass, IsTheSameInUnitsWhoseProductIsNoDouble) {
  const Scene scene{.mass = {1.0},
                    .stiffness = {0.0},
                    .amplitude = {0.7},
                    .omega = 1.0,
                    .restitution = 0.7,
                    .stops = {{1, Side::upper, 0.1}},
                    .velocity = {0.5}};
  const Outcome ours = simulate(scene, 5.0);
  for (const double sign : {-1.0, 1.0}) {
    const double mass = std::exp2(sign * 540.0), time = std::exp2(sign * 200.0), length = mass;
    const Scene other = in_units(scene, mass, mass / (time * time), length, time);
    const Outcome theirs = simulate(other, 5.0 * time);
    EXPECT_EQ(theirs.ending, Ending::reached);
    EXPECT_EQ(theirs.counters.impacts, ours.counters.impacts);
    EXPECT_EQ(theirs.state.displacement[0] / length, ours.state.displacement[0]);
  }
}

// The witness is sharp: a first link stiffer by a billionth does not pass, but where it hardly
// moves.
TEST(Witness, NoticesALinkOffByABillionth) {
  int noticed = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Scene scene = random_scene(seed);
    Scene other = scene;
    other.stiffness[0] *= 1.0 + 1e-9;
    const double until = run_length(scene, 100.0);
    Witness witness = witness_of(scene, until);
    witness.close(simulate(other, until, {.limit_below_speed = 0.0}, witness).state);
    noticed += witness.apart() > 1e-11 * witness.size();
  }
  EXPECT_GE(noticed, 15);
}

}  // namespace

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  if (argc == 1) return RUN_ALL_TESTS();
  const auto count = static_cast<unsigned>(std::atoi(argv[1]));
  const auto first = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1u;
  int failed = 0;
  for (const Distribution &distribution : distributions)
    if (argc < 4 || std::string(argv[3]) == distribution.name)
      failed += try_scenes(distribution, first, count);
  return failed == 0 ? 0 : 1;
}
