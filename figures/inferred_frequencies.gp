# The frequencies that the paper's text does not give: for each figure one strip for every condition,
# drawn where the condition holds, and the frequencies that fit, because they meet all of them.
load 'figures/style.gp'

strips = data.'/inferred_frequencies.csv'
fits = data.'/inferred_frequencies_fits.csv'
array figure[3] = ['2', '5(a)', '5(b)']
array conditions[3] = [4, 3, 2]
half = 0.24           # of the height of a strip
least = 0.00025       # half the least width at which a strip can be seen
of(n) = strcol('figure') eq figure[n]
# The name of a condition, at its first strip.
named = 0
name_once(number) = number == named ? '' : (named = number, strcol('condition'))

eval page('inferred_frequencies', 2, 1)
set xrange [0.1:0.5]; set xtics 0.05
unset ytics
set style fill solid noborder
unset key
top = 0.985; bottom = 0.075; rows = 4 + 3 + 2 + 3 * 2.5  # strips, and for each figure its fits and heading
unit = (top - bottom) / rows
upper = top
do for [n = 1:3] {
  set lmargin at screen 0.03; set rmargin at screen 0.7
  lower = upper - (conditions[n] + 2.5) * unit
  set tmargin at screen upper - 0.55 * unit; set bmargin at screen lower + 0.15 * unit
  if (n == 3) { set xlabel 'Ω'; set format x '%g' } else { unset xlabel; set format x '' }
  set yrange [conditions[n] + 2.1:0.4]
  unset label
  set label 4 'Figure '.figure[n] at graph 0, graph 1 offset 0, 0.6
  set label 5 'all of them: it fits' at graph 1, first conditions[n] + 1.7 offset 0.8, 0 font ',18'
  unset arrow
  do for [known in '0.2 0.256 0.2561'] {
    set arrow from first known + 0, graph 0 to first known + 0, graph 1 nohead lt 3 lw 1.2 front
  }
  if (n == 1) {
    set label 6 '0.2' at 0.2, graph 1 offset 0.5, 0.6 right font ',18'
    set label 7 '0.256, 0.2561 (Figure 4)' at 0.256, graph 1 offset -3.5, 0.6 left font ',18'
  }
  named = 0
  plot strips using (of(n) ? 0.5 * (column('from') + column('to')) : NaN):'number': \
      (column('from') - least):(column('to') + least):(column('number') - half):(column('number') + half) \
      with boxxyerror lc rgb '#8fb3a0', \
    strips using (of(n) ? 0.5 : NaN):'number':(name_once(column('number'))) with labels left offset 0.8, 0 font ',18', \
    fits using (of(n) && column('drawn') == 0 ? column('omega') : NaN):(conditions[n] + 1.7) with points pt 7 ps 1.3 lt 4, \
    '' using (of(n) && column('drawn') == 1 ? column('omega') : NaN):(conditions[n] + 1.7) with points pt 7 ps 1.9 lt 2, \
    '' using (of(n) ? column('omega') : NaN):(conditions[n] + 1.45):(sprintf('%g', column('omega'))) \
      with labels rotate by 90 left font ',15'
  upper = lower
}
