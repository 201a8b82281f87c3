# Ten masses, stops on three of them, from rest: impact velocities against the forcing frequency. Bars:
# where the mass sticks.
load 'figures/style.gp'

stops = data.'/long_chain.csv'
eval read(stops, 'mass').read(stops, 'side').read(stops, 'stop')
eval read(stops, 'beta').read(stops, 'restitution').read(stops, 'amplitude')
common = sprintf('from rest,  {/:Italic c} = %g,  {/:Italic r} = %g,  force %g cos Ω{/:Italic t} on mass 1', beta[1], restitution[1], amplitude[1])

step = 0.75 / 400  # of the frequencies
sticks(n, value) = column('mass') == mass[n] ? value : NaN

eval canvas('long_chain', 1.8).'; set multiplot layout 3, 1'
set xrange [0.05:0.8]; set xtics 0.05
set tmargin 1.8
set ytics 0.2
do for [n = 1:3] {
  eval panel('abc'[n:n])
  stats [*:*] [*:*] data.'/long_chain_sticking.csv' using (column('mass') == mass[n]) nooutput
  eval heading(sprintf('mass %d,  %s stop at %s%s', mass[n], side[n] > 0 ? 'upper' : 'lower', number('%g', stop[n]), \
    STATS_sum == 0 ? ',  never sticks' : ''))
  set label 2 n == 1 ? common : '' at graph 1, graph 1 offset 0, 0.9 right
  set xlabel n == 3 ? 'Ω' : ''
  set ylabel sprintf('{/:Italic v}_{%d}', mass[n])
  lowest = side[n] > 0 ? 0 : -0.6
  set yrange [lowest:lowest + 0.6]
  # The bar stands at the edge that is far from the stop.
  bar = side[n] > 0 ? 0.57 : -0.57
  set label 3 n == 2 ? 'bars: the mass sticks' : '' at 0.52, bar
  plot data.'/long_chain_sticking.csv' using (sticks(n, column('omega'))):(bar):(0.6 * step):(0.015) \
      with boxxyerror lt 7 fillstyle solid noborder, \
    data.'/long_chain'.int(mass[n]).'.csv' using 'omega':'v'.int(mass[n]) with points lt (n == 3 ? 5 : n) pt 7 ps 0.3
}
