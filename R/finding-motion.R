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
