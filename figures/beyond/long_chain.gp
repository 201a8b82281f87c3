# Ten masses, stops on three of them, from rest: impact velocities against the forcing frequency.
load 'figures/style.gp'

eval page('long_chain', 1, 1)
set xlabel 'Ω'
set xrange [0.05:0.8]; set xtics 0.05
set ylabel 'impact velocity'
set key left bottom maxrows 1 samplen 1
array mass[3] = [1, 5, 10]
array line[3] = [1, 2, 5]
plot for [n = 1:3] data.'/long_chain'.mass[n].'.csv' using 'omega':'v'.mass[n] with points lt line[n] pt 7 ps 0.3, \
  for [n = 1:3] NaN with points lt line[n] pt 7 ps 1 title 'mass '.mass[n]
