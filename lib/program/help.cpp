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
A Poincare section, with one point in each forcing period (P):
  vibro-impact run --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --omega 0.823 --from 200P \
    --until 9999P --every 1P --velocities --samples section.csv --portrait section.png

A table, a bifurcation diagram, and hysteresis of an oscillator with one mass:
  vibro-impact sweep --vary omega=0.25:0.7:10 --vary stop1=-0.4:-0.2:3 --table atlas.csv
  vibro-impact sweep --vary omega=0.25:0.7:91 --impacts impacts.csv --plot impacts.png
  vibro-impact sweep --masses 1 --amplitude 0.1 --stop 1:upper:0.3 --vary omega=1.05:1.45:81 \
    --back --impacts branches.csv --plot branches.png
The points are those of nested loops, the first range outermost. They are computed on
OMP_NUM_THREADS threads, or, where the program was built with MPI, by
`mpirun -n 4 vibro-impact sweep ...` on as many processes of one thread each. The tables do
not depend on their number.
The rows are kept in FILE.partial until all are there, where FILE is the first table that is
asked for. A point that is refused or given up has empty cells in --table.

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
