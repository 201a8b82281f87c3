# The multi-sliding bifurcation: the hold force on mass 1 before, at and after. Left the sticking
# phase; right where the force all but touches, touches, or falls through zero: on a scale that tells
# before from at, and, after, as far as the phase is interrupted.
load 'figures/style.gp'
set xlabel 'Time'
set lmargin 12
set tmargin 2

array when[3] = ['before', 'at', 'after']
array omega[3]; array phases[3]; array greatest[3]; array turn[3]
table(n) = data.'/multi_sliding_'.when[n].'.csv'
stats data.'/multi_sliding.csv' using (omega[$0 + 1] = column('omega')) nooutput
do for [n = 1:3] {
  stats table(n) using 'phase' nooutput
  phases[n] = int(STATS_max)
  # Where the force comes closest to zero inside its phase.
  stats table(n) using 2:($2 > 13.5 && $2 < 14.8 ? $3 : NaN) nooutput
  greatest[n] = STATS_max_y
  turn[n] = STATS_pos_max_y
}
title_of(n) = sprintf(n == 2 ? '%s: Ω = %.14f' : '%s: Ω = %g', when[n], omega[n])
about(n) = n == 1 ? sprintf('turns back at %.2f × 10^{-5}', 1e5 * greatest[n]) : \
  n == 2 ? sprintf('tangent at {/:Italic t} = %.4f', turn[n]) : 'released, chatters, sticks again'

eval page('multi_sliding', 3, 2)
do for [panel = 1:6] {
  n = (panel + 1) / 2
  whole = panel % 2  # of the phase
  zoom = !whole && n < 3
  set title whole ? title_of(n) : about(n) offset 0, -0.5
  set label 1 '('.'abcdef'[panel:panel].')' at graph -0.2, graph 1.06
  set ylabel zoom ? '10^5 {/:Italic F}_2' : '{/:Italic F}_2'
  set xrange [12:17.5]; set xtics 1; set yrange [-0.2:0.02]; set ytics 0.05
  if (!whole) { set xrange [13.6:15]; set xtics 0.4; set yrange [-0.016:0.003]; set ytics 0.004 }
  if (zoom) { set xrange [14.12:14.22]; set xtics 0.04; set yrange [-12:3]; set ytics 3 }
  plot 0 lt 3, for [phase = 1:phases[n]] table(n) using \
    't':(column('phase') == phase ? (zoom ? 1e5 : 1) * column('F2') : NaN) with lines lt 1
}
