# Figure 5: sticking-impact (a), grazing-sticking (b), close to dual sticking (c).
load 'figures/style.gp'
set xlabel 'Time'
set ylabel 'Displacement'
set key at graph 0.97, graph 0.25

eval page('figure5', 3, 1)

eval panel('a')
set xrange [950:964]; set xtics 2
set yrange [-0.05:0.35]; set ytics 0.05
plot 0.3 lt 3, \
  data.'/figure5a.csv' using 't':'x1' with lines lt 1 title 'mass 1', \
  '' using 't':'x2' with lines lt 2 title 'mass 2'

eval panel('b')
set xrange [916:930]
set yrange [-0.4:0.5]; set ytics 0.1
plot 0.3 lt 3, 0.45 lt 3, \
  data.'/figure5b.csv' using 't':'x1' with lines lt 1, '' using 't':'x2' with lines lt 2

eval panel('c')
set xrange [900:1000]; set xtics 20
set yrange [0.2:0.31]; set ytics 0.01
plot 0.3 lt 3, \
  data.'/figure5c.csv' using 't':'x1' with lines lt 1, '' using 't':'x2' with lines lt 2
