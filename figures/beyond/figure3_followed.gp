# Behind Figure 3: mass 1 followed upwards (a) and downwards (b), impacts per period (c) and the
# greatest Lyapunov exponent (d), from rest.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05

orbits = data.'/figure3_orbits.csv'
when(condition, value) = condition ? value : NaN

eval page('figure3_followed', 4, 1)
size = 0.2
dot = 0.45
set key opaque

eval panel('a')
set ylabel '{/:Italic v}_1'
set yrange [-0.4:0]; set ytics 0.1
set key at graph 0.985, graph 0.16
plot data.'/figure3_up.csv' using 'omega':'v1' with points pt 7 ps size lc rgb '#12355b', \
  NaN with points pt 7 ps 0.8 lc rgb '#12355b' title 'followed upwards'

eval panel('b')
plot data.'/figure3_down.csv' using 'omega':'v1' with points pt 7 ps size lc rgb '#b0762c', \
  NaN with points pt 7 ps 0.8 lc rgb '#b0762c' title 'followed downwards'

# Where the chatter is complete in every period there are infinitely many impacts: a bar above the
# axis of counts, which ends at 20: next to a border orbit there are more.
eval panel('c')
set ylabel 'impacts per period'
set yrange [0:27]; set ytics 0, 4, 20
set key at graph 0.985, graph 0.72
set label 2 'complete chatter, infinitely many:' at 0.62, 25.6 right
set label 3 'mass 1' at 0.62, 23.9 right textcolor rgb '#12355b'
set label 4 'mass 2' at 0.62, 22.2 right textcolor rgb '#c8442c'
set label 5 '{/*0.8 more than 20: not drawn}' at 0.49, 19.8 left
counted(mass) = when(column('chatters'.mass) == 0 && column('impacts'.mass) <= 20, column('impacts'.mass))
complete(mass, height) = when(column('chatters'.mass) > 0, height)
plot 21 with lines lt 3, \
  orbits using 'omega':(counted(1)) with points pt 7 ps dot lc rgb '#12355b' title 'mass 1', \
  '' using 'omega':(counted(2)) with points pt 6 ps dot * 1.6 lw 0.5 lc rgb '#c8442c' title 'mass 2', \
  '' using 'omega':(complete(1, 23.9)) with points pt 5 ps dot lc rgb '#12355b', \
  '' using 'omega':(complete(2, 22.2)) with points pt 5 ps dot lc rgb '#c8442c'
unset label 2; unset label 3; unset label 4; unset label 5

eval panel('d')
set ylabel 'λ'
set yrange [-0.2:0.06]; set ytics 0.04
set key noopaque at 0.45, -0.13
plot 0 lt 3, \
  orbits using 'omega':(when(column('period') > 0, column('lyapunov'))) with points pt 7 ps dot lc rgb '#56b4e9' title 'periodic, up to 8 periods', \
  '' using 'omega':(when(column('period') == 0 && column('lyapunov') <= 0, column('lyapunov'))) with points pt 7 ps dot * 1.4 lc rgb '#808080' title 'none: slow, or a longer period', \
  '' using 'omega':(when(column('period') == 0 && column('lyapunov') > 0, column('lyapunov'))) with points pt 7 ps dot * 1.4 lc rgb '#000000' title 'none: chaotic'
