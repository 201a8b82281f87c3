#include <fmt/format.h>

#include "options.hpp"

namespace vibro_impact::runner {

namespace {

constexpr const char *notes =
    R"(All quantities are non-dimensional. Masses are counted from 1; the link of mass i joins
it to mass i - 1, and that of mass 1 to the ground. A single value stands for all masses; a list
has one value per mass, separated by commas. The defaults are those of Wagg (2006), Figure 2; its
omega is inferred, not printed. An existing output file is replaced. Tables are CSV.

Example of a run:
  vibro-impact run --from 700 --events events.csv --samples samples.csv --plot run.png
Events are impact, stick or release; contact_mode lists the sticking masses after the event (-, 1,
2, 1+2), phase is the time within the forcing period, and impulse is m |v_before - v_after|.
A sample at the time of an event has the velocity before it, and one at the start of the run that
after it.
A Poincare section, with one point in each forcing period (P):
  vibro-impact run --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --omega 0.823 --from 200P \
    --until 9999P --every 1P --velocities --samples section.csv --portrait section.png
A base that moves by a cos(Omega t) forces each mass by m a Omega^2 cos(Omega t), in coordinates
relative to the base. A ball on a table that moves by 1.2 cos(t):
  vibro-impact run --masses 1 --stiffness 0 --beta 0 --constant -1 --amplitude 1.2 --omega 1 \
    --displacement 1 --stop 1:lower:0 --until 20P --samples ball.csv --plot ball.png
The periodic orbit near the settled motion, with its multipliers; by --period 2 one that need not
be stable:
  vibro-impact orbit --omega 0.69 --period 2 --velocities --samples orbit.csv --portrait orbit.png
Its branch in both directions, to the kind of each end:
  vibro-impact orbit --omega 0.6 --vary omega=0.5:0.7:101 --table branch.csv

A table, a bifurcation diagram, and hysteresis of an oscillator with one mass:
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
The points are those of nested loops, the first range outermost. They are computed on
OMP_NUM_THREADS threads, or, where the program was built with MPI, by
`mpirun -n 4 vibro-impact sweep ...` on as many processes of one thread each. The tables do
not depend on their number.
The rows are kept in FILE.partial until all are there, where FILE is the first table that is
asked for. A point that is refused, as for a start beyond a stop, or given up has empty cells in
--table and no rows in the others. The program says why, and fails only if all points have none.

A job of a cluster with Slurm; submitted again after it was ended, it goes on:
  #!/bin/sh
  #SBATCH --ntasks=64
  #SBATCH --time=04:00:00
  cd "$HOME/atlas" || exit
  test -e atlas.csv ||
    mpirun vibro-impact sweep --resume --table atlas.csv --impacts impacts.csv \
      --vary omega=0.25:0.7:1001 --vary restitution=0.5:0.9:1001

Columns of --table behind the parameters, for a chain of one mass:
{}
Exit status: 0 done, 1 the run was given up or a file could not be written, 2 bad input.)";

}  // namespace

std::string footer() {
  std::string columns;
  RecordOptions all;
  all.lyapunov = all.pairs = true;
  for (const Column &column : record_columns(1, all))
    columns += fmt::format("  {:<14} {}\n", column.name, column.meaning);
  return fmt::format(notes, columns);
}

}  // namespace vibro_impact::runner
