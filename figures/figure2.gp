# Figure 2: displacement of both masses; stops at s1 = -0.3 and s2 = 0.1.
load 'figures/style.gp'
set xlabel 'Time'
set ylabel 'Displacement'
set key at graph 0.42, graph 0.17

eval page('figure2', 2, 1)

eval panel('a')
set xrange [700:750]; set xtics 5
set yrange [-0.5:0.4]; set ytics 0.1
plot -0.3 lt 3, 0.1 lt 3, \
  data.'/figure2a.csv' using 't':'x1' with lines lt 1 title 'mass 1', \
  '' using 't':'x2' with lines lt 2 title 'mass 2'

eval panel('b')
set xrange [715:722]; set xtics 1
set yrange [-0.06:0.12]; set ytics 0.02
plot 0.1 lt 3, data.'/figure2b.csv' using 't':'x2' with lines lt 2
