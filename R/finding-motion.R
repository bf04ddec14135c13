# Dissipation of the time scheme, as fractions of the physical dissipation and of the energy that
# the gear exchanges, above which it counts.
greatest_scheme_loss <- 0.05
greatest_energy_loss <- 0.01

define_finding("numerical dissipation", "tow",
  "The time scheme has removed more than 5 % of the energy that water, ground and dampers have
  removed, and more than 1 % of the energy that the gear exchanges.",
  function(gear, trajectory) {
    lost <- energy_lost(trajectory$energy)[, length(trajectory$time)]
    share <- lost[["scheme"]] / lost[["physical"]]
    if (lost[["scheme"]] <= greatest_energy_loss * lost[["exchanged"]] ||
      share <= greatest_scheme_loss) return(list())
    label <- paste(figures(lost[["scheme"]]), "J")
    list(finding("tow", lost[["scheme"]], label,
      template("the time scheme has removed {energy}, {part} of the energy exchanged: oscillations
        die too early.", energy = label,
        part = percent_text(lost[["scheme"]] / lost[["exchanged"]])),
      template("Use a smaller accuracy of the tow."), field = "tow.accuracy"))
  },
  rank = 3L
)

# Length of adaptive steps (s) below which a finding reports them.
short_time_step <- 1e-3

define_finding("short time steps", "tow",
  "Adaptive steps of a tow were shorter than 1 ms: something moves too fast for its surroundings.",
  function(gear, trajectory) {
    shortest <- trajectory$report$shortest_step
    if (trajectory$method$accuracy == 0 || shortest >= short_time_step) return(list())
    label <- paste(figures(1000 * shortest), "ms")
    list(finding("tow", shortest, label,
      template("its shortest step is {step}, below 1 ms: a part moves or vibrates very fast.",
        step = label),
      template("Check its tensions over time, and use softer ropes or a larger accuracy of the
        tow."), field = "tow.accuracy"))
  },
  rank = 4L
)
