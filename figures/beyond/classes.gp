# Classes of settled motions, for maps of them: by period, and who sticks.
# The colours of Okabe and Ito, which the colour-blind tell apart, and greys.
array colour[16] = ['#e6e6e6', '#56b4e9', '#009e73', '#f0e442', '#e69f00', '#8c8c8c', '#000000', \
  '#e6e6e6', '#e69f00', '#56b4e9', '#009e73', '#0072b2', '#e6e6e6', '#56b4e9', '#0072b2', '#d55e00']
colours = ''
do for [c = 1:16] { colours = colours.sprintf("%s %d '%s'", c > 1 ? ',' : '', c, colour[c]) }
eval 'set palette defined ('.colours.') maxcolors 16'
set cbrange [0.5:16.5]
unset colorbox
# The period, and what motions without one are: chaotic where the Lyapunov exponent is certainly
# positive.
of_period(p, lambda) = p > 4 ? 5 : p > 0 ? p : lambda > 0 ? 7 : 6
