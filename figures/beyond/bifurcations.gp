# Sticking phases per forcing period against the forcing frequency, from rest and followed up and down
# in small steps (drawn a little apart), with the located bifurcation points.
load 'figures/style.gp'
set key at graph 0.985, graph 0.96 opaque

scan = data.'/bifurcations_scan.csv'
points = data.'/bifurcations.csv'
# Border orbits and multi-sliding of a mass, at the height of their mark.
at_border(mass, height) = strcol('symbol')[1:13] eq 'border_mass_'.mass ? height : NaN
at_sliding(mass, height) = strcol('symbol') eq 'multi_sliding_mass_'.mass ? height : NaN

do for [kind in 'png pdf'] {
  eval canvas(kind, 'bifurcations', 3)
  size = kind eq 'png' ? 0.35 : 0.12
  set multiplot layout 3,1
  set xlabel 'Ω'
  set xrange [0.25:0.5]; set xtics 0.025
  set yrange [-0.2:2.6]; set ytics 0.5
  set ylabel 'sticks per period'
  do for [mass = 1:2] {
    eval panel(mass == 1 ? 'a' : 'b')
    set label 2 sprintf('mass %d', mass) at graph 0.1, graph 0.93
    if (mass == 1) {
      # Section 3.2: chatter of mass 1 incomplete.
      set object 1 rectangle from 0.3, graph 0 to 0.35, graph 1 behind fillcolor rgb '#ececec' fillstyle solid noborder
      set object 2 rectangle from 0.37, graph 0 to 0.4, graph 1 behind fillcolor rgb '#ececec' fillstyle solid noborder
      set label 3 '{/*0.8 incomplete chatter in the paper}' at 0.362, 2.3 center front
      set arrow 1 from 0.34, 2.2 to 0.33, 2.0 front lw 0.6; set arrow 2 from 0.38, 2.2 to 0.385, 2.0 front lw 0.6
    }
    plot points using 'value':(at_border(mass, 2.6)) with impulses dt solid lw 0.6 lc rgb '#9a9a9a' title 'border orbit', \
      points using 'value':(at_border(mass, -0.2)) with impulses dt solid lw 0.6 lc rgb '#9a9a9a', \
      points using 'value':(at_sliding(mass, 2.6)) with impulses dt (3, 3) lw 1.2 lc rgb '#0f5f40' title 'multi-sliding', \
      scan using 'omega':(column('rest_'.mass) / 4) with points pt 7 ps size lc rgb '#12355b' title 'from rest', \
      scan using 'omega':(column('up_'.mass) / 4 + 0.05) with points pt 7 ps size lc rgb '#c8442c' title 'followed upwards', \
      scan using 'omega':(column('down_'.mass) / 4 - 0.05) with points pt 7 ps size lc rgb '#c9952c' title 'followed downwards'
    unset object 1; unset object 2; unset label 3; unset arrow
  }

  # Figure 5(b): mass 2 about its grazing; the motions with and without its impact coexist.
  eval panel('c')
  unset label 2
  set xlabel 'Ω - 0.2995 (10^{-5})'
  set xrange [1.4:2.2]; set xtics 0.1
  set ylabel '{/:Italic v}_2'
  set yrange [-0.0005:0.0065]; set ytics 0.001
  set key at graph 0.72, graph 0.5 noopaque
  marked(symbol) = strcol('symbol') eq symbol ? (column('value') - 0.2995) * 1e5 : NaN
  shift(omega) = (omega - 0.2995) * 1e5
  plot points using (marked('grazing_mass_2_figure5b')):(0.0065) with impulses dt solid lw 0.6 lc rgb '#9a9a9a' title 'grazing', \
    points using (marked('impacts_of_mass_2_end_figure5b')):(0.0065) with impulses dt (3, 3) lw 1.2 lc rgb '#0f5f40' title 'fold', \
    data.'/bifurcations_5b.csv' using (shift(column('omega'))):'rest' with points pt 7 ps size lc rgb '#12355b' title 'from rest', \
    '' using (shift(column('omega'))):(column('up') + 0.0001) with points pt 7 ps size lc rgb '#c8442c' title 'followed upwards', \
    '' using (shift(column('omega'))):(column('down') - 0.0001) with points pt 7 ps size lc rgb '#c9952c' title 'followed downwards'
  unset multiplot
  unset output
}
