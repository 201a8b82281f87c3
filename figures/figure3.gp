# Figure 3: impact velocities of mass 1 (a) and mass 2 (b) against the forcing frequency, from rest;
# and the speeds of mass 1 on a logarithmic axis, where the chatter becomes incomplete (c). Grey: where
# the paper says that the chatter of mass 1 is incomplete (Section 3.2). Bars: where the mass sticks.
# Vertical lines: the changes of sticking, by their kinds, with their frequencies.
load 'figures/style.gp'
set xlabel 'Ω'
set tmargin 2
eval key_beside_heading

records = data.'/figure3_records.csv'
impacts = data.'/figure3_impacts.csv'
sticking(mass) = column('sticks'.mass) > 0 ? column('omega') : NaN
impacts_of(mass) = column('mass') == mass ? column('omega') : NaN
# A change of sticking is a key number. Its name begins with that of the kind and the mass.
changes = 'reference/tables/checked_numbers.csv'
array ids[3] = ['border_mass_', 'multi_sliding_mass_', 'jump_mass_']
array kinds[3] = ['border orbit', 'multi-sliding', 'jump']
array line[3] = [4, 5, 6]
array colour[3] = ['#606060', '#0f5f40', '#6a4c93']
array mark[3] = [9, 7, 13]
array size[3] = [1.5, 1.3, 1.8]
is(k, mass) = strcol('id')[1:strlen(ids[k]) + 1] eq ids[k].mass
of_kind(k, mass) = is(k, mass) ? column('value') : NaN
of_mass(mass) = is(1, mass) || is(2, mass) || is(3, mass) ? column('value') : NaN
eval axes('figure3a')
step = (axis_to - axis_from) / 1800  # of the frequencies
# The heights of the bar and of the frequencies in panels (a) and (b). A frequency that is close to
# others of the same mass stands below them.
array bar[2] = [-0.385, 0.385]
array first[2] = [-0.262, 0.365]
array changed[99]; array of[99]; array kind_of[99]
changes_of_all = 0
add_change(k, mass) = (changes_of_all = changes_of_all + 1, changed[changes_of_all] = column('value'), \
  of[changes_of_all] = mass, kind_of[changes_of_all] = k, 0)
do for [mass = 1:2] { do for [k = 1:3] {
  stats [*:*] [*:*] changes using (is(k, mass) ? add_change(k, mass) : 0) nooutput
} }
before(mass, w) = sum [k = 1:changes_of_all] (of[k] == mass && w - changed[k] > 0 && w - changed[k] < 0.004)
# How many changes of a kind a mass has: the key names no kind that the panel does not show.
of_this_kind(k, mass) = sum [n = 1:changes_of_all] (of[n] == mass && kind_of[n] == k)
height(mass) = first[mass] - 0.023 * before(mass, column('value'))
frequency(mass) = sprintf(is(3, mass) ? '{/*0.7 %.6f}' : '{/*0.7 %.4f}', column('value'))
window = "fillcolor rgb '#e4e4e4' fillstyle solid noborder"

eval scenes('figure3')
eval page('figure3', 3, 1)
do for [mass = 1:2] {
  eval panel('ab'[mass:mass])
  eval axes('figure3'.'ab'[mass:mass])
  eval heading('from rest,  '.known('r', r[1], '').',  '.stops(1, ''))
  set ylabel sprintf('{/:Italic v}_%d', mass)
  set label 2 sprintf('bar: mass %d sticks', mass) at 0.555, bar[mass] center
  set label 3 mass == 1 ? "grey: windows in which the paper finds\nthe chatter of mass 1 incomplete" : '' at 0.485, -0.315
  plot for [k = 1:2] '+' using (mass == 1 ? window_from[k] : NaN):(lowest):(window_from[k]):(window_to[k]):(lowest):(highest) every ::::0 \
      with boxxyerror @window, \
    records using (sticking(mass)):(bar[mass]):(0.5 * step):(0.005) with boxxyerror lt 7 fillstyle solid noborder, \
    for [k = 1:3] changes using (of_kind(k, mass)):(lowest):(0):(highest - lowest) with vectors nohead lt line[k], \
    changes using (of_mass(mass) + 0.004):(height(mass)):(frequency(mass)) with labels left, \
    for [k = 1:3] changes using (of_kind(k, mass)):(height(mass)) with points lc rgb colour[k] pt mark[k] ps size[k] title (of_this_kind(k, mass) ? kinds[k] : ''), \
    impacts using (impacts_of(mass)):'velocity' with points lt mass pt 7 ps 0.2 lw 0.3
}

eval panel('c')
eval heading('speeds of mass 1 from 10^{−4} on;  grey: as in (a);  bar: mass 1 sticks')
unset label 2; unset label 3
set ylabel '|{/:Italic v}_1|'
set xrange [0.28:0.42]; set xtics 0.01
set logscale y; set yrange [1e-4:4]; set ytics ('10^{−4}' 1e-4, '10^{−3}' 1e-3, '10^{−2}' 1e-2, '10^{−1}' 1e-1)
array edge[5] = [0.285, 0.3, 0.35, 0.37, 0.4]
do for [k = 1:5] { set label 10 + k '{/*0.8 '.(k == 1 ? 'paper:' : sprintf('%g', edge[k])).'}' at edge[k], 2.2 center front }
set label 16 '{/*0.8 here:}' at 0.285, 0.6 center front
set label 17 "{/*0.75 columns of dots:}\n{/*0.75 long periods}" at 0.3862, 4e-4 center front
plot for [k = 1:2] '+' using (window_from[k]):(1e-4):(window_from[k]):(window_to[k]):(1e-4):(4) every ::::0 \
    with boxxyerror @window, \
  records using (sticking(1)):(1.2e-4):(0.5 * step):(1e-5) with boxxyerror lt 7 fillstyle solid noborder, \
  for [k = 1:3] changes using (of_kind(k, 1)):(1e-4):(0):(4) with vectors nohead lt line[k], \
  impacts using (impacts_of(1)):(-column('velocity')) with points lt 1 pt 7 ps 0.3 lw 0.3, \
  changes using (is(3, 1) ? NaN : of_mass(1)):(0.6):(sprintf('{/*0.8 %.4f}', column('value'))) with labels
