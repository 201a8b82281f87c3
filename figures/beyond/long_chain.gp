# Ten masses, stops on three of them, from rest: impact velocities against the forcing frequency
# (a); in the plane of frequency and restitution the period (b) and how many masses stick (c).
load 'figures/style.gp'
load 'figures/beyond/classes.gp'

map = data.'/long_chain_map.csv'
diagram = data.'/long_chain.csv'
array meaning[12] = ['period 1', '2', '3', '4', '5 to 8', 'none, λ ≤ 0 or uncertain', 'none, λ > 0', \
  'no mass sticks', 'one', 'two in turn', 'three in turn', 'some at once']
of_sticks(a, b, c, dual) = dual > 0 ? 5 : 1 + (a > 0) + (b > 0) + (c > 0)
of_mass(k) = column('mass') == k ? column('v') : NaN

eval page('long_chain', 3, 1)
size = 0.3
set xlabel 'Ω'
set xrange [0.05:0.8]; set xtics 0.05
eval panel('a')
set ylabel 'impact velocity'
set key at graph 0.46, graph 0.12 opaque maxrows 1 samplen 1
plot diagram using 'omega':(of_mass(1)) with points lt 1 pt 7 ps size notitle, \
  '' using 'omega':(of_mass(5)) with points lt 2 pt 7 ps size notitle, \
  '' using 'omega':(of_mass(10)) with points pt 7 ps 2 * size lc rgb '#e69f00' notitle, \
  NaN with points lt 1 pt 7 ps 1 title 'mass 1', NaN with points lt 2 pt 7 ps 1 title 'mass 5', \
  NaN with points pt 7 ps 1 lc rgb '#e69f00' title 'mass 10'
set ylabel '{/:Italic r}'
set autoscale xfix; set autoscale yfix
do for [part = 0:1] {
  set tmargin part == 0 ? 4.4 : 3.2
  set key above left samplen 1 width 1 maxrows (part == 0 ? 3 : 1) font ',18'
  eval panel('bc'[part + 1:part + 1])
  plot map using 'omega':'restitution':(part == 0 ? of_period(column('period'), column('lyapunov')) : 7 + of_sticks(column('sticks1'), column('sticks5'), column('sticks10'), column('dual_sticking'))) with image notitle, \
    for [c = part == 0 ? 1 : 8 : part == 0 ? 7 : 12] NaN with points pt 5 ps 2.4 lc rgb colour[c] title meaning[c]
}
