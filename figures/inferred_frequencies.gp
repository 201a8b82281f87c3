# The frequencies that the paper's text does not give, and that of Figure 5(c): for each figure one strip for every condition,
# drawn where the condition holds, and the frequencies that fit, because they meet all of them.
load 'figures/style.gp'

strips = data.'/inferred_frequencies.csv'
fits = data.'/inferred_frequencies_fits.csv'
array figure[4] = ['2', '5(a)', '5(b)', '5(c)']
array conditions[4] = [4, 3, 2, 2]
half = 0.3            # of the height of a strip
least = 0.001         # half the least width at which a strip can be seen
of(n) = strcol('figure') eq figure[n]
# The name of a condition, at its first strip.
named = 0
in_words(text) = text[1:2] eq 'x₂' ? slanted('x_2').text[3:*] : text
name_once(condition) = condition == named ? '' : (named = condition, in_words(strcol('condition')))
# All frequencies that fit, in words.
listed(w) = (list = list.(strlen(list) ? ',  ' : '').sprintf('%g', w), 0)

eval page('inferred_frequencies', 2, 1)
set xrange [0:0.7]; set xtics 0.1
unset ytics
set style fill solid noborder
unset key
top = 0.985; bottom = 0.075; rows = 4 + 3 + 2 + 2 + 4 * 3.2  # strips, and for each figure its fits and heading
unit = (top - bottom) / rows
upper = top
do for [n = 1:4] {
  set lmargin at screen 0.02; set rmargin at screen 0.68
  lower = upper - (conditions[n] + 3.2) * unit
  set tmargin at screen upper - 0.8 * unit; set bmargin at screen lower + 0.2 * unit
  if (n == 4) { set xlabel 'Ω'; set format x '%g' } else { unset xlabel; set format x '' }
  set yrange [conditions[n] + 2.6:0.4]
  unset label
  set label 4 'Figure '.figure[n] at graph 0, graph 1 offset 0, 0.6
  set label 5 'all of them: it fits (dot: drawn)' at graph 1, first conditions[n] + 1.1 offset 0.8, 0 font ',20'
  unset arrow
  do for [known in '0.02 0.2 0.256 0.2561'] {
    set arrow from first known + 0, graph 0.2 to first known + 0, graph 1 nohead lt 3 lw 1.2 front
  }
  if (n == 1) {
    set label 6 '0.2' at 0.2, graph 1 offset 0, 0.6 center font ',18'
    set label 7 '0.256 and 0.2561 (Figure 4)' at 0.25, graph 1 offset 0, 0.6 left font ',18'
  }
  list = ''
  stats [*:*] [*:*] fits using (of(n) ? listed(column('omega')) : NaN) nooutput
  set label 8 list at graph 0.01, first conditions[n] + 2.1 font ',20'
  named = 0
  plot strips using (of(n) ? 0.5 * (column('from') + column('to')) : NaN):'number': \
      (column('from') - least):(column('to') + least):(column('number') - half):(column('number') + half) \
      with boxxyerror lc rgb '#4d8a6c', \
    strips using (of(n) ? 0.7 : NaN):'number':(name_once(column('number'))) with labels left offset 0.8, 0 font ',20', \
    fits using (of(n) ? column('omega') : NaN):(conditions[n] + 1.1):(column('omega') - least):(column('omega') + least): \
      (conditions[n] + 1.1 - half):(conditions[n] + 1.1 + half) with boxxyerror lc rgb '#202020', \
    '' using (of(n) && column('drawn') == 1 ? column('omega') : NaN):(conditions[n] + 1.1) with points pt 7 ps 2.2 lt 2
  upper = lower
}
