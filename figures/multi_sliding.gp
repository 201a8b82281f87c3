# The multi-sliding bifurcation: the hold force on mass 1 before, at and after. Left the sticking
# phase; right where the force all but touches, touches, or falls through zero: on a scale that tells
# before from at, and, after, as far as the phase is interrupted.
load 'figures/style.gp'
set xlabel 'Time'
set lmargin 12
set tmargin 2

stats data.'/multi_sliding.csv' using 1 nooutput name 'omega'
# Where the force comes closest to zero inside its phase: at before_pos_max_y, at_pos_max_y.
table(name) = data.'/multi_sliding_'.name.'.csv'
do for [name in 'before at'] {
  stats table(name) using 2:($2 > 13.5 && $2 < 14.8 ? $3 : NaN) nooutput name name
}
title_of(name) = name eq 'before' ? 'before: Ω = 0.256' : \
  name eq 'at' ? sprintf('at: Ω = %.14f', omega_min) : 'after: Ω = 0.2561'
about(name) = name eq 'before' ? sprintf('turns back at %.2f × 10^{-5}', 1e5 * before_max_y) : \
  name eq 'at' ? sprintf('tangent at {/:Italic t} = %.4f', at_pos_max_y) : \
  'released, chatters, sticks again'
letters = 'abcdef'

eval page('multi_sliding', 3, 2)
n = 0
do for [name in 'before at after'] {
  do for [side in 'left right'] {
    n = n + 1
    zoom = side eq 'right' && name ne 'after'
    set title side eq 'left' ? title_of(name) : about(name) offset 0, -0.5
    set label 1 '('.letters[n:n].')' at graph -0.2, graph 1.06
    set ylabel zoom ? '10^5 {/:Italic F}_2' : '{/:Italic F}_2'
    set yrange [-0.2:0.02]; set ytics 0.05
    set xrange [12:17.5]; set xtics 1
    if (side eq 'right') { set xrange [13.6:15]; set xtics 0.4; set yrange [-0.016:0.003]; set ytics 0.004 }
    if (zoom) { set xrange [14.12:14.22]; set xtics 0.02; set yrange [-12:3]; set ytics 3 }
    plot 0 lt 3, for [phase = 1:3] table(name) using \
      't':(column('phase') == phase ? (zoom ? 1e5 : 1) * column('F2') : NaN) with lines lt 1
  }
}
