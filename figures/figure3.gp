# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency, from rest;
# border orbits and multi-sliding as vertical lines.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05
set ytics 0.05

bifurcations = data.'/figure3_bifurcations.csv'
of_kind(name, mass) = strcol('kind') eq name && column('mass') == mass ? column('omega') : NaN

eval page('figure3', 2, 1)
do for [mass = 1:2] {
  lowest = mass == 1 ? -0.4 : 0
  eval panel('ab'[mass:mass])
  set ylabel sprintf('{/:Italic v}_%d', mass)
  set yrange [lowest:lowest + 0.4]
  set key at graph 0.985, graph 0.2 opaque
  plot bifurcations using (of_kind('border orbit', mass)):(lowest):(0):(0.4) with vectors nohead lt 4 title 'border orbit', \
    '' using (of_kind('multi-sliding', mass)):(lowest):(0):(0.4) with vectors nohead lt 5 title 'multi-sliding', \
    data.'/figure3'.'ab'[mass:mass].'.csv' using 'omega':'v'.mass with points lt mass pt 7 ps 0.2 lw 0.3
}
