# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05

do for [kind in 'png pdf'] {
  eval canvas(kind, 'figure3', 2)
  size = kind eq 'png' ? 0.2 : 0.06
  set multiplot layout 2,1

  eval panel('a')
  set ylabel '{/:Italic v}_1'
  set yrange [-0.4:0]; set ytics 0.05
  plot data.'/figure3a.csv' using 'omega':'v1' with points lt 1 pt 7 ps size lw 0.3

  eval panel('b')
  set ylabel '{/:Italic v}_2'
  set yrange [0:0.4]
  plot data.'/figure3b.csv' using 'omega':'v2' with points lt 2 pt 7 ps size lw 0.3

  unset multiplot
  unset output
}
