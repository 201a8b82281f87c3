# Figure 4: hold force on mass 1 while it sticks, before (a) and after (b) the multi-sliding
# bifurcation. Dotted: the force between the phases, as if mass 1 were held. Insets: where the force of
# (a) turns back, and the force at the bifurcation; where the force of (b) pulls mass 1 off its stop.
load 'figures/style.gp'
set xlabel time.'{/*0.85 ;  0: a period of the steady state begins (inferred)}'
set ylabel '{/:Italic F}_2 {/*0.85 (force on mass 1)}'
set tmargin 2
eval axes('figure4')

table(letter) = data.'/figure4'.letter.'.csv'
array phases[2]
do for [n = 1:2] {
  stats [*:*] [*:*] table('ab'[n:n]) using 'phase' nooutput
  phases[n] = int(STATS_max)
}

eval scenes('figure4')
eval page('figure4', 2, 1)
do for [n = 1:2] {
  letter = 'ab'[n:n]
  eval panel(letter)
  eval heading(parameters(n, ''))
  if (n == 2) {
    set label 2 'lifts off' at 14.05, 0.01 right
    set label 3 'chatters' at 14.4, 0.01 center
    set label 6 'dotted: as if mass 1 were held' at 15.95, -0.02 center font ',19'
    set label 5 'sticks again' at 14.75, 0.01 left
  }
  plot 0 lt 3, for [phase = 1:phases[n]] table(letter) \
    using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1, \
    for [phase = 1:phases[n] - 1] table('b_free') \
    using 't':(n == 2 && column('phase') == phase ? column('F2') : NaN) with lines lt 2 lw 2 dashtype (2, 3)
}

stats [13.5:14.8] [*:*] table('a') using 't':'F2' nooutput name 'turn'
eval inset(1, 2, 0.27, 0.55)
set lmargin at screen 0.5; set rmargin at screen 0.93
set ylabel '10^5 {/:Italic F}_2' font ',20' offset 1, 0
set xrange [14.12:14.23]; set xtics 0.02
set yrange [-16:8]; set ytics 5
set label 1 sprintf('at Ω = %.10f: touches zero', omega[3]) at turn_pos_max_y, 4 center font ',20'
set label 2 '(a): turns back at '.number('%.1f', 1e5 * turn_max_y) at turn_pos_max_y, -10 center font ',20'
plot 0 lt 3, for [letter in 'a _at'] table(letter) using 't':(1e5 * column('F2')) with lines lt (letter eq 'a' ? 1 : 5)

eval inset(2, 2, 0.27, 0.55)
set ylabel '10^3 {/:Italic F}_2' font ',20' offset 1, 0
set xrange [14:14.36]; set xtics 0.1
set yrange [-1:1]; set ytics 0.5
set label 1 'pulls mass 1 off its stop' at 14.18, 0.17 center font ',20'
plot 0 lt 3, table('b') using 't':(column('phase') == 1 ? 1e3 * column('F2') : NaN) with lines lt 1, \
  table('b_free') using 't':(column('phase') == 1 ? 1e3 * column('F2') : NaN) with lines lt 2 lw 2 dashtype (2, 3)
