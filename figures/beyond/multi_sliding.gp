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

do for [kind in 'png pdf'] {
  eval canvas(kind, 'multi_sliding', 3)
  set multiplot layout 3,2
  do for [name in 'before at after'] {
    set title title_of(name) offset 0, -0.5
    set xrange [12:17.5]; set xtics 1
    set yrange [-0.2:0.02]; set ytics 0.05
    if (name eq 'at') { set object 1 circle at touch_pos_max_y, 0 radius graph 0.012 fillstyle empty border lc rgb '#c8442c' lw 2 }
    plot 0 lt 3, for [phase = 1:3] data.'/multi_sliding_'.name.'.csv' \
      using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1
    set title 'about the tangency' offset 0, -0.5
    set xrange [13.6:15]; set xtics 0.2
    set yrange [-0.016:0.003]; set ytics 0.004
    if (name eq 'at') { set label 2 sprintf('tangent at t = %.4f', touch_pos_max_y) at 14.3, 0.0014 center }
    if (name eq 'after') { set label 2 'chatter' at 14.4, -0.001 center }
    plot 0 lt 3, for [phase = 1:3] data.'/multi_sliding_'.name.'.csv' \
      using 't':(column('phase') == phase ? column('F2') : NaN) with lines lt 1
    unset label 2
    unset object 1
  }
  unset multiplot
  unset output
}
