# Sticking phases per forcing period against the forcing frequency, followed down and up in small steps
# and, on top, from rest, with the located bifurcation points.
load 'figures/style.gp'

points = data.'/bifurcations.csv'
array way[3] = ['down', 'up', 'rest']
array meaning[3] = ['followed downwards', 'followed upwards', 'from rest']
array colour[3] = ['#e0b050', '#c8442c', '#12355b']
array size[3] = [1.8, 1.1, 0.4]

eval page('bifurcations', 3, 1)
set xlabel 'Ω'
set xrange [0.25:0.5]; set xtics 0.025
set ytics 0, 0.5, 2.5
set ylabel 'sticks per period'
do for [mass = 1:2] {
  eval panel(mass == 1 ? 'a' : 'b')
  set label 2 sprintf('mass %d', mass) at graph 0.1, graph 0.93
  if (mass == 1) {
    # Section 3.2: chatter of mass 1 incomplete.
    set object 1 rectangle from 0.3, graph 0 to 0.35, first 2.6 behind fillcolor rgb '#ececec' fillstyle solid noborder
    set object 2 rectangle from 0.37, graph 0 to 0.4, first 2.6 behind fillcolor rgb '#ececec' fillstyle solid noborder
    set label 3 '{/*0.8 incomplete chatter in the paper}' at 0.35, 2.8 center
    set yrange [-0.2:4.6]  # the key stands above the lines
    set key at graph 0.985, graph 0.96 maxrows 3
  } else {
    set yrange [-0.2:2.6]
    unset key
  }
  plot points using (is_border(mass)):(-0.2):(0):(2.8) with vectors nohead lt 4 title 'border orbit', \
    points using (is_sliding(mass)):(-0.2):(0):(2.8) with vectors nohead lt 5 title 'multi-sliding', \
    for [w = 1:3] data.'/bifurcations_scan.csv' using 'omega':(column(way[w].'_'.mass) / 4) \
      with points pt 7 ps size[w] lc rgb colour[w] title meaning[w]
  unset object 1; unset object 2; unset label 3
}

# Figure 5(b): mass 2 about its grazing; the motions with and without its impact coexist.
eval panel('c')
unset label 2
set xlabel 'Ω - 0.2995 (10^{-5})'
set xrange [1.4:2.2]; set xtics 0.1
set ylabel '{/:Italic v}_2'
set yrange [-0.0002:0.0065]; set ytics 0.001
set key at graph 0.72, graph 0.46 maxrows 5
marked(symbol) = strcol('symbol') eq symbol ? (column('value') - 0.2995) * 1e5 : NaN
plot points using (marked('grazing_mass_2_figure5b')):(0):(0):(0.0065) with vectors nohead lt 4 title 'grazing', \
  points using (marked('impacts_of_mass_2_end_figure5b')):(0):(0):(0.0065) with vectors nohead lt 5 title 'fold', \
  for [w = 1:3] data.'/bifurcations_5b.csv' using ((column('omega') - 0.2995) * 1e5):(column(way[w])) \
    with points pt 7 ps size[w] lc rgb colour[w] title meaning[w]
