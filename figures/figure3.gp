# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency, from rest.
# Beside what the paper shows: mass 1 followed upwards and downwards (c), impacts per period (d) and
# the greatest Lyapunov exponent (e), from rest; border orbits and multi-sliding as vertical lines.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05

orbits = data.'/figure3_orbits.csv'
points = 'reference/bifurcation_points.csv'
at_border(mass) = strcol('symbol')[1:13] eq 'border_mass_'.mass ? column('value') : NaN
at_sliding(mass) = strcol('symbol') eq 'multi_sliding_mass_'.mass ? column('value') : NaN
when(condition, value) = condition ? value : NaN

do for [kind in 'png pdf'] {
  eval canvas(kind, 'figure3', 5)
  size = kind eq 'png' ? 0.2 : 0.06
  dot = kind eq 'png' ? 0.45 : 0.16
  set multiplot layout 5,1

  unset key
  eval panel('a')
  set ylabel '{/:Italic v}_1'
  set yrange [-0.4:0]; set ytics 0.05
  plot points using (at_border(1)):(-0.4) with impulses dt solid lw 0.6 lc rgb '#9a9a9a', \
    '' using (at_sliding(1)):(-0.4) with impulses dt (3, 3) lw 1.2 lc rgb '#0f5f40', \
    data.'/figure3a.csv' using 'omega':'v1' with points lt 1 pt 7 ps size lw 0.3

  eval panel('b')
  set ylabel '{/:Italic v}_2'
  set yrange [0:0.4]
  set key at graph 0.985, graph 0.22 noopaque
  plot points using (at_border(2)):(0.4) with impulses dt solid lw 0.6 lc rgb '#9a9a9a' title 'border orbit', \
    '' using (at_sliding(2)):(0.4) with impulses dt (3, 3) lw 1.2 lc rgb '#0f5f40' title 'multi-sliding', \
    data.'/figure3b.csv' using 'omega':'v2' with points lt 2 pt 7 ps size lw 0.3

  eval panel('c')
  set ylabel '{/:Italic v}_1'
  set yrange [-0.4:0]
  set key at graph 0.985, graph 0.3 opaque
  plot data.'/figure3_down.csv' using 'omega':'v1' with points pt 7 ps size * 1.6 lc rgb '#c9952c' title 'followed downwards', \
    data.'/figure3_up.csv' using 'omega':'v1' with points pt 7 ps size lc rgb '#12355b' title 'followed upwards'

  # Where the chatter is complete in every period there are infinitely many impacts.
  eval panel('d')
  set ylabel 'impacts per period'
  set yrange [-0.5:24]; set ytics 4
  set key at graph 0.985, graph 0.93 opaque
  complete(mass, height) = when(column('chatters'.mass) > 0, height)
  plot orbits using 'omega':(when(column('chatters1') == 0, column('impacts1'))) with points pt 7 ps dot lc rgb '#12355b' title 'mass 1', \
    '' using 'omega':(when(column('chatters2') == 0, column('impacts2') + 0.15)) with points pt 7 ps dot lc rgb '#c8442c' title 'mass 2', \
    '' using 'omega':(complete(1, 22.6)) with points pt 5 ps dot lc rgb '#12355b' title 'complete chatter', \
    '' using 'omega':(complete(2, 21.6)) with points pt 5 ps dot lc rgb '#c8442c'

  eval panel('e')
  set ylabel 'λ'
  set yrange [-0.2:0.06]; set ytics 0.04
  set key at graph 0.985, graph 0.3 noopaque
  plot 0 lt 3, \
    orbits using 'omega':(when(column('period') > 0, column('lyapunov'))) with points pt 7 ps dot lc rgb '#56b4e9' title 'periodic, up to 8 periods', \
    '' using 'omega':(when(column('period') == 0 && column('lyapunov') <= 0, column('lyapunov'))) with points pt 7 ps dot * 1.4 lc rgb '#808080' title 'none: slow, or a longer period', \
    '' using 'omega':(when(column('period') == 0 && column('lyapunov') > 0, column('lyapunov'))) with points pt 7 ps dot * 1.4 lc rgb '#000000' title 'none: chaotic'

  unset multiplot
  unset output
}
