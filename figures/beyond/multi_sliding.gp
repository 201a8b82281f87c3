# The multi-sliding bifurcation: the hold force on mass 1 before, at and after; left the sticking
# phase, right the neighbourhood of the tangency.
load 'figures/style.gp'
set xlabel 'Time'
set ylabel '{/:Italic F}_2'
set lmargin 12

stats data.'/multi_sliding.csv' using 1 nooutput name 'omega'
# Where the force at the bifurcation comes closest to zero inside its phase.
stats data.'/multi_sliding_at.csv' using 2:($2 > 13.5 && $2 < 14.8 ? $3 : NaN) nooutput name 'touch'

title_of(name) = name eq 'before' ? 'before: Ω = 0.256' : \
  name eq 'at' ? sprintf('at: Ω = %.15f', omega_min) : 'after: Ω = 0.2561'
set tmargin 2

letters = 'abcdef'

do for [kind in 'png pdf'] {
  eval canvas(kind, 'multi_sliding', 3)
  set multiplot layout 3,2
  n = 0
  do for [name in 'before at after'] {
    n = n + 1
    set label 1 '('.letters[2 * n - 1:2 * n - 1].')' at graph 0.03, graph 0.93
    set title title_of(name) offset 0, -0.5
    set ylabel '{/:Italic F}_2'
    set format y '%g'
    set xrange [12:17.5]; set xtics 1
    set yrange [-0.2:0.02]; set ytics 0.05
    plot 0 lt 3, for [phase = 1:3] data.'/multi_sliding_'.name.'.csv' \
      using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1
    # The greatest force before is -4.5e-5: the zoom is 4e-4 high, but where the phase is split.
    set label 1 '('.letters[2 * n:2 * n].')' at graph 0.03, graph 0.93
    set title (name eq 'after' ? 'about the gap' : 'about the tangency') offset 0, -0.5
    set ylabel '10^{4} {/:Italic F}_2'
    set xrange [touch_pos_max_y - 0.12:touch_pos_max_y + 0.12]; set xtics 0.05
    set yrange [-3:1]; set ytics 1
    if (name eq 'at') { set label 2 sprintf('tangent at t = %.4f', touch_pos_max_y) at graph 0.5, graph 0.88 center }
    if (name eq 'before') { set label 2 'greatest: -0.45' at graph 0.5, graph 0.88 center }
    if (name eq 'after') { set label 2 'let go, and stuck again after a chatter' at graph 0.52, graph 0.3 center; set xrange [13.9:14.9]; set xtics 0.2; set yrange [-160:20]; set ytics 40 }
    plot 0 lt 3, for [phase = 1:3] data.'/multi_sliding_'.name.'.csv' \
      using 't':(column('phase') == phase ? 1e4 * column('F2') : NaN) with lines lt 1
    unset label 2
  }
  unset multiplot
  unset output
}
