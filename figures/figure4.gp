# Figure 4: hold force on mass 1 while it sticks, before (a) and after (b) the multi-sliding
# bifurcation.
load 'figures/style.gp'
set xlabel 'Time within a settled forcing period'
set ylabel '{/:Italic F}_2'
set xrange [12:17.5]; set xtics 0.5
set yrange [-0.2:0.02]; set ytics 0.02

table(letter) = data.'/figure4'.letter.'.csv'
array phases[2]
do for [n = 1:2] {
  stats [*:*] [*:*] table('ab'[n:n]) using 'phase' nooutput
  phases[n] = int(STATS_max)
}

eval page('figure4', 2, 1)
do for [n = 1:2] {
  letter = 'ab'[n:n]
  eval panel(letter)
  if (letter eq 'b') { set label 2 'chatter' at 14.4, -0.014 center }
  plot 0 lt 3, for [phase = 1:phases[n]] table(letter) \
    using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1
}
