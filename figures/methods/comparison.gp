# The library beside a stiff spring in place of the stops (a, b) and the plain event-driven scheme
# (c, d), on the scene of Figure 2.
load 'figures/style.gp'
springs = data.'/comparison_springs.csv'
cost = data.'/comparison_cost.csv'
chatter = data.'/comparison_chatter.csv'
thresholds = data.'/comparison_thresholds.csv'

# Rows of one integrator at one tolerance; of them, those whose run broke or did not.
of(stepper, tolerance, y) = strcol('stepper') eq stepper && \
  abs(column('tolerance') / tolerance - 1) < 1e-9 ? column(y) : NaN
broke(stepper, tolerance, y) = strcol('broke') eq '-' ? NaN : of(stepper, tolerance, y)
array steppers[4] = ['dopri5', 'dopri5', 'rosenbrock4', 'rosenbrock4']
label(i) = sprintf('%s, %s', steppers[i], tolerances[i] > 1e-8 ? '10^{-6}' : '10^{-10}')
array tolerances[4] = [1e-6, 1e-10, 1e-6, 1e-10]

at(threshold) = threshold > 0 ? threshold : 1e-14  # no threshold: at the end of the axis
capped(yes) = column('capped') == yes ? column('impacts_per_period') : NaN

set linetype 11 linecolor rgb '#7fa3cc' linewidth 1.4 dashtype solid pointtype 6
set linetype 12 linecolor rgb '#12355b' linewidth 1.4 dashtype solid pointtype 7
set linetype 13 linecolor rgb '#e8a08f' linewidth 1.4 dashtype solid pointtype 4
set linetype 14 linecolor rgb '#c8442c' linewidth 1.4 dashtype solid pointtype 5
set linetype 15 linecolor rgb '#1c7a4a' linewidth 2.0 dashtype solid
set linetype 16 linecolor rgb '#1c7a4a' linewidth 1.4 dashtype (6, 4)
set linetype 17 linecolor rgb '#202020' linewidth 1.2 dashtype (2, 4)
set format y '10^{%L}'
set key opaque

stats chatter using (strcol('scheme') eq 'library' && column('impact') == 60 ? \
                     column('speed') : NaN) nooutput  # through which r^n is drawn

do for [kind in 'png pdf'] {
  eval canvas(kind, 'comparison', 4)
  size = kind eq 'png' ? 0.9 : 0.4
  set multiplot layout 4,1

  eval panel('a')
  set logscale xy
  set format x '10^{%L}'
  set xrange [1e2:1e16]; set xtics 1e2, 100
  set xlabel 'stiffness {/:Italic κ} of the stops'
  set ylabel 'error of the state at {/:Italic t} = 6'
  set yrange [1e-13:1]; set ytics 1e-12, 1000
  set key bottom left maxrows 6
  plot for [i = 1:4] springs using 'kappa':(of(steppers[i], tolerances[i], 'state_error')) \
      with linespoints lt 10 + i ps size title label(i), \
    '' using 'kappa':(of('dopri5', 1e-10, 'time_error')) with points lt 12 pt 6 ps 1.3 * size \
      title 'impact times, dopri5, 10^{-10}', \
    2 / sqrt(x) lt 17 title '∝ {/:Italic κ}^{-1/2}'

  eval panel('b')
  set ylabel 'evaluations in one forcing period'
  set yrange [10:1e9]; set ytics 10, 10
  set key top left maxrows 2
  plot for [i = 1:4] springs using 'kappa':(of(steppers[i], tolerances[i], 'evaluations')) \
      with linespoints lt 10 + i ps size notitle, \
    for [i = 1:4] springs using 'kappa':(broke(steppers[i], tolerances[i], 'evaluations')) \
      with points pt 2 lc rgb '#000000' lw 2 ps 1.6 * size title (i == 1 ? 'breaks' : ''), \
    cost using 'kappa':'plain_evaluations' with lines lt 17 title 'plain scheme: closed forms', \
    '' using 'kappa':'coefficients' with lines lt 16 title 'library: Taylor orders', \
    '' using 'kappa':'expansions' with lines lt 15 title 'library: expansions'

  eval panel('c')
  unset logscale x
  set format x '%g'
  set xrange [0:250]; set xtics 25
  set xlabel 'impact of mass 1'
  set ylabel 'speed'
  set yrange [1e-17:1]; set ytics 1e-16, 100
  set key top right maxrows 3
  plot STATS_max * 0.7**(x - 60) lt 17 title '∝ {/:Italic r}^{/:Italic n}', \
    chatter using (strcol('scheme') eq 'plain' ? column('impact') : NaN):'speed' \
      with points lt 14 ps 0.7 * size title 'plain scheme, no threshold', \
    '' using (strcol('scheme') eq 'library' ? column('impact') : NaN):'speed' \
      with points lt 12 ps 0.7 * size title 'library, limit not taken'

  eval panel('d')
  set logscale x
  set logscale y2
  set format x '10^{%L}'
  set format y2 '10^{%L}'
  set rmargin 12
  set xrange [2e-2:4e-15]; set xtics ('none' 1e-14)
  do for [d = 2:12:2] { set xtics add (sprintf('10^{-%d}', d) 10.0**(-d)) }
  set xlabel 'threshold of speed for sticking'
  set ylabel 'impacts per period (squares)'
  set y2label 'error in time (circles)' offset 1, 0
  set yrange [1:1e10]; set ytics nomirror 1, 100
  set y2range [1e-14:1e6]; set y2tics 1e-14, 10000
  set key top left maxrows 3
  plot thresholds using (at(column('threshold'))):(capped(0)) \
      with linespoints lt 14 ps size title 'plain scheme: impacts', \
    '' using (at(column('threshold'))):(capped(1)) \
      with points pt 2 lc rgb '#000000' lw 2 ps 1.6 * size title 'breaks', \
    '' using (at(column('threshold'))):'library' with lines lt 15 title 'library: impacts', \
    '' using 'threshold':'stick_error' axes x1y2 \
      with linespoints lt 12 ps size title 'plain scheme: sticks', \
    '' using 'threshold':'release_error' axes x1y2 \
      with linespoints lt 11 ps size title 'plain scheme: releases'
  unset y2tics; unset y2label; unset logscale y2
  set rmargin 3

  unset multiplot
  unset output
}
