# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency, from rest;
# border orbits and multi-sliding as vertical lines.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05

points = 'reference/bifurcation_points.csv'
at_border(mass) = strcol('symbol')[1:13] eq 'border_mass_'.mass ? column('value') : NaN
at_sliding(mass) = strcol('symbol') eq 'multi_sliding_mass_'.mass ? column('value') : NaN

do for [kind in 'png pdf'] {
  eval canvas(kind, 'figure3', 2)
  size = kind eq 'png' ? 0.2 : 0.06
  set multiplot layout 2,1

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
  set key at graph 0.985, graph 0.2 opaque
  plot points using (at_border(2)):(0.4) with impulses dt solid lw 0.6 lc rgb '#9a9a9a' title 'border orbit', \
    '' using (at_sliding(2)):(0.4) with impulses dt (3, 3) lw 1.2 lc rgb '#0f5f40' title 'multi-sliding', \
    data.'/figure3b.csv' using 'omega':'v2' with points lt 2 pt 7 ps size lw 0.3

  unset multiplot
  unset output
}
