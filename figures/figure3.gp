# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency, from rest.
# Grey: where the paper says that the chatter of mass 1 is incomplete (Section 3.2). Bars: where the
# mass sticks. Vertical lines: border orbits and multi-sliding, with their frequencies.
load 'figures/style.gp'
set xlabel 'Ω'
set xrange [0.25:0.7]; set xtics 0.05
set ytics 0.05
set tmargin 2
eval key_beside_heading

bifurcations = data.'/figure3_bifurcations.csv'
of_kind(name, mass) = strcol('kind') eq name && column('mass') == mass ? column('omega') : NaN
label_offset(kind) = kind eq 'border orbit' ? 0.0036 : -0.0034
of_mass(mass) = column('mass') == mass ? column('omega') : NaN
array window_from[2] = [0.3, 0.37]
array window_to[2] = [0.35, 0.4]
step = 0.45 / 1800  # of the frequencies
# What is written in panels (a) and (b), and at which heights.
array bar[2] = [-0.385, 0.385]
array frequencies[2] = [-0.32, 0.28]

eval scenes('figure3')
eval page('figure3', 2, 1)
do for [mass = 1:2] {
  lowest = mass == 1 ? -0.4 : 0
  eval panel('ab'[mass:mass])
  eval heading('from rest,  '.known('r', r[1], '').',  '.stops(1, ''))
  set ylabel sprintf('{/:Italic v}_%d', mass)
  set yrange [lowest:lowest + 0.4]
  set label 2 sprintf('bar: mass %d sticks', mass) at 0.555, bar[mass] center
  set label 3 mass == 1 ? 'grey: its chatter is incomplete, by the paper' : '' at 0.475, -0.3
  plot for [k = 1:2] '+' using (mass == 1 ? window_from[k] : NaN):(-0.4):(window_from[k]):(window_to[k]):(-0.4):(0) every ::::0 \
      with boxxyerror fillcolor rgb '#e4e4e4' fillstyle solid noborder, \
    data.'/figure3_sticking.csv' using (of_mass(mass)):(bar[mass]):(0.5 * step):(0.005) with boxxyerror lt 7 fillstyle solid noborder, \
    bifurcations using (of_kind('border orbit', mass)):(lowest):(0):(0.4) with vectors nohead lt 4 title 'border orbit', \
    '' using (of_kind('multi-sliding', mass)):(lowest):(0):(0.4) with vectors nohead lt 5 title 'multi-sliding', \
    '' using (of_mass(mass) + label_offset(strcol('kind'))):(frequencies[mass]):(sprintf('{/*0.7 %.4f}', column('omega'))) \
      with labels rotate by 90, \
    data.'/figure3'.'ab'[mass:mass].'.csv' using 'omega':'v'.mass with points lt mass pt 7 ps 0.2 lw 0.3
}
