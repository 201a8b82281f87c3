# The frequencies that the paper's text does not give: every value of four digits against the printed
# axes and the text. Of the printed axis ends the picture shows the one below the lowest displacement.
load 'figures/style.gp'

table = data.'/inferred_frequencies.csv'
array figure[3] = ['2', '5(a)', '5(b)']
array lowest[3] = ['{/:Italic x}₂ in (b)', 'displacement', 'displacement']
array axis_from[3] = [-0.06, -0.05, -0.4]
array tick[3] = [0.02, 0.05, 0.1]
# A frequency is drawn once in each of these classes that it is in.
array class[4] = ['tried', 'fits every printed axis end', 'and does what the text says', 'drawn in the figure']
array mark[4] = [7, 7, 6, 7]
array size[4] = [0.5, 1.0, 2, 1.6]
array line[4] = [4, 5, 1, 2]
fits(k) = k == 1 || (k == 2 ? column('boxes') == 1 : k == 3 ? column('boxes') * column('text') == 1 : column('drawn') == 1)
in_class(n, k, value) = strcol('figure') eq figure[n] && fits(k) ? value : NaN

eval page('inferred_frequencies', 3, 1)
set xlabel 'Ω'
set xrange [0.1:0.4]; set xtics 0.05
set key at graph 0.99, graph 0.98 samplen 1 spacing 1.1
set tmargin 2
do for [n = 1:3] {
  eval panel('abc'[n:n])
  eval heading('Figure '.figure[n].'.  Band: where the printed axis needs the lowest '.lowest[n])
  set ylabel 'lowest '.lowest[n]
  set yrange [-0.65:0.35]; set ytics 0.2
  set object 1 rectangle from graph 0, first axis_from[n] to graph 1, first axis_from[n] + tick[n] fc rgb '#e9f0ec' fs solid noborder behind
  plot for [k = 1:4] table using (in_class(n, k, column('omega'))):'lowest' \
      with points pt mark[k] ps size[k] lt line[k] title (n == 2 ? class[k] : ''), \
    '' using (in_class(n, 3, column('omega'))):(0.1):(sprintf('{/*0.8 %.4f}', column('omega'))) with labels rotate by 90 left
}
