# Basins of attraction in the plane of the initial displacements, both masses at rest, at four
# frequencies; what the attractors are, from basins_attractors.csv.
load 'figures/style.gp'

attractors = data.'/basins_attractors.csv'
array plane[4] = ['wide', 'many', 'grazing', 'border']
array place[4] = ['stops of Figure 2, Ω = 0.77', 'stops of Figure 2, Ω = 0.625', 'Figure 5(b), Ω = 0.299518', 'stops of Figure 2, Ω = 0.36782295']

# The colours of Okabe and Ito, which the colour-blind tell apart; not settled: black.
array colour[5] = ['#000000', '#56b4e9', '#e69f00', '#009e73', '#f0e442']
set palette defined (0 colour[1], 1 colour[2], 2 colour[3], 3 colour[4], 4 colour[5]) maxcolors 5
set cbrange [-0.5:4.5]
unset colorbox

# A number per forcing period without needless digits.
rate(x) = sprintf('%g', x)
sticks(one, two) = one + two > 0 ? ', sticks '.rate(one).' and '.rate(two) : ''
what(p, i1, i2, s1, s2) = sprintf('period %d: impacts %s and %s%s', p, rate(i1), rate(i2), sticks(s1, s2))
of_plane(name, value) = strcol('plane') eq name ? value : NaN

eval page('basins', 4, 1)
do for [k = 1:4] {
  top = 1.0 - 0.25 * (k - 1); bottom = top - 0.25
  set tmargin at screen top - 0.02; set bmargin at screen bottom + 0.042
  set lmargin at screen 0.09; set rmargin at screen 0.46
  set border; set tics out scale 0.6; set xtics nomirror autofreq; set ytics nomirror autofreq
  set autoscale xy; set autoscale xfix; set autoscale yfix
  set xlabel '{/:Italic x}_1' offset 0, 0.6; set ylabel '{/:Italic x}_2'
  set label 1 '('.'abcd'[k:k].')  '.place[k] at graph 0, graph 1.06
  plot data.'/basins_'.plane[k].'.csv' using 'displacement1':'displacement2':'attractor' with image notitle

  # What the attractors are, beside it.
  unset border; unset tics; unset xlabel; unset ylabel
  set label 1 'per forcing period, masses 1 and 2:' at 0, -0.3 left
  set lmargin at screen 0.5; set rmargin at screen 0.99
  set xrange [0:1]; set yrange [-7.5:0]
  plot attractors using (of_plane(plane[k], 0.02)):(-column('attractor')):'attractor' with points pt 5 ps 3 lc palette notitle, \
    '' using (of_plane(plane[k], 0.06)):(-column('attractor')):(what(column('period'), column('impacts1'), column('impacts2'), column('sticks1'), column('sticks2'))) with labels left notitle
}
