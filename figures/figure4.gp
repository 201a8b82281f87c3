# Figure 4: hold force on mass 1 while it sticks, before (a) and after (b) the multi-sliding
# bifurcation.
load 'figures/style.gp'
set xlabel 'Time within a settled forcing period'
set ylabel '{/:Italic F}_2'
set xrange [12:17.5]; set xtics 0.5
set yrange [-0.2:0.02]; set ytics 0.02

eval page('figure4', 2, 1)
do for [letter in 'a b'] {
  eval panel(letter)
  if (letter eq 'b') { set label 2 'chatter' at 14.4, -0.014 center }
  plot 0 lt 3, for [phase = 1:2] data.'/figure4'.letter.'.csv' \
    using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1
}
unset label 2
