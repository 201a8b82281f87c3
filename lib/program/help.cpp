#include <fmt/format.h>

#include "options.hpp"

namespace vibro_impact::runner {

// Quantities are in any consistent units, because no equation has a constant with a unit.
std::string footer_of_program() {
  return R"(Any consistent units will do: metres, kilograms and seconds, or none, as in the defaults, which
are those of Wagg (2006), Figure 2. Its omega is inferred, not printed. Masses are counted from 1;
the link of mass i joins it to mass i - 1, and that of mass 1 to the ground. A single value stands
for all masses; a list has one value per mass, separated by commas. An existing output file is
replaced. Tables are CSV. `vibro-impact run --help` has the options and examples of a run, and so
have the other commands.

Exit status: 0 done, 1 the run was given up or a file could not be written, 2 bad input.)";
}

std::string footer_of_run() {
  return R"(Example of a run:
  vibro-impact run --from 700 --events events.csv --samples samples.csv --plot run.png
Events are impact, stick or release; contact_mode lists the sticking masses after the event (-, 1,
2, 1+2), phase is the time within the forcing period, and impulse is m |v_before - v_after|. At a
stick, impulse is that of the infinitely many impacts of its chatter that have no row: also of those
before --from. If a run ends within a chatter, its slower impacts are in --summary alone.
A sample at the time of an event has the velocity before it, and one at the start of the run that
after it.
A Poincare section, with one point in each forcing period (P):
  vibro-impact run --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --omega 0.823 --from 200P \
    --until 9999P --every 1P --velocities --samples section.csv --portrait section.png
A base that moves by X cos(Omega t) forces each mass by m X Omega^2 cos(Omega t), in coordinates
relative to the base. A ball on a table that moves by 1.2 cos(t):
  vibro-impact run --masses 1 --stiffness 0 --beta 0 --constant -1 --amplitude 1.2 --omega 1 \
    --displacement 1 --stop 1:lower:0 --until 20P --samples ball.csv --plot ball.png)";
}

std::string footer_of_orbit() {
  return R"(The periodic orbit near the settled motion, with its multipliers; by --period 2 one that need not
be stable:
  vibro-impact orbit --omega 0.692 --period 2 --velocities --samples orbit.csv --portrait orbit.png
Its branch in both directions, to the kind of each end, and the branch over a diagram:
  vibro-impact sweep --vary omega=0.55:0.65:51 --impacts diagram.csv
  vibro-impact orbit --omega 0.6 --vary omega=0.5:0.7:101 --table branch.csv --plot branch.png \
    --diagram diagram.csv)";
}

std::string footer_of_sweep() {
  std::string columns;
  RecordOptions all;
  all.lyapunov = all.response = all.pairs = true;
  for (const Column &column : record_columns(1, all))
    columns += fmt::format("  {:<14} {}\n", column.name, column.meaning);
  return R"(A table, a bifurcation diagram, and hysteresis of an oscillator with one mass:
  vibro-impact sweep --vary omega=0.25:0.7:10 --vary stop1=-0.4:-0.2:3 --table atlas.csv
  vibro-impact sweep --vary omega=0.25:0.7:91 --impacts impacts.csv --plot impacts.png
  vibro-impact sweep --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --vary omega=1.05:1.45:81 \
    --back --impacts branches.csv --plot branches.png
Basins of attraction, by the start of the motion, with mirror orbits distinguished, and the
displacement at one phase:
  vibro-impact sweep --masses 1 --amplitude 2 --omega 2 --restitution 0.5 --stop 1:lower:-0.5 \
    --stop 1:upper:0.5 --vary displacement1=-0.6:0.6:25 --vary velocity1=-2:2:21 --attractor \
    --column attractor --table basins.csv --plot basins.png
  vibro-impact sweep --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --vary omega=0.7:1.2:101 \
    --section states.csv --plot states.png
A resonance curve:
  vibro-impact sweep --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --vary omega=0.5:1.5:101 \
    --response --column rms1 --table response.csv --plot response.png
The points are those of nested loops, the first range outermost. They are computed on
OMP_NUM_THREADS threads, and the tables do not depend on their number. A point that is refused, as
for a start beyond a stop, or given up has empty cells in --table and no rows in the others. The
program says why, and a sweep without --part fails if all points have none.

On several machines with a common folder, GNU parallel computes the parts of a sweep. Given once
more, it computes those that are missing. Slurm computes them as an array:
  parallel --sshlogin one,two --workdir . --joblog jobs --resume-failed OMP_NUM_THREADS=1 \
    vibro-impact sweep --vary omega=0.25:0.7:1001 --vary restitution=0.5:0.9:1001 \
    --part {}/64 --table part-{}.csv ::: $(seq 64)
  sbatch --array=1-64 --wrap 'OMP_NUM_THREADS=1 vibro-impact sweep --vary omega=0.25:0.7:1001 \
    --vary restitution=0.5:0.9:1001 --part $SLURM_ARRAY_TASK_ID/64 \
    --table part-$SLURM_ARRAY_TASK_ID.csv'
The table is that of all parts in their order:
  cat $(seq -f part-%g.csv 64) >atlas.csv

Columns of --table behind the parameters, for a chain of one mass:
)" + columns;
}

}  // namespace vibro_impact::runner
